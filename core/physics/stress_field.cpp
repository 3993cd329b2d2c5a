#include "core/physics/stress_field.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

constexpr double kCornerZone = 0.5; // of the thickness: what is said of a corner reaches so far
constexpr double kAround = 2.0;     // of that: what is around it is taken from here on inwards

/// Across the plate, mm: of corners as it is, between two of them the cubic that their slopes make.
std::vector<double> heights(const PlateMesh &mesh, const PlateField &moved)
{
    std::vector<double> all(mesh.points.size(), 0.0);
    for (std::size_t i = 0; i < static_cast<std::size_t>(mesh.corners); ++i)
        all[i] = moved.bending[3 * static_cast<Eigen::Index>(i)];
    const auto slope = [&](int corner, const Vec2 &along) {
        return along.y() * moved.bending[3 * corner + 1] -
               along.x() * moved.bending[3 * corner + 2];
    };
    for (const auto &points : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const int from = points[(k + 1) % 3], to = points[(k + 2) % 3];
            const auto a = static_cast<std::size_t>(from), b = static_cast<std::size_t>(to);
            const Vec2 along = mesh.points[b] - mesh.points[a];
            all[static_cast<std::size_t>(points[3 + k])] =
                0.5 * (all[a] + all[b]) + (slope(from, along) - slope(to, along)) / 8.0;
        }
    }
    return all;
}

/// Of each point the distance from the nearest sharp corner, over the zone's reach.
std::vector<double> distancesFromCorners(const PlateMesh &mesh, double zone)
{
    std::vector<double> distances(mesh.points.size(), kAround);
    for (std::size_t i = 0; i < distances.size(); ++i)
        for (const Vec2 &corner : mesh.sharp)
            distances[i] = std::min(distances[i], (corner - mesh.points[i]).norm() / zone);
    return distances;
}

/// From what the mesh has near a corner to what is known of it.
void settleCorners(const PlateMesh &mesh, double zone, std::span<const double> cornerUses,
                   std::vector<float> &use)
{
    const std::vector<double> nearest = distancesFromCorners(mesh, zone);
    std::vector<float> settled(use.size(), 0.0f);
    for (std::size_t k = 0; k < mesh.sharp.size(); ++k) {
        float around = 0.0f;
        for (std::size_t i = 0; i < use.size(); ++i)
            if (nearest[i] >= 1.0 && (mesh.points[i] - mesh.sharp[k]).norm() < kAround * zone)
                around = std::max(around, use[i]);
        const auto above =
            k < cornerUses.size() ? static_cast<float>(cornerUses[k]) - around : 0.0f;
        for (std::size_t i = 0; i < use.size(); ++i) {
            const double distance = (mesh.points[i] - mesh.sharp[k]).norm() / zone;
            if (distance < 1.0)
                settled[i] = std::max(settled[i], around + static_cast<float>(1.0 - distance) *
                                                               std::max(0.0f, above));
        }
    }
    for (std::size_t i = 0; i < use.size(); ++i)
        if (nearest[i] < 1.0)
            use[i] = settled[i];
}

} // namespace

StressField stressField(const PlateModel &model, std::span<const PlateField> cases, double strength,
                        std::span<const double> cornerUses)
{
    const PlateMesh &mesh = model.mesh();
    const std::size_t count = mesh.points.size();
    StressField field;
    field.points = mesh.points;
    field.triangles.reserve(4 * mesh.triangles.size());
    for (const auto &[a, b, c, ofA, ofB, ofC] : mesh.triangles)
        for (const std::array<int, 3> &part :
             {std::array{a, ofC, ofB}, {ofC, b, ofA}, {ofB, ofA, c}, {ofA, ofB, ofC}})
            field.triangles.push_back(part);
    for (auto &use : field.use)
        use.assign(count, 0.0f);
    field.moved.assign(count, Eigen::Vector3f::Zero());
    for (const PlateField &moved : cases) {
        const PlateStress stress = plateStress(model, moved);
        for (std::size_t i = 0; i < count; ++i) {
            for (const std::size_t face : {0u, 1u}) {
                const PrincipalStress there =
                    principalStress(stress.face(static_cast<int>(i), face == 0 ? 1 : -1));
                const double larger = std::max(std::abs(there.first), std::abs(there.second));
                field.use[face][i] =
                    std::max(field.use[face][i], static_cast<float>(larger / strength));
            }
        }
    }
    for (auto &use : field.use) {
        settleCorners(mesh, kCornerZone * model.material().thickness, cornerUses, use);
        for (const float at : use)
            field.most = std::max(field.most, at);
    }
    if (cases.empty())
        return field;
    const std::vector<double> across = heights(mesh, cases.front());
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2 in = cases.front().membrane.segment<2>(2 * static_cast<Eigen::Index>(i));
        field.moved[i] = Vec3(in.x(), in.y(), across[i]).cast<float>();
    }
    return field;
}

} // namespace fff
