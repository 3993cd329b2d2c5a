#include "core/templates/vertex_normals.h"

#include <cmath>

namespace fff {

std::vector<Vec3> vertexNormals(const TriangleMesh &mesh)
{
    const std::vector<Vec3> &positions = mesh.positions();
    std::vector<Vec3> normals(positions.size(), Vec3::Zero());
    for (const Triangle &t : mesh.triangles()) {
        const std::array<Vec3, 3> edges = {positions[t[1]] - positions[t[0]],
                                           positions[t[2]] - positions[t[1]],
                                           positions[t[0]] - positions[t[2]]};
        const Vec3 normal = edges[0].cross(edges[1]);
        const double twice = normal.norm();
        if (!(twice > 0.0))
            continue;
        for (std::size_t i = 0; i < 3; ++i) {
            // The sine at every corner is the same area over two edges.
            const double angle = std::atan2(twice, -edges[i].dot(edges[(i + 2) % 3]));
            normals[t[i]] += angle / twice * normal;
        }
    }
    for (Vec3 &normal : normals)
        normal = normal.stableNormalized();
    return normals;
}

} // namespace fff
