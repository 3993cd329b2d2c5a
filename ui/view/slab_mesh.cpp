#include "ui/view/slab_mesh.h"

#include <cmath>

namespace fff::ui {

namespace {

std::int8_t packed(double v)
{
    return static_cast<std::int8_t>(std::lround(127.0 * v));
}

PackedNormal packedNormal(const Vec2 &n, bool flag)
{
    return {packed(n.x()), packed(n.y()), 0, static_cast<std::int8_t>(flag ? 127 : 0)};
}

PackedNormal faceNormal(int side, bool flag)
{
    return {0, 0, static_cast<std::int8_t>(127 * side), static_cast<std::int8_t>(flag ? 127 : 0)};
}

std::array<float, 3> at(const Vec2 &p, int side)
{
    return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(side)};
}

void addFace(SlabMesh &mesh, const Triangulation &triangulation, int side)
{
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Vec2 &p : triangulation.points)
        mesh.vertices.push_back({at(p, side), faceNormal(side, false)});
    for (const auto &t : triangulation.triangles) {
        const Vec2 &a = triangulation.points[t[0]];
        // After rounding to float a sliver may be a line; nothing of it would be seen.
        if (!(cross(triangulation.points[t[1]] - a, triangulation.points[t[2]] - a) > 0.0))
            continue;
        const std::array<int, 3> order =
            side > 0 ? std::array{t[0], t[1], t[2]} : std::array{t[0], t[2], t[1]};
        for (int i : order)
            mesh.triangles.push_back(first + static_cast<std::uint32_t>(i));
    }
}

Polygon withoutRepeats(const Polygon &ring)
{
    Polygon points;
    points.reserve(ring.size());
    for (const Vec2 &p : ring) {
        if (points.empty() || points.back() != p)
            points.push_back(p);
    }
    while (points.size() > 1 && points.back() == points.front())
        points.pop_back();
    return points;
}

/// The walls along one ring. The material lies to its left (outer rings run counter-clockwise,
/// holes clockwise), so the wall of an edge looks to its right.
void addWalls(SlabMesh &mesh, const Polygon &ring)
{
    const Polygon points = withoutRepeats(ring);
    const std::size_t n = points.size();
    if (n < 3)
        return;

    std::vector<Vec2> normals(n); // of the edge from point i to the next
    for (std::size_t i = 0; i < n; ++i)
        normals[i] = -perpendicular(points[(i + 1) % n] - points[i]).normalized();

    std::vector<bool> corner(n);
    for (std::size_t i = 0; i < n; ++i)
        corner[i] = normals[(i + n - 1) % n].dot(normals[i]) < std::cos(kCornerAngle);

    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t next = (i + 1) % n;
        const Vec2 &from = points[i], &to = points[next];
        const Vec2 &own = normals[i], &before = normals[(i + n - 1) % n], &after = normals[next];
        const Vec2 fromNormal = corner[i] ? own : Vec2((own + before).normalized());
        const Vec2 toNormal = corner[next] ? own : Vec2((own + after).normalized());

        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.push_back({at(from, -1), packedNormal(fromNormal, true)});
        mesh.vertices.push_back({at(to, -1), packedNormal(toNormal, true)});
        mesh.vertices.push_back({at(to, 1), packedNormal(toNormal, true)});
        mesh.vertices.push_back({at(from, 1), packedNormal(fromNormal, true)});
        for (std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u})
            mesh.triangles.push_back(first + k);

        mesh.edges.push_back(
            {at(from, 1), at(to, 1), faceNormal(1, true), packedNormal(own, false)});
        mesh.edges.push_back(
            {at(from, -1), at(to, -1), faceNormal(-1, true), packedNormal(own, false)});
        mesh.edges.push_back(
            {at(from, -1), at(from, 1), packedNormal(before, corner[i]), packedNormal(own, false)});
    }
}

} // namespace

SlabMesh buildSlab(std::span<const Region> regions, std::span<const Triangulation> triangulations)
{
    SlabMesh mesh;
    for (const Triangulation &triangulation : triangulations) {
        addFace(mesh, triangulation, 1);
        addFace(mesh, triangulation, -1);
    }
    for (const Region &region : regions) {
        addWalls(mesh, region.outer);
        for (const Polygon &hole : region.holes)
            addWalls(mesh, hole);
    }
    return mesh;
}

} // namespace fff::ui
