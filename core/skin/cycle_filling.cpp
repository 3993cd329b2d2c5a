#include "core/skin/cycle_filling.h"

#include "core/skin/coons_patch.h"
#include "core/skin/skin_measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fff {

namespace {

/// What leads from a side to the centre turns by no more than this (75°, radians).
constexpr double kMostRise = 1.3089969389957472;
constexpr int kInnerChords = 8;

/// The middle of a side, and how the skin goes on from there into the patch.
struct Gate
{
    std::size_t index = 0; // of the side's points
    Vec3 point = Vec3::Zero(), normal = Vec3::UnitY(), way = Vec3::UnitX();
};

Gate gateOf(const SkinCurve &side)
{
    const std::size_t m = side.middle();
    Gate gate{m, side.points[m], side.normals[m], Vec3::UnitX()};
    const Vec3 along = side.points[m + 1] - side.points[m - 1];
    gate.way = gate.normal.cross(along).normalized();
    return gate;
}

struct Centre
{
    Vec3 point = Vec3::Zero(), normal = Vec3::UnitY();
};

/// An arc that leaves a gate rising by an angle over the plane of the centre, and comes in level
/// after the distance a, has risen by a tan(angle / 2).
Centre centreOf(const std::vector<Gate> &gates)
{
    Centre centre;
    Vec3 normals = Vec3::Zero();
    for (const Gate &gate : gates) {
        centre.point += gate.point / static_cast<double>(gates.size());
        normals += gate.normal;
    }
    if (normals.norm() > kSkinNoNormal)
        centre.normal = normals.normalized();
    double rise = 0.0;
    for (const Gate &gate : gates) {
        Vec3 away = gate.point - centre.point;
        const double height = centre.normal.dot(away);
        away -= height * centre.normal;
        const double angle = std::asin(std::clamp(gate.way.dot(centre.normal), -1.0, 1.0));
        rise += height + away.norm() * std::tan(0.5 * std::clamp(angle, -kMostRise, kMostRise));
    }
    centre.point += rise / static_cast<double>(gates.size()) * centre.normal;
    return centre;
}

/// From the middle of a side to the centre, where it comes in level.
SkinCurve innerCurve(GrowingMesh &mesh, const SkinCurve &side, const Gate &gate,
                     const Centre &centre, std::uint32_t vertex)
{
    Vec3 level = centre.point - gate.point;
    level -= centre.normal.dot(level) * centre.normal;
    const Vec3 come = level.norm() > 0.0 ? level.normalized() : gate.way;
    return bridge(mesh, side.vertices[gate.index], gate.way, gate.normal, vertex, come,
                  centre.normal, kInnerChords);
}

/// As many patches as corners, round a centre.
void fillRound(GrowingMesh &mesh, const std::vector<SkinCurve> &sides)
{
    std::vector<Gate> gates;
    for (const SkinCurve &side : sides)
        gates.push_back(gateOf(side));
    const Centre centre = centreOf(gates);
    const std::uint32_t vertex = mesh.add(centre.point);
    std::vector<SkinCurve> inner;
    for (std::size_t i = 0; i < sides.size(); ++i)
        inner.push_back(innerCurve(mesh, sides[i], gates[i], centre, vertex));
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const std::size_t before = (i + sides.size() - 1) % sides.size();
        const SkinCurve &last = sides[before];
        fillPatch(mesh, {sides[i].part(0, gates[i].index), inner[i], inner[before],
                         last.part(gates[before].index, last.points.size() - 1).reversed()});
    }
}

} // namespace

bool isSeenWhole(const std::vector<SkinCurve> &sides)
{
    Vec3 middle = Vec3::Zero(), normals = Vec3::Zero();
    double count = 0.0;
    for (const SkinCurve &side : sides)
        for (std::size_t i = 0; i + 1 < side.points.size(); ++i) {
            middle += side.points[i];
            normals += side.normals[i];
            count += 1.0;
        }
    if (!(normals.norm() > kSkinNoNormal))
        return false;
    middle /= count;
    const Vec3 normal = normals.normalized();
    const Vec3 x = normal.unitOrthogonal(), y = normal.cross(x);
    double turned = 0.0;
    for (const SkinCurve &side : sides)
        for (std::size_t i = 0; i + 1 < side.points.size(); ++i) {
            const Vec3 from = side.points[i] - middle, to = side.points[i + 1] - middle;
            const Vec2 a(x.dot(from), y.dot(from)), b(x.dot(to), y.dot(to));
            const double turn = std::atan2(cross(a, b), a.dot(b));
            if (turn < 0.0 || side.normals[i].dot(normal) <= 0.0)
                return false;
            turned += turn;
        }
    return std::lround(turned / (2.0 * std::numbers::pi)) == 1;
}

void fillCycle(GrowingMesh &mesh, const std::vector<SkinCurve> &sides)
{
    if (sides.size() == 2)
        fillLune(mesh, sides[0], sides[1].reversed());
    else if (sides.size() == 4)
        fillPatch(mesh, {sides[0], sides[1], sides[2].reversed(), sides[3].reversed()});
    else
        fillRound(mesh, sides);
}

} // namespace fff
