#include "core/geometry/convex_hull.h"

#include "core/base/tolerances.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <numeric>

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

std::vector<std::size_t> outermost(const std::vector<Vec2> &points)
{
    constexpr std::size_t kFew = 8;
    std::vector<std::size_t> kept;
    if (points.size() <= kFew) {
        kept.resize(points.size());
        std::iota(kept.begin(), kept.end(), std::size_t{0});
        return kept;
    }
    // The farthest ones in eight directions; most others lie within these (S. Akl, G. Toussaint
    // 1978, A fast convex hull algorithm), those of a plate that stands on its edge all do.
    std::array<std::size_t, kFew> far{};
    std::array<double, kFew> reached;
    reached.fill(-std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double x = points[i].x(), y = points[i].y();
        const std::array<double, kFew> along{x, x + y, y, y - x, -x, -x - y, -y, x - y};
        for (std::size_t k = 0; k < kFew; ++k)
            if (along[k] > reached[k]) {
                reached[k] = along[k];
                far[k] = i;
            }
    }
    std::array<Vec2, kFew> edges;
    std::array<double, kFew> slacks{};
    for (std::size_t k = 0; k < kFew; ++k) {
        edges[k] = points[far[(k + 1) % kFew]] - points[far[k]];
        slacks[k] = kClipGrid * edges[k].norm();
    }
    kept.assign(far.begin(), far.end());
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t k = 0; k < kFew; ++k)
            if (cross(edges[k], points[i] - points[far[k]]) < -slacks[k]) {
                kept.push_back(i);
                break;
            }
    std::sort(kept.begin(), kept.end());
    kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
    return kept;
}

Polygon roughHull(const std::vector<Vec2> &points)
{
    std::vector<Vec2> kept;
    for (const std::size_t i : outermost(points))
        kept.push_back(points[i]);
    return convexHull(kept);
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
