// What a round tool that follows a path leaves of a part, judged slowly by the two outlines alone:
// shares no code with what makes or judges paths in the product.
#pragma once

#include "core/geometry/boolean.h"

#include <QString>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <set>
#include <unordered_map>

namespace fff::test {

/// Chords of outlines, in buckets of a square each.
class ChordBuckets
{
public:
    struct Chord
    {
        Vec2 a, b;
    };

    ChordBuckets(const CurvedRegion &outline, double chord, double size) : m_size(size)
    {
        rings.push_back(chordsOf(outline.outer, chord));
        for (const Contour &hole : outline.holes)
            rings.push_back(chordsOf(hole, chord));
        for (const Polygon &ring : rings)
            for (std::size_t i = 0; i < ring.size(); ++i)
                chords.push_back({ring[i], ring[(i + 1) % ring.size()]});
        for (std::size_t i = 0; i < chords.size(); ++i)
            forSquares(chords[i], [&](std::int64_t key) { m_buckets[key].push_back(int(i)); });
    }

    /// Distance to the nearest chord, or `most` if none is nearer.
    double distance(const Vec2 &p, double most) const
    {
        double nearest = most;
        forNear(p, p, most, [&](const Chord &c) { nearest = std::min(nearest, off(p, c)); });
        return nearest;
    }
    double distance(const Chord &c, double most) const
    {
        double nearest = most;
        forNear(c.a, c.b, most, [&](const Chord &other) {
            if (turn(c.a, c.b, other.a) * turn(c.a, c.b, other.b) < 0.0 &&
                turn(other.a, other.b, c.a) * turn(other.a, other.b, c.b) < 0.0)
                nearest = 0.0;
            nearest = std::min(
                {nearest, off(c.a, other), off(c.b, other), off(other.a, c), off(other.b, c)});
        });
        return nearest;
    }

    static double turn(const Vec2 &a, const Vec2 &b, const Vec2 &p)
    {
        return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
    }
    static double off(const Vec2 &p, const Chord &c)
    {
        const double x = c.b.x() - c.a.x(), y = c.b.y() - c.a.y();
        const double u = p.x() - c.a.x(), v = p.y() - c.a.y();
        const double t = std::clamp((x * u + y * v) / (x * x + y * y), 0.0, 1.0);
        return std::hypot(u - t * x, v - t * y);
    }
    static Polygon chordsOf(const Contour &contour, double chord)
    {
        Polygon all;
        for (int i = 0; i < contour.segmentCount(); ++i)
            halve(contour.segment(i), chord, 0, all);
        Polygon ring;
        for (const Vec2 &p : all)
            if (ring.empty() || ring.back() != p)
                ring.push_back(p);
        while (ring.size() > 1 && ring.back() == ring.front())
            ring.pop_back();
        return ring;
    }

    std::vector<Polygon> rings;
    std::vector<Chord> chords;

private:
    static void halve(const CubicBezier &c, double chord, int depth, Polygon &out)
    {
        // The handles of a straight curve lie on its chord at a third and two thirds.
        const Vec2 one = c.p1 - (2.0 * c.p0 + c.p3) / 3.0, two = c.p2 - (c.p0 + 2.0 * c.p3) / 3.0;
        if (depth >= 16 || std::max(one.norm(), two.norm()) <= chord) {
            out.push_back(c.p0);
            return;
        }
        const Vec2 a = 0.5 * (c.p0 + c.p1), m = 0.5 * (c.p1 + c.p2), b = 0.5 * (c.p2 + c.p3);
        const Vec2 d = 0.5 * (a + m), e = 0.5 * (m + b), f = 0.5 * (d + e);
        halve({c.p0, a, d, f}, chord, depth + 1, out);
        halve({f, e, b, c.p3}, chord, depth + 1, out);
    }

    std::int64_t square(double x) const
    {
        return static_cast<std::int64_t>(std::floor(x / m_size));
    }
    static std::int64_t key(std::int64_t x, std::int64_t y) { return x * 1000003 + y; }

    template <class Visit>
    void forSquares(const Chord &c, Visit visit) const
    {
        // Along the chord, a strip of squares at a time.
        const auto [x0, x1] = std::minmax({square(c.a.x()), square(c.b.x())});
        for (std::int64_t x = x0; x <= x1; ++x) {
            double t0 = 0.0, t1 = 1.0;
            if (x0 != x1) {
                const double way = c.b.x() - c.a.x();
                t0 = (static_cast<double>(x) * m_size - c.a.x()) / way;
                t1 = (static_cast<double>(x + 1) * m_size - c.a.x()) / way;
            }
            const double from =
                c.a.y() + std::clamp(std::min(t0, t1), 0.0, 1.0) * (c.b.y() - c.a.y());
            const double to =
                c.a.y() + std::clamp(std::max(t0, t1), 0.0, 1.0) * (c.b.y() - c.a.y());
            const auto [y0, y1] =
                std::minmax({square(std::min(from, to) - 1e-9), square(std::max(from, to) + 1e-9)});
            for (std::int64_t y = y0; y <= y1; ++y)
                visit(key(x, y));
        }
    }

