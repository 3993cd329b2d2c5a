#include "core/geometry/convex_hull.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>

#include <iterator>

namespace fff {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Vec2 nearestOn(const Vec2 &from, const Vec2 &to, const Vec2 &point)
{
    const Vec2 edge = to - from;
    const double lengthSquared = edge.squaredNorm();
    const double share = lengthSquared > 0.0 ? edge.dot(point - from) / lengthSquared : 0.0;
    return from + std::clamp(share, 0.0, 1.0) * edge;
}

} // namespace

Polygon convexHull(const std::vector<Vec2> &points)
{
    std::vector<Kernel::Point_2> input, hull;
    input.reserve(points.size());
    for (const Vec2 &p : points)
        input.emplace_back(p.x(), p.y());
    CGAL::convex_hull_2(input.begin(), input.end(), std::back_inserter(hull));
    Polygon polygon;
    polygon.reserve(hull.size());
    for (const Kernel::Point_2 &p : hull)
        polygon.emplace_back(p.x(), p.y());
    return polygon;
}

double signedDistance(const Polygon &hull, const Vec2 &point, Vec2 *nearest)
{
    double distance = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0, j = hull.size() - 1; i < hull.size(); j = i++) {
        const Vec2 foot = nearestOn(hull[j], hull[i], point);
        if ((point - foot).norm() < distance) {
            distance = (point - foot).norm();
            if (nearest)
                *nearest = foot;
        }
    }
    switch (hull.size() < 3 ? Side::Outside : locate(point, hull)) {
    case Side::Inside:
        return distance;
    case Side::Boundary:
        return 0.0;
    case Side::Outside:
        return -distance;
    }
    return -distance; // not reached: every side is above
}

} // namespace fff
