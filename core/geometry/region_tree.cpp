#include "core/geometry/region_tree.h"

#include "core/geometry/side_of_line.h"

namespace fff {

PolygonTree::PolygonTree(const Polygon &polygon) : m_polygon(&polygon)
{
    if (polygon.empty())
        return;
    const auto runs = [](std::size_t count) { return (count + kRun - 1) / kRun; };
    std::vector<Box2> boxes(runs(polygon.size()));
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        boxes[i / kRun].extend(polygon[i]);
        if (i % kRun == 0)
            boxes[i / kRun].extend(beginOf(i));
    }
    m_levels.push_back(std::move(boxes));
    while (m_levels.back().size() > 1) {
        const std::vector<Box2> &below = m_levels.back();
        std::vector<Box2> level(runs(below.size()));
        for (std::size_t i = 0; i < below.size(); ++i)
            level[i / kRun].extend(below[i]);
        m_levels.push_back(std::move(level));
    }
}

Side PolygonTree::locate(const Vec2 &point) const
{
    // Of the edges that a ray from the point to the right meets, as there.
    bool isInside = false, isOn = false;
    const auto isWanted = [&](const Run &run) {
        if (run.box.contains(point))
            return true;
        // All to the right: it is met an odd number of times where its ends are on different sides.
        if (point.x() < run.box.min.x())
            isInside ^= (run.begin.y() <= point.y()) != (run.end.y() <= point.y());
        return false;
    };
    walk(isWanted, [&](const Vec2 &a, const Vec2 &b) {
        const RayMeeting meeting = rayMeeting(point, a, b);
        isOn = isOn || meeting == RayMeeting::Begins;
        isInside ^= meeting == RayMeeting::Crosses;
    });
    if (isOn)
        return Side::Boundary;
    return isInside ? Side::Inside : Side::Outside;
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
