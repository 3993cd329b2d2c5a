#include "core/assembly/webs.h"

#include "core/base/tolerances.h"
#include "core/geometry/region_tree.h"

#include <algorithm>
#include <array>
#include <optional>

namespace fff {

namespace {

/// Of the limit: so far from its mouth a slit's walls are looked at. A contour that slants by 30°
/// is as far from the wall there as the limit.
constexpr double kMouthTaper = 2.0;

struct Segment
{
    Vec2 a, b;
};

struct Nearest2
{
    double distance = std::numeric_limits<double>::infinity();
    Vec2 at = Vec2::Zero(); // in the middle between them

    void keep(double candidate, const Vec2 &p, const Vec2 &q)
    {
        if (candidate < distance) {
            distance = candidate;
            at = 0.5 * (p + q);
        }
    }
};

Vec2 nearestOn(const Segment &s, const Vec2 &p)
{
    const Vec2 way = s.b - s.a;
    const double length = way.squaredNorm();
    return length > 0.0 ? Vec2(s.a + way * std::clamp(way.dot(p - s.a) / length, 0.0, 1.0)) : s.a;
}

double cross(const Vec2 &u, const Vec2 &v)
{
    return u.x() * v.y() - u.y() * v.x();
}

/// Whether they cross well inside; what only touches has an end at distance 0.
bool areCrossing(const Segment &s, const Segment &t)
{
    const Vec2 way = s.b - s.a, other = t.b - t.a;
    return cross(way, t.a - s.a) * cross(way, t.b - s.a) < 0.0 &&
           cross(other, s.a - t.a) * cross(other, s.b - t.a) < 0.0;
}

void keepNearest(const Segment &s, const Segment &t, Nearest2 &nearest)
{
    if (areCrossing(s, t)) {
        nearest.keep(0.0, 0.5 * (s.a + s.b), 0.5 * (t.a + t.b));
        return;
    }
    for (const Vec2 &p : {s.a, s.b}) {
        const Vec2 q = nearestOn(t, p);
        nearest.keep((p - q).norm(), p, q);
    }
    for (const Vec2 &p : {t.a, t.b}) {
        const Vec2 q = nearestOn(s, p);
        nearest.keep((p - q).norm(), p, q);
    }
}

Segment edgeOf(const Polygon &polygon, std::size_t i)
{
    return {polygon[i], polygon[(i + 1) % polygon.size()]};
}

/// Whether a point is within corners that run counter-clockwise.
bool holds(const Polygon &corners, const Vec2 &p)
{
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Segment edge = edgeOf(corners, i);
        if (cross(edge.b - edge.a, p - edge.a) < 0.0)
            return false;
    }
    return true;
}

/// What a slit takes away but for its lead-ins: there it runs out as a slanting contour does.
class Taken
{
public:
    explicit Taken(const Slit &slit) : m_rectangle(slit.outline())
    {
        if (slit.form) {
            SlitForm form = *slit.form;
            form.leadIns = {};
            Slit bare = slit;
            bare.form = std::make_shared<const SlitForm>(form);
            m_outlines = bare.outlines(kCutChord);
        } else {
            m_outlines = {m_rectangle};
        }
        for (const Polygon &outline : m_outlines)
            m_box.extend(bounds(outline));
    }