    template <class Visit>
    void forNear(const Vec2 &a, const Vec2 &b, double most, Visit visit) const
    {
        const Vec2 low = a.cwiseMin(b).array() - most, high = a.cwiseMax(b).array() + most;
        const std::int64_t wide = square(high.x()) - square(low.x()) + 1,
                           tall = square(high.y()) - square(low.y()) + 1;
        if (wide * tall > static_cast<std::int64_t>(chords.size())) {
            for (const Chord &c : chords)
                if (std::max(c.a.x(), c.b.x()) >= low.x() &&
                    std::min(c.a.x(), c.b.x()) <= high.x() &&
                    std::max(c.a.y(), c.b.y()) >= low.y() && std::min(c.a.y(), c.b.y()) <= high.y())
                    visit(c);
            return;
        }
        for (std::int64_t x = square(low.x()); x <= square(high.x()); ++x) {
            for (std::int64_t y = square(low.y()); y <= square(high.y()); ++y) {
                const auto found = m_buckets.find(key(x, y));
                if (found == m_buckets.end())
                    continue;
                for (const int i : found->second)
                    visit(chords[static_cast<std::size_t>(i)]);
            }
        }
    }

    double m_size;
    std::unordered_map<std::int64_t, std::vector<int>> m_buckets;
};

/// Whether rings touch themselves or each other, in integers of a nanometre: exact.
class CrossingOracle
{
public:
    static QString firstCrossing(const std::vector<Polygon> &rings)
    {
        struct Edge
        {
            Point a, b;
            int ring = 0;
            std::size_t index = 0, count = 0;
        };
        std::vector<Edge> edges;
        for (std::size_t r = 0; r < rings.size(); ++r) {
            std::vector<Point> ring;
            for (const Vec2 &p : rings[r]) {
                const Point q{std::llround(p.x() * 1e6), std::llround(p.y() * 1e6)};
                if (ring.empty() || !(ring.back() == q))
                    ring.push_back(q);
            }
            while (ring.size() > 1 && ring.back() == ring.front())
                ring.pop_back();
            if (ring.size() < 3)
                return QStringLiteral("a ring of %1 points").arg(ring.size());
            for (std::size_t i = 0; i < ring.size(); ++i)
                edges.push_back({ring[i], ring[(i + 1) % ring.size()], int(r), i, ring.size()});
        }
        std::sort(edges.begin(), edges.end(), [](const Edge &a, const Edge &b) {
            return std::min(a.a.x, a.b.x) < std::min(b.a.x, b.b.x);
        });
        std::vector<const Edge *> open;
        for (const Edge &e : edges) {
            const std::int64_t left = std::min(e.a.x, e.b.x);
            std::erase_if(open, [&](const Edge *o) { return std::max(o->a.x, o->b.x) < left; });
            for (const Edge *o : open) {
                if (std::max(o->a.y, o->b.y) < std::min(e.a.y, e.b.y) ||
                    std::min(o->a.y, o->b.y) > std::max(e.a.y, e.b.y))
                    continue;
                const bool follows = o->ring == e.ring && (o->index + 1) % o->count == e.index;
                const bool leads = o->ring == e.ring && (e.index + 1) % e.count == o->index;
                const bool isBad = follows ? runsBack(o->a, o->b, e.b)
                                   : leads ? runsBack(e.a, e.b, o->b)
                                           : touch(e.a, e.b, o->a, o->b);
                if (isBad)
                    return QStringLiteral("a crossing at %1, %2")
                        .arg(double(e.a.x) * 1e-6, 0, 'f', 6)
                        .arg(double(e.a.y) * 1e-6, 0, 'f', 6);
            }
            open.push_back(&e);
        }
        return {};
    }

private:
    __extension__ using Wide = __int128;
    struct Point
    {
        std::int64_t x = 0, y = 0;
        bool operator==(const Point &) const = default;
    };
    static int side(const Point &a, const Point &b, const Point &p)
    {
        const Wide value = Wide(b.x - a.x) * (p.y - a.y) - Wide(b.y - a.y) * (p.x - a.x);
        return value > 0 ? 1 : (value < 0 ? -1 : 0);
    }
    static bool runsBack(const Point &a, const Point &b, const Point &c)
    {
        return side(a, b, c) == 0 &&
               Wide(b.x - a.x) * (c.x - b.x) + Wide(b.y - a.y) * (c.y - b.y) < 0;
    }
    static bool touch(const Point &a, const Point &b, const Point &c, const Point &d)
    {
        return side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0;
    }
};

/// What is wrong with the path as the way of a disc of this radius round the part; empty if
/// nothing is. Distances in mm.
class SweptDiscOracle
{
public:
    static constexpr double kAllowed = 0.005;
    static constexpr double kChord = 0.0002;

