#include "core/physics/sparse_field.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <optional>

namespace fff {

namespace {

/// What must stay, in shares of what it may be off: use of both faces, way.
using Told = Eigen::Matrix<double, 5, 1>;

constexpr int kMostRounds = 12;
/// Of the shares that a point's place has in a triangle: just outside is inside.
constexpr double kInside = 1e-9;
/// Twice the area of a triangle over the square of its longest side: flatter ones are not made.
constexpr double kFlattest = 0.02;

class Sparing
{
public:
    Sparing(const StressField &field, const SparseLimits &limits)
        : m_field(field), m_limits(limits), m_triangles(field.triangles),
          m_isGone(field.triangles.size(), 0), m_around(field.points.size()),
          m_off(field.points.size(), 0.0)
    {
        for (std::size_t t = 0; t < m_triangles.size(); ++t)
            for (const int i : m_triangles[t])
                m_around[index(i)].push_back(static_cast<int>(t));
        setTold();
    }

    StressField spared()
    {
        for (int round = 0; round < kMostRounds; ++round) {
            std::size_t taken = 0;
            for (std::size_t i = 0; i < m_around.size(); ++i)
                taken += !m_around[i].empty() && takeOut(static_cast<int>(i)) ? 1 : 0;
            if (taken * 100 < m_around.size())
                break;
        }
        return whatIsLeft();
    }

private:
    static std::size_t index(int i) { return static_cast<std::size_t>(i); }
    const Vec2 &at(int i) const { return m_field.points[index(i)]; }

    void setTold()
    {
        Eigen::Vector3f least = Eigen::Vector3f::Zero(), most = least;
        if (!m_field.moved.empty())
            least = most = m_field.moved.front();
        for (const Eigen::Vector3f &moved : m_field.moved) {
            least = least.cwiseMin(moved);
            most = most.cwiseMax(moved);
        }
        const double way = m_limits.movedShare * static_cast<double>((most - least).norm());
        for (std::size_t i = 0; i < m_field.points.size(); ++i) {
            Told told = Told::Zero();
            for (int face = 0; face < 2; ++face)
                told[face] = std::min(static_cast<double>(m_field.use[index(face)][i]),
                                      SparseLimits::kMostTold) /
                             m_limits.use;
            if (way > 0.0)
                told.tail<3>() = m_field.moved[i].cast<double>() / way;
            m_told.push_back(told);
        }
    }

    /// The ring of points around one, in order; an open one begins and ends on the boundary.
    /// Nothing where more than one fan of triangles meets.
    struct Ring
    {
        std::vector<int> points;
        bool isOpen = false;
    };
    std::optional<Ring> ringOf(int point) const
    {
        const auto &around = m_around[index(point)];
        std::vector<std::pair<int, int>> sides; // opposite ones
        for (const int t : around) {
            const auto &corners = m_triangles[index(t)];
            const std::size_t k = static_cast<std::size_t>(
                std::find(corners.begin(), corners.end(), point) - corners.begin());
            sides.emplace_back(corners[(k + 1) % 3], corners[(k + 2) % 3]);
        }
        // An open ring begins where no side ends.
        int start = sides.front().first;
        Ring ring;
        for (const auto &[from, to] : sides) {
            const int begin = from;
            if (std::none_of(sides.begin(), sides.end(),
                             [begin](const auto &s) { return s.second == begin; })) {
                if (ring.isOpen)
                    return {};
                ring.isOpen = true;
                start = begin;
            }
        }
        int now = start;
        for (std::size_t n = 0; n < sides.size(); ++n) {
            ring.points.push_back(now);
            const int from = now;
            const auto next = std::find_if(sides.begin(), sides.end(),
                                           [from](const auto &s) { return s.first == from; });
            if (next == sides.end())
                return {};
            now = next->second;
            if (now == start && n + 1 < sides.size())
                return {};
        }
        if (ring.isOpen)
            ring.points.push_back(now);
        else if (now != start)
            return {};
        return ring;
    }

    bool isFlat(int a, int b, int c) const
    {
        const Vec2 ab = at(b) - at(a), ac = at(c) - at(a), bc = at(c) - at(b);
        const double longest = std::max({ab.squaredNorm(), ac.squaredNorm(), bc.squaredNorm()});
        return !(ab.x() * ac.y() - ab.y() * ac.x() > kFlattest * longest);
    }

    /// How much is off at the point, in limits, when these three tell of it; nothing where it is
    /// not in them.
    std::optional<double> offIn(int point, int a, int b, int c) const
    {
        const Vec2 ab = at(b) - at(a), ac = at(c) - at(a), ap = at(point) - at(a);
        const double area = ab.x() * ac.y() - ab.y() * ac.x();
        const double u = (ap.x() * ac.y() - ap.y() * ac.x()) / area;
        const double v = (ab.x() * ap.y() - ab.y() * ap.x()) / area;
        if (u < -kInside || v < -kInside || u + v > 1.0 + kInside)
            return {};
        const Told told =
            (1.0 - u - v) * m_told[index(a)] + u * m_told[index(b)] + v * m_told[index(c)];
        return (told - m_told[index(point)]).cwiseAbs().maxCoeff();
    }

    /// The same of one on the boundary, which will be the line between its neighbours there.
    double offOnEdge(int point, int before, int after) const
    {
        const Vec2 way = at(after) - at(before);
        const double square = way.squaredNorm();
        const double share =
            square > 0.0 ? std::clamp(way.dot(at(point) - at(before)) / square, 0.0, 1.0) : 0.0;
        const double away = (at(before) + share * way - at(point)).norm();
        const Told told = (1.0 - share) * m_told[index(before)] + share * m_told[index(after)];
        return std::max((told - m_told[index(point)]).cwiseAbs().maxCoeff(), away / m_limits.edge);
    }