    /// Counter-clockwise.
    const Polygon &rectangle() const { return m_rectangle; }
    const Box2 &box() const { return m_box; }
    template <class Visit>
    void visitEdges(Visit visit) const
    {
        for (const Polygon &outline : m_outlines)
            for (std::size_t i = 0; i < outline.size(); ++i)
                visit(edgeOf(outline, i));
    }
    bool holdsAnyOf(const Taken &other) const
    {
        return holds(m_rectangle, other.m_rectangle.front());
    }

private:
    Polygon m_rectangle;
    std::vector<Polygon> m_outlines;
    Box2 m_box;
};

/// Cut along one line from one mouth: of planes that all cross in one axis. Nothing is between
/// them.
bool areOneSlit(const Slit &a, const Slit &b)
{
    if (!a.isOpen || !b.isOpen)
        return false;
    const Vec2 way = (a.mouth - a.inner).normalized();
    return way.dot(b.mouth - b.inner) > 0.0 &&
           std::abs(cross(way, b.inner - a.inner)) <= kTouchingDepth &&
           std::abs(cross(way, b.mouth - a.inner)) <= kTouchingDepth;
}

Nearest2 betweenSlits(const Taken &a, const Taken &b)
{
    Nearest2 nearest;
    a.visitEdges([&](const Segment &edge) {
        b.visitEdges([&](const Segment &other) { keepNearest(edge, other, nearest); });
    });
    if (a.holdsAnyOf(b) || b.holdsAnyOf(a))
        nearest.keep(0.0, a.rectangle().front(), b.rectangle().front());
    return nearest;
}

void keepNearestOf(const Polygon &outline, const Segment &other, Nearest2 &nearest)
{
    for (std::size_t i = 0; i < outline.size(); ++i)
        keepNearest(edgeOf(outline, i), other, nearest);
}

Box2 grown(Box2 box, double by)
{
    box.min -= Vec2(by, by);
    box.max += Vec2(by, by);
    return box;
}

/// What of an edge lies behind the line through `from` square to `forwards`; nothing of it may.
std::optional<Segment> behind(Segment edge, const Vec2 &from, const Vec2 &forwards)
{
    const double a = forwards.dot(edge.a - from), b = forwards.dot(edge.b - from);
    if (a > 0.0 && b > 0.0)
        return {};
    if (a > 0.0)
        edge.a += (edge.b - edge.a) * (a / (a - b));
    else if (b > 0.0)
        edge.b += (edge.a - edge.b) * (b / (b - a));
    return edge;
}

/// One section's slits and what they are near to.
class Webs
{
public:
    Webs(const Region &region, const std::vector<Slit> &slits, double limit)
        : m_slits(slits), m_limit(limit), m_contour(region.outer)
    {
        for (const Slit &slit : slits) {
            m_taken.emplace_back(slit);
            m_boxes.push_back(m_taken.back().box());
        }
        for (const Polygon &hole : region.holes) {
            m_holes.emplace_back(hole);
            m_holeBoxes.push_back(bounds(hole));
        }
    }

    std::vector<Web> find()
    {
        addBetweenSlits();
        for (std::size_t i = 0; i < m_slits.size(); ++i) {
            if (m_slits[i].role == SlitRole::Slit) {
                addToHoles(i);
                addToContour(i);
            }
        }
        std::stable_sort(m_found.begin(), m_found.end(),
                         [](const Web &a, const Web &b) { return a.slit < b.slit; });
        return std::move(m_found);
    }

private:
    void add(Web::Between between, const Nearest2 &nearest, std::size_t slit, std::size_t other)
    {
        if (nearest.distance < m_limit)
            m_found.push_back({between, nearest.distance, nearest.at, static_cast<int>(slit),
                               static_cast<int>(other)});
    }
    void addBetweenSlits();
    void addToHoles(std::size_t slit);
    void addToContour(std::size_t slit);
    struct Sides;
    using Lengths = std::array<double, 2>; // of the left wall and the right one, mm
    Lengths wallLengths(std::size_t slit) const;
    static Sides plainSides(const Slit &slit, const Lengths &walls);
    static Sides formedSides(const Slit &slit, const Taken &taken, const Lengths &walls);

    const std::vector<Slit> &m_slits;
    double m_limit;
    std::vector<Taken> m_taken;
    std::vector<Box2> m_boxes, m_holeBoxes;
    PolygonTree m_contour;
    std::vector<PolygonTree> m_holes;
    std::vector<Web> m_found;
};

void Webs::addBetweenSlits()
{
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < m_slits.size(); ++i)
        if (m_slits[i].role == SlitRole::Slit)
            order.push_back(i);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return m_boxes[a].min.x() < m_boxes[b].min.x();
    });
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Box2 reach = grown(m_boxes[order[i]], m_limit);
        for (std::size_t k = i + 1; k < order.size() && m_boxes[order[k]].min.x() < reach.max.x();
             ++k) {
            const auto [first, second] = std::minmax(order[i], order[k]);
            if (!reach.intersects(m_boxes[order[k]]))
                continue;
            const Slit &a = m_slits[first], &b = m_slits[second];
            const Nearest2 nearest = betweenSlits(m_taken[first], m_taken[second]);
            if (nearest.distance > 0.0 || (a.guest != b.guest && !areOneSlit(a, b)))
                add(Web::Between::Slits, nearest, first, second);
        }
    }
}

void Webs::addToHoles(std::size_t slit)
{
    const Box2 reach = grown(m_boxes[slit], m_limit);
    for (std::size_t hole = 0; hole < m_holes.size(); ++hole) {
        if (!reach.intersects(m_holeBoxes[hole]))
            continue;
        Nearest2 nearest, plain; // plain: without what its form adds
        m_holes[hole].visitNear(reach, [&](const Vec2 &a, const Vec2 &b) {
            m_taken[slit].visitEdges([&](const Segment &edge) {
                keepNearest(edge, {a, b}, nearest);
            });
            if (m_slits[slit].form)
                keepNearestOf(m_taken[slit].rectangle(), {a, b}, plain);
        });
        if (nearest.distance > 0.0 || (m_slits[slit].form && plain.distance > 0.0))
            add(Web::Between::SlitAndHole, nearest, slit, hole);
    }
}