    SweptDiscOracle(const CurvedRegion &part, const CurvedRegion &path, double radius)
        : m_part(part, kChord, std::clamp(radius, 0.25, 2.0)),
          m_path(path, kChord, std::clamp(radius, 0.25, 2.0)), m_radius(radius)
    {
    }

    QString verdict() const
    {
        if (const QString crossing = CrossingOracle::firstCrossing(m_path.rings);
            !crossing.isEmpty())
            return crossing;
        if (const QString bite = deepestBite(); !bite.isEmpty())
            return bite;
        if (const QString rest = firstRest(); !rest.isEmpty())
            return rest;
        // The part within the outer ring, and in no hole.
        if (winding(m_part.rings[0][0], m_path.rings[0]) != 1)
            return QStringLiteral("the path does not go round the part");
        for (std::size_t i = 1; i < m_path.rings.size(); ++i)
            if (winding(m_part.rings[0][0], m_path.rings[i]) != 0 || insidePart(m_path.rings[i][0]))
                return QStringLiteral("a ring of the path in the part");
        return {};
    }

private:
    QString deepestBite() const
    {
        const double least = m_radius - kAllowed;
        for (const ChordBuckets::Chord &c : m_path.chords)
            if (least > 0.0 && m_part.distance(c, m_radius) < least)
                return place("%1 from the part at %2, %3", m_part.distance(c, m_radius), c.a);
        return {};
    }

    /// Discs a little larger than the tool that touch the part and enter it nowhere, at samples.
    QString firstRest() const
    {
        const double free = m_radius + 0.0015, step = std::clamp(0.5 * m_radius, 0.03, 0.5);
        const auto isLeft = [&](const Vec2 &p, const Vec2 &normal) {
            return m_path.distance(p, m_radius + 2.0 * kAllowed) > m_radius + kAllowed &&
                   m_part.distance(p + free * normal, free) > free - 1e-6 &&
                   !insidePart(p + free * normal);
        };
        for (const Polygon &ring : m_part.rings) {
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()],
                           &c = ring[(i + 2) % ring.size()];
                const Vec2 u = (b - a).normalized(), v = (c - b).normalized();
                const Vec2 n(u.y(), -u.x()), m(v.y(), -v.x());
                const int count = 1 + static_cast<int>((b - a).norm() / step);
                for (int k = 0; k < count; ++k) {
                    const Vec2 p = a + (k + 0.5) / count * (b - a);
                    if (isLeft(p, n))
                        return place("not touched (%1) at %2, %3",
                                     m_path.distance(p, 10.0 * m_radius), p);
                }
                const double turn = std::atan2(n.x() * m.y() - n.y() * m.x(), n.dot(m));
                if (turn <= 0.05)
                    continue;
                for (int k = 0; k <= 8; ++k) {
                    const double angle = turn * k / 8.0;
                    const Vec2 way(std::cos(angle) * n.x() - std::sin(angle) * n.y(),
                                   std::sin(angle) * n.x() + std::cos(angle) * n.y());
                    if (isLeft(b, way))
                        return place("a corner not touched (%1) at %2, %3",
                                     m_path.distance(b, 10.0 * m_radius), b);
                }
            }
        }
        return {};
    }

    static int winding(const Vec2 &p, const Polygon &ring)
    {
        int count = 0;
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
            const Vec2 &a = ring[j], &b = ring[i];
            if ((a.y() <= p.y()) == (b.y() <= p.y()))
                continue;
            const double side = ChordBuckets::turn(a, b, p);
            if (a.y() <= p.y() && side > 0.0)
                ++count;
            else if (a.y() > p.y() && side < 0.0)
                --count;
        }
        return count;
    }
    bool insidePart(const Vec2 &p) const
    {
        int count = 0;
        for (const Polygon &ring : m_part.rings)
            count += winding(p, ring);
        return count > 0;
    }

    static QString place(const char *text, double number, const Vec2 &at)
    {
        return QString::fromLatin1(text)
            .arg(number, 0, 'f', 5)
            .arg(at.x(), 0, 'f', 4)
            .arg(at.y(), 0, 'f', 4);
    }

    ChordBuckets m_part, m_path;
    double m_radius;
};

} // namespace fff::test
