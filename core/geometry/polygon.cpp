#include "core/geometry/polygon.h"

#include "core/geometry/segment_distance.h"
#include "core/geometry/side_of_line.h"

#include <cmath>
#include <limits>

namespace fff {

double signedArea(const Polygon &polygon)
{
    if (polygon.empty())
        return 0.0;
    // About the first point, so that a small polygon far from the origin loses no digits.
    const Vec2 base = polygon.front();
    double sum = 0.0;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++)
        sum += cross(polygon[j] - base, polygon[i] - base);
    return 0.5 * sum;
}

double area(const Region &region)
{
    double result = std::abs(signedArea(region.outer));
    for (const Polygon &hole : region.holes)
        result -= std::abs(signedArea(hole));
    return result;
}

Box2 bounds(const Polygon &polygon)
{
    // Two chains of comparisons, neither of which waits for the other.
    Box2 box, other;
    std::size_t i = 0;
    for (; i + 1 < polygon.size(); i += 2) {
        box.extend(polygon[i]);
        other.extend(polygon[i + 1]);
    }
    if (i < polygon.size())
        box.extend(polygon[i]);
    box.extend(other);
    return box;
}

Side locate(const Vec2 &point, const Polygon &polygon)
{
    bool inside = false;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const RayMeeting meeting = rayMeeting(point, polygon[j], polygon[i]);
        if (meeting == RayMeeting::Begins)
            return Side::Boundary;
        inside ^= meeting == RayMeeting::Crosses;
    }
    return inside ? Side::Inside : Side::Outside;
}

Side locate(const Vec2 &point, const Region &region)
{
    const Side outer = locate(point, region.outer);
    if (outer != Side::Inside)
        return outer;
    for (const Polygon &hole : region.holes) {
        switch (locate(point, hole)) {
        case Side::Inside:
            return Side::Outside;
        case Side::Boundary:
            return Side::Boundary;
        case Side::Outside:
            break;
        }
    }
    return Side::Inside;
}

namespace {

double distanceToBoundary(const Vec2 &point, const Polygon &polygon)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++)
        nearest = std::min(nearest, distanceToSegment(point, polygon[j], polygon[i]));
    return nearest;
}

} // namespace

double distanceTo(const Vec2 &point, const Region &region)
{
    if (locate(point, region) != Side::Outside)
        return 0.0;
    double nearest = distanceToBoundary(point, region.outer);
    for (const Polygon &hole : region.holes)
        nearest = std::min(nearest, distanceToBoundary(point, hole));
    return nearest;
}

} // namespace fff
