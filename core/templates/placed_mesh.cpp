#include "core/templates/placed_mesh.h"

namespace fff {

TriangleMeshPointer placedMesh(const TriangleMesh &mesh, double size)
{
    const double scale = mesh.size() > 0.0 ? size / mesh.size() : 1.0;
    const Vec3 middle = mesh.bounds().center();
    const Vec3 foot(middle.x(), mesh.bounds().min.y(), middle.z());
    std::vector<Vec3> positions = mesh.positions();
    for (Vec3 &p : positions)
        p = scale * (p - foot);
    return std::make_shared<TriangleMesh>(std::move(positions), mesh.triangles(), 1.0);
}

} // namespace fff
