#include "core/templates/triangle_mesh.h"

#include <cassert>

namespace fff {

TriangleMesh::TriangleMesh(std::vector<Vec3> positions, std::vector<Triangle> triangles,
                           std::optional<double> unit)
    : m_positions(std::move(positions)), m_triangles(std::move(triangles)), m_unit(unit)
{
    assert(!m_triangles.empty() && "a mesh has a triangle");
    for (const Vec3 &p : m_positions)
        m_bounds.extend(p);
    // About the middle, where little is lost to rounding.
    const Vec3 middle = m_bounds.center();
    Vec3 moment = Vec3::Zero();
    for (const Triangle &triangle : m_triangles) {
        const Vec3 a = m_positions[triangle[0]] - middle;
        const Vec3 b = m_positions[triangle[1]] - middle;
        const Vec3 c = m_positions[triangle[2]] - middle;
        const double twice = (b - a).cross(c - a).norm();
        m_area += 0.5 * twice;
        moment += twice * (a + b + c);
        m_volume += a.dot(b.cross(c)) / 6.0;
    }
    m_centroid = m_area > 0.0 ? Vec3(middle + moment / (6.0 * m_area)) : middle;
}

} // namespace fff
