#include "core/physics/link_stiffness.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

constexpr double kLeastModulus = 1.0;                 // MPa; softer is no sheet
constexpr double kLeastThickness = 0.05;              // mm
constexpr double kTightWalls = 0.29;                  // no unit
constexpr double kOneWall = 0.155;                    // no unit
constexpr double kAboutAxis = 0.15;                   // no unit
constexpr double kSlitBottom = 0.5;                   // no unit
constexpr double kAlongNormal = kPracticallyParallel; // sine, no unit

double atLeast(double value, double least)
{
    return std::isfinite(value) ? std::max(value, least) : least;
}

/// A plate in the other's slit: its own slit's stiffness.
struct SlitWalls
{
    double press = 0.0; // E t, N/mm
    double turn = 0.0;  // about the plate's normal, N·mm/rad
};

SlitWalls slitWalls(double modulus, double thickness, double depth, bool isTight)
{
    const double press = modulus * thickness;
    return {press, (isTight ? kTightWalls : kOneWall) * press * depth * depth};
}

/// With the normal of `own` as an axis: its plate turns about that, and is pressed along it by the
/// other's walls.
LinkStiffness acrossAxis(const Vec3 &normal, const Vec3 &axis, const SlitWalls &own,
                         const SlitWalls &other)
{
    Vec3 first = normal - normal.dot(axis) * axis;
    first = first.norm() > kAlongNormal ? Vec3(first.normalized()) : axis.unitOrthogonal();
    const Vec3 second = axis.cross(first);
    LinkStiffness stiffness = LinkStiffness::Zero();
    stiffness.topLeftCorner<3, 3>() =
        other.press * first * first.transpose() + own.press * second * second.transpose();
    stiffness.bottomRightCorner<3, 3>() =
        own.turn * first * first.transpose() + other.turn * second * second.transpose();
    return stiffness;
}

} // namespace

LinkSprings linkSprings(const Link &link, bool isAxisFree)
{
    const double modulusA = atLeast(link.modulusA, kLeastModulus);
    const double modulusB = atLeast(link.modulusB, kLeastModulus);
    const double thicknessA = atLeast(link.thicknessA, kLeastThickness);
    const double thicknessB = atLeast(link.thicknessB, kLeastThickness);
    double depthA = atLeast(link.depthA, kMinOverlap), depthB = atLeast(link.depthB, kMinOverlap);
    if (link.kind == LinkKind::Slot)
        depthA = depthB = std::max(depthA, depthB);
    const SlitWalls a = slitWalls(modulusA, thicknessA, depthA, link.isTight);
    const SlitWalls b = slitWalls(modulusB, thicknessB, depthB, link.isTight);
    const Vec3 axis = link.axis.normalized();
    LinkSprings springs;
    springs.across =
        0.5 * (acrossAxis(link.normalA, axis, a, b) + acrossAxis(link.normalB, axis, b, a));
    springs.along = kSlitBottom * std::min(a.press, b.press);
    if (!isAxisFree) {
        const double turn = kAboutAxis * (modulusA * thicknessA * thicknessA * depthB +
                                          modulusB * thicknessB * thicknessB * depthA);
        springs.across.bottomRightCorner<3, 3>() += turn * axis * axis.transpose();
    }
    return springs;
}

} // namespace fff