    /// The same where the lines that go cross those that come: between them both tell linearly, so
    /// that nowhere around the point more is off than there or at the point.
    double offAtCrossings(int point, int other, const Ring &ring) const
    {
        double off = 0.0;
        for (const int gone : ring.points)
            for (const int come : ring.points) {
                if (gone == other || come == other || gone == come)
                    continue;
                const Vec2 a = at(gone) - at(point), b = at(come) - at(other);
                const Vec2 between = at(other) - at(point);
                const double area = a.x() * b.y() - a.y() * b.x();
                const double along = (between.x() * b.y() - between.y() * b.x()) / area;
                const double across = (between.x() * a.y() - between.y() * a.x()) / area;
                if (!(along > 0.0 && along < 1.0 && across > 0.0 && across < 1.0))
                    continue; // or they are parallel
                const Told before =
                    (1.0 - along) * m_told[index(point)] + along * m_told[index(gone)];
                const Told after =
                    (1.0 - across) * m_told[index(other)] + across * m_told[index(come)];
                off = std::max(off, (after - before).cwiseAbs().maxCoeff());
            }
        return off;
    }

    /// Whether the two have no other neighbours in common than those of their own triangles.
    bool canMeet(int point, int other, const Ring &ring) const
    {
        int common = 0;
        std::vector<int> seen;
        for (const int t : m_around[index(other)])
            for (const int i : m_triangles[index(t)])
                if (i != point && i != other &&
                    std::find(seen.begin(), seen.end(), i) == seen.end()) {
                    seen.push_back(i);
                    common +=
                        std::find(ring.points.begin(), ring.points.end(), i) != ring.points.end()
                            ? 1
                            : 0;
                }
        return common == (ring.isOpen ? 1 : 2);
    }

    /// How much would be off at the point without it, all its triangles reaching to the other one.
    std::optional<double> offWithout(int point, int other, const Ring &ring) const
    {
        const auto &points = ring.points;
        const std::size_t sides = ring.isOpen ? points.size() - 1 : points.size();
        std::optional<double> off;
        for (std::size_t k = 0; k < sides; ++k) {
            const int from = points[k], to = points[(k + 1) % points.size()];
            if (from == other || to == other)
                continue;
            if (isFlat(other, from, to))
                return {};
            if (!ring.isOpen)
                if (const auto here = offIn(point, other, from, to))
                    off = std::min(off.value_or(*here), *here);
        }
        if (ring.isOpen)
            off = offOnEdge(point, points.front(), points.back());
        return off;
    }

    bool takeOut(int point)
    {
        const double room = 1.0 - m_off[index(point)];
        const auto ring = room > 0.0 ? ringOf(point) : std::nullopt;
        if (!ring)
            return false;
        const auto &points = ring->points;
        int best = -1;
        double least = room;
        const auto consider = [&](int other) {
            auto off = offWithout(point, other, *ring);
            if (!off || *off > least || !canMeet(point, other, *ring))
                return;
            *off = std::max(*off, offAtCrossings(point, other, *ring));
            if (*off <= least) {
                least = *off;
                best = other;
            }
        };
        if (ring->isOpen) {
            // The line beside it is the new boundary: no triangle may be left between.
            if (points.size() < 3 || offOnEdge(point, points.front(), points.back()) > room)
                return false;
            consider(points.front());
            consider(points.back());
        } else {
            for (const int other : points)
                consider(other);
        }
        if (best < 0)
            return false;
        collapse(point, best);
        for (const int i : points)
            m_off[index(i)] = std::max(m_off[index(i)], m_off[index(point)] + least);
        return true;
    }

    void collapse(int point, int onto)
    {
        for (const int t : m_around[index(point)]) {
            auto &corners = m_triangles[index(t)];
            if (std::find(corners.begin(), corners.end(), onto) == corners.end()) {
                std::replace(corners.begin(), corners.end(), point, onto);
                m_around[index(onto)].push_back(t);
                continue;
            }
            m_isGone[index(t)] = 1;
            for (const int i : corners)
                if (i != point)
                    std::erase(m_around[index(i)], t);
        }
        m_around[index(point)].clear();
    }

    StressField whatIsLeft() const
    {
        StressField left;
        left.most = m_field.most;
        std::vector<int> placed(m_around.size(), -1);
        for (std::size_t i = 0; i < m_around.size(); ++i) {
            if (m_around[i].empty())
                continue;
            placed[i] = static_cast<int>(left.points.size());
            left.points.push_back(m_field.points[i]);
            left.moved.push_back(m_field.moved[i]);
            for (std::size_t face = 0; face < 2; ++face)
                left.use[face].push_back(m_field.use[face][i]);
        }
        for (std::size_t t = 0; t < m_triangles.size(); ++t)
            if (!m_isGone[t])
                left.triangles.push_back({placed[index(m_triangles[t][0])],
                                          placed[index(m_triangles[t][1])],
                                          placed[index(m_triangles[t][2])]});
        return left;
    }

    const StressField &m_field;
    SparseLimits m_limits;
    std::vector<std::array<int, 3>> m_triangles;
    std::vector<char> m_isGone;
    std::vector<std::vector<int>> m_around; // triangles of each point; none: it is taken out
    std::vector<double> m_off; // at each point: what may be wrong around it already, in limits
    std::vector<Told> m_told;
};

} // namespace

StressField sparseField(const StressField &field, const SparseLimits &limits)
{
    return Sparing(field, limits).spared();
}

} // namespace fff
