#include "core/templates/magnetic_cut.h"

#include <cassert>
#include <cmath>

namespace fff {

double magneticWeight(double distance)
{
    if (distance <= kFirmReach)
        return 1.0;
    if (!(distance < 1.0))
        return 0.0;
    const double left = (1.0 - distance) / (1.0 - kFirmReach);
    return left * left * (3.0 - 2.0 * left);
}

TriangleMeshPointer magneticCut(const TriangleMesh &mesh, std::span<const Vec3> normals,
                                std::span<const MagneticPlane> planes)
{
    assert(normals.size() == mesh.positions().size() && "a normal a vertex");
    std::vector<Vec3> positions = mesh.positions();
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const Vec3 &p = mesh.positions()[i];
        Vec3 way = Vec3::Zero();
        double weights = 0.0;
        for (const MagneticPlane &magnet : planes) {
            const double height = magnet.plane.height(p);
            const double weight = magneticWeight(std::abs(height) / magnet.reach);
            if (weight == 0.0)
                continue;
            const Vec3 &normal = magnet.plane.normal;
            const double by = normals[i].dot(normal) * magnet.reach - height;
            // The way of one plane is w times `by`; the mean of them counts each by its w.
            way += weight * weight * by * normal;
            weights += weight;
        }
        if (weights > 0.0)
            positions[i] += way / weights;
    }
    return std::make_shared<TriangleMesh>(std::move(positions), mesh.triangles(), mesh.unit());
}

} // namespace fff
