#include "core/assembly/webs.h"

#include "core/geometry/region_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
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

Nearest2 betweenSlits(const Polygon &a, const Polygon &b)
{
    Nearest2 nearest;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t k = 0; k < b.size(); ++k)
            keepNearest(edgeOf(a, i), edgeOf(b, k), nearest);
    if (holds(a, b.front()) || holds(b, a.front()))
        nearest.keep(0.0, a.front(), b.front());
    return nearest;
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
            m_outlines.push_back(slit.outline());
            m_boxes.push_back(bounds(m_outlines.back()));
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
            addToHoles(i);
            addToContour(i);
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

    const std::vector<Slit> &m_slits;
    double m_limit;
    std::vector<Polygon> m_outlines;
    std::vector<Box2> m_boxes, m_holeBoxes;
    PolygonTree m_contour;
    std::vector<PolygonTree> m_holes;
    std::vector<Web> m_found;
};

void Webs::addBetweenSlits()
{
    std::vector<std::size_t> order(m_slits.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
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
            const Nearest2 nearest = betweenSlits(m_outlines[first], m_outlines[second]);
            if (nearest.distance > 0.0 || m_slits[first].guest != m_slits[second].guest)
                add(Web::Between::Slits, nearest, first, second);
        }
    }
}

void Webs::addToHoles(std::size_t slit)
{
    const Box2 reach = grown(m_boxes[slit], m_limit);
    const Polygon &outline = m_outlines[slit];
    for (std::size_t hole = 0; hole < m_holes.size(); ++hole) {
        if (!reach.intersects(m_holeBoxes[hole]))
            continue;
        Nearest2 nearest;
        m_holes[hole].visitNear(reach, [&](const Vec2 &a, const Vec2 &b) {
            for (std::size_t i = 0; i < outline.size(); ++i)
                keepNearest(edgeOf(outline, i), {a, b}, nearest);
        });
        if (nearest.distance > 0.0)
            add(Web::Between::SlitAndHole, nearest, slit, hole);
    }
}

void Webs::addToContour(std::size_t index)
{
    const Slit &slit = m_slits[index];
    const Polygon &outline = m_outlines[index];
    const Vec2 along = slit.mouth - slit.inner;
    const Vec2 forwards = along.normalized(), half = 0.5 * slit.width * perpendicular(forwards);
    // The walls, as far from the mouth as a contour may slant; a mortise has none.
    std::vector<Segment> walls;
    const double length = along.norm() - kMouthTaper * m_limit - slit.width;
    for (const Vec2 &side : {half, Vec2(-half)})
        if (slit.isOpen && length > 0.0)
            walls.push_back({slit.inner + side, slit.inner + side + length * forwards});
    Nearest2 nearest;
    m_contour.visitNear(grown(m_boxes[index], m_limit), [&](const Vec2 &a, const Vec2 &b) {
        const Segment edge{a, b};
        for (std::size_t i = 0; !slit.isOpen && i < outline.size(); ++i)
            keepNearest(edgeOf(outline, i), edge, nearest);
        for (const Segment &wall : walls)
            keepNearest(wall, edge, nearest);
        if (const auto part = behind(edge, slit.inner, forwards); part && slit.isOpen)
            keepNearest({slit.inner - half, slit.inner + half}, *part, nearest);
    });
    if (nearest.distance > 0.0) // else it runs out there
        add(Web::Between::SlitAndContour, nearest, index, 0);
}

} // namespace

std::vector<Web> thinWebs(const Region &region, const std::vector<Slit> &slits, double limit)
{
    return slits.empty() ? std::vector<Web>() : Webs(region, slits, limit).find();
}

} // namespace fff
