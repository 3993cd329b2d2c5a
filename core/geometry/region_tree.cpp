#include "core/geometry/region_tree.h"

#include "core/geometry/side_of_line.h"

#include <cmath>

namespace fff {

PolygonTree::PolygonTree(const Polygon &polygon) : m_polygon(&polygon)
{
    m_edges.fill(polygon.size(), [&](std::size_t edge) {
        Box2 box;
        box.extend(beginOf(edge));
        box.extend(polygon[edge]);
        return box;
    });
}

Side PolygonTree::locate(const Vec2 &point) const
{
    // Of the edges that a ray from the point to the right meets, as there.
    bool isInside = false;
    const auto isWanted = [&](const Box2 &box, std::size_t first, std::size_t end) {
        if (box.contains(point))
            return true;
        // All to the right: it is met an odd number of times where its ends are on different sides.
        if (point.x() < box.min.x())
            isInside ^=
                (beginOf(first).y() <= point.y()) != ((*m_polygon)[end - 1].y() <= point.y());
        return false;
    };
    const bool isOn = m_edges.walk(isWanted, [&](std::size_t edge) {
        const RayMeeting meeting = rayMeeting(point, beginOf(edge), (*m_polygon)[edge]);
        isInside ^= meeting == RayMeeting::Crosses;
        return meeting == RayMeeting::Begins;
    });
    if (isOn)
        return Side::Boundary;
    return isInside ? Side::Inside : Side::Outside;
}

bool PolygonTree::isBeside(const Vec2 &point, const Vec2 &direction, double reach) const
{
    return LineStrip(point, direction, reach).sideOf(m_edges.bounds()) != 0;
}

ThinnedRing PolygonTree::thinned(const Vec2 &point, const Vec2 &direction, double reach) const
{
    constexpr std::size_t kMostly = 32;
    ThinnedRing ring;
    ring.points.reserve(kMostly);
    ring.indices.reserve(kMostly);
    const auto add = [&](std::size_t index) {
        ring.points.push_back((*m_polygon)[index]);
        ring.indices.push_back(static_cast<int>(index));
    };
    const LineStrip strip(point, direction, reach);
    int run = 0;          // the side of the last run; 0 behind an edge that comes near
    bool hasLast = false; // of that run two vertices are there
    const auto isNear = [&](const Box2 &box, std::size_t first, std::size_t end) {
        const int side = strip.sideOf(box);
        if (side == 0)
            return true;
        if (side != run) {
            add(first);
            hasLast = false;
            ++first;
        }
        run = side;
        if (first == end)
            return false;
        if (hasLast) {
            ring.points.pop_back();
            ring.indices.pop_back();
        }
        add(end - 1);
        hasLast = true;
        return false;
    };
    m_edges.walk(isNear, [&](std::size_t edge) {
        add(edge);
        run = 0;
        return false;
    });
    return ring;
}

RegionTree::RegionTree(const Region &region)
{
    m_rings.reserve(1 + region.holes.size());
    m_rings.emplace_back(region.outer);
    for (const Polygon &hole : region.holes)
        m_rings.emplace_back(hole);
}

Side RegionTree::locate(const Vec2 &point) const
{
    bool isInside = false;
    for (const PolygonTree &ring : m_rings) {
        const Side side = ring.locate(point);
        if (side == Side::Boundary)
            return side;
        isInside ^= side == Side::Inside;
    }
    return isInside ? Side::Inside : Side::Outside;
}

} // namespace fff