/// Those edges of a slit that part it from what stays: its bottom, and its walls as far from the
/// mouth as a contour may slant.
struct Webs::Sides
{
    std::vector<Segment> bottom, walls;
};

/// As far from its mouth as a contour may slant; of a wall that the contour crosses, as far from
/// there. What is left of it deeper in may be thin all the same.
Webs::Lengths Webs::wallLengths(std::size_t index) const
{
    const Slit &slit = m_slits[index];
    const Vec2 along = slit.mouth - slit.inner;
    const double taper = kMouthTaper * m_limit, length = along.norm() - taper - slit.width;
    const Vec2 forwards = along.normalized(), across = perpendicular(forwards);
    Lengths lengths{length, length};
    if (!slit.isOpen || !(length > 0.0))
        return lengths;
    for (std::size_t k = 0; k < 2; ++k) {
        const Vec2 from = slit.inner + (k == 0 ? 0.5 : -0.5) * slit.width * across;
        const Segment wall{from, from + length * forwards};
        m_contour.visitNear(grown(m_boxes[index], m_limit), [&](const Vec2 &a, const Vec2 &b) {
            if (!areCrossing(wall, {a, b}))
                return;
            const double above = across.dot(a - from), below = across.dot(b - from);
            const Vec2 at = a + (b - a) * (above / (above - below));
            lengths[k] = std::min(lengths[k], forwards.dot(at - from) - taper);
        });
    }
    return lengths;
}

/// Of the plain rectangle; a mortise has none.
Webs::Sides Webs::plainSides(const Slit &slit, const Lengths &walls)
{
    const Vec2 forwards = (slit.mouth - slit.inner).normalized();
    const Vec2 half = 0.5 * slit.width * perpendicular(forwards);
    Sides sides;
    sides.bottom.push_back({slit.inner - half, slit.inner + half});
    for (std::size_t k = 0; k < 2; ++k) {
        const Vec2 from = slit.inner + (k == 0 ? half : Vec2(-half));
        if (walls[k] > 0.0)
            sides.walls.push_back({from, from + walls[k] * forwards});
    }
    return sides;
}

/// With what the form adds.
Webs::Sides Webs::formedSides(const Slit &slit, const Taken &taken, const Lengths &walls)
{
    constexpr double kAtBottom = 1e-6; // mm: rounding of an arc that ends there
    const Vec2 forwards = (slit.mouth - slit.inner).normalized();
    const Vec2 across = perpendicular(forwards);
    Sides sides = plainSides(slit, walls);
    taken.visitEdges([&](const Segment &edge) {
        const double a = forwards.dot(edge.a - slit.inner), b = forwards.dot(edge.b - slit.inner);
        const bool isLeft = across.dot(0.5 * (edge.a + edge.b) - slit.inner) > 0.0;
        if (std::max(a, b) <= kAtBottom)
            sides.bottom.push_back(edge);
        else if (std::max(a, b) <= walls[isLeft ? 0 : 1])
            sides.walls.push_back(edge);
    });
    return sides;
}

void Webs::addToContour(std::size_t index)
{
    const Slit &slit = m_slits[index];
    const Taken &taken = m_taken[index];
    const Vec2 forwards = (slit.mouth - slit.inner).normalized();
    const Lengths walls = wallLengths(index);
    const Sides plain = plainSides(slit, walls);
    const Sides sides = slit.form ? formedSides(slit, taken, walls) : plain;
    const auto keep = [&](const Sides &of, const Segment &edge, Nearest2 &nearest) {
        for (const Segment &wall : of.walls)
            keepNearest(wall, edge, nearest);
        if (const auto part = behind(edge, slit.inner, forwards))
            for (const Segment &bottom : of.bottom)
                keepNearest(bottom, *part, nearest);
    };
    Nearest2 nearest, bare; // bare: without what its form adds
    m_contour.visitNear(grown(m_boxes[index], m_limit), [&](const Vec2 &a, const Vec2 &b) {
        const Segment edge{a, b};
        if (!slit.isOpen) {
            taken.visitEdges([&](const Segment &own) { keepNearest(own, edge, nearest); });
            keepNearestOf(taken.rectangle(), edge, bare);
            return;
        }
        keep(sides, edge, nearest);
        if (slit.form)
            keep(plain, edge, bare);
    });
    // At 0 the slit itself runs out there, unless it is only its end that does.
    if (nearest.distance > 0.0 || (slit.form && bare.distance > 0.0))
        add(Web::Between::SlitAndContour, nearest, index, 0);
}

} // namespace

std::vector<Web> thinWebs(const Region &region, const std::vector<Slit> &slits, double limit)
{
    return slits.empty() ? std::vector<Web>() : Webs(region, slits, limit).find();
}

} // namespace fff
