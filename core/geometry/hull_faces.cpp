#include "core/geometry/hull_faces.h"

#include "core/geometry/convex_hull.h"

#include <CGAL/Convex_hull_traits_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <utility>

namespace fff {

namespace {

using SpaceKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SpacePoint = SpaceKernel::Point_3;

bool areOnOnePlane(const std::vector<SpacePoint> &points)
{
    const auto end = points.end();
    if (points.empty())
        return true;
    const SpacePoint &a = points.front();
    const auto b = std::find_if(points.begin(), end, [&](const SpacePoint &p) { return p != a; });
    if (b == end)
        return true;
    const auto c =
        std::find_if(b, end, [&](const SpacePoint &p) { return !CGAL::collinear(a, *b, p); });
    return c == end ||
           std::all_of(c, end, [&](const SpacePoint &p) { return CGAL::coplanar(a, *b, *c, p); });
}

/// Each face has its edge from the other side once.
void link(std::vector<HullFaces::Face> &faces)
{
    struct Edge
    {
        std::pair<int, int> ends; // the smaller one first
        int face, side;
    };
    std::vector<Edge> edges;
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (int side = 0; side < 3; ++side) {
            const int from = faces[f].corners[static_cast<std::size_t>(side)],
                      to = faces[f].corners[static_cast<std::size_t>((side + 1) % 3)];
            edges.push_back({std::minmax(from, to), static_cast<int>(f), side});
        }
    std::sort(edges.begin(), edges.end(),
              [](const Edge &a, const Edge &b) { return a.ends < b.ends; });
    const auto across = [&](const Edge &edge) -> int & {
        return faces[static_cast<std::size_t>(edge.face)]
            .across[static_cast<std::size_t>(edge.side)];
    };
    for (std::size_t i = 0; i + 1 < edges.size(); i += 2) {
        across(edges[i]) = edges[i + 1].face;
        across(edges[i + 1]) = edges[i].face;
    }
}

/// Leaves out what is inside of others at its height: of the many feet of something that stands a
/// few are left, and the hull in space is the same.
std::vector<Vec3> outermostOfEachHeight(std::vector<Vec3> points)
{
    std::sort(points.begin(), points.end(),
              [](const Vec3 &a, const Vec3 &b) { return a.y() < b.y(); });
    std::vector<Vec3> outer;
    std::vector<Vec2> level;
    for (std::size_t i = 0; i < points.size(); ++i) {
        level.emplace_back(points[i].x(), points[i].z());
        if (i + 1 < points.size() && points[i + 1].y() == points[i].y())
            continue;
        for (const Vec2 &corner : convexHull(level))
            outer.emplace_back(corner.x(), points[i].y(), corner.y());
        level.clear();
    }
    return outer;
}

} // namespace

HullFaces hullFaces(const std::vector<Vec3> &points)
{
    std::vector<SpacePoint> input, corners;
    const std::vector<Vec3> outer = outermostOfEachHeight(points);
    input.reserve(outer.size());
    for (const Vec3 &p : outer)
        input.emplace_back(p.x(), p.y(), p.z());
    HullFaces hull;
    if (areOnOnePlane(input))
        return hull;
    std::vector<std::array<int, 3>> triangles;
    // With traits of planes by three points: exact, unlike planes by four numbers.
    CGAL::convex_hull_3<std::vector<SpacePoint>::iterator, void>(
        input.begin(), input.end(), corners, triangles, CGAL::Convex_hull_traits_3<SpaceKernel>());
    for (const SpacePoint &p : corners)
        hull.points.emplace_back(p.x(), p.y(), p.z());
    for (const std::array<int, 3> &triangle : triangles)
        hull.faces.push_back({triangle, {}});
    link(hull.faces);
    return hull;
}

} // namespace fff
