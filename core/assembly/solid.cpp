#include "core/assembly/solid.h"

#include "core/geometry/convex_hull.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

void setTriangles(Solid &solid, const Triangulation &triangulation)
{
    solid.triangles.reserve(triangulation.triangles.size());
    const auto corner = [&](int i) {
        return solid.frame.toWorld(triangulation.points[static_cast<std::size_t>(i)]);
    };
    for (const auto &t : triangulation.triangles)
        solid.triangles.push_back({corner(t[0]), corner(t[1]), corner(t[2])});
    solid.runs.fill(triangulation.triangles.size(), [&](std::size_t i) {
        Box2 box;
        for (const int k : triangulation.triangles[i])
            box.extend(triangulation.points[static_cast<std::size_t>(k)]);
        return box;
    });
}

} // namespace

Extent Solid::along(const Vec3 &axis) const
{
    Extent extent;
    for (const Vec3 &p : hull) {
        const double x = axis.dot(p);
        extent = {std::min(extent.min, x), std::max(extent.max, x)};
    }
    const double more = half * std::abs(axis.dot(normal));
    return {extent.min - more, extent.max + more};
}

Solid makeSolid(const Triangulation &triangulation, const Frame &frame, double thickness)
{
    Solid solid;
    solid.frame = frame;
    solid.normal = frame.normal();
    solid.half = 0.5 * thickness;
    const Vec3 reach = solid.half * solid.normal;
    for (const Vec2 &p : convexHull(triangulation.points)) {
        solid.hull.push_back(frame.toWorld(p));
        solid.box.extend(Vec3(solid.hull.back() + reach));
        solid.box.extend(Vec3(solid.hull.back() - reach));
    }
    setTriangles(solid, triangulation);
    return solid;
}

Solid cutUp(std::shared_ptr<const Solid> whole, const Triangulation &cells)
{
    Solid solid;
    solid.frame = whole->frame;
    solid.normal = whole->normal;
    solid.half = whole->half;
    solid.hull = whole->hull;
    solid.box = whole->box;
    solid.whole = std::move(whole);
    setTriangles(solid, cells);
    return solid;
}

Solid movedBy(Solid solid, const Vec3 &by)
{
    solid.frame.origin += by;
    for (std::array<Vec3, 3> &triangle : solid.triangles)
        for (Vec3 &corner : triangle)
            corner += by;
    for (Vec3 &p : solid.hull)
        p += by;
    solid.box.min += by;
    solid.box.max += by;
    if (solid.whole)
        solid.whole = std::make_shared<const Solid>(movedBy(*solid.whole, by));
    return solid;
}

} // namespace fff
