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

/// Of a plate that comes out of the other one along the axis.
LinkSprings slotSprings(const Link &link, const SlitWalls &a, const SlitWalls &b, double length,
                        double thicknessA, double thicknessB, bool isAxisFree)
{
    const Vec3 axis = link.axis.normalized();
    const bool isHostA =
        std::abs(link.normalA.dot(axis)) > std::abs(link.normalB.dot(axis)); // the axis is its way
    const Vec3 &guestNormal = isHostA ? link.normalB : link.normalA;
    const SlitWalls &host = isHostA ? a : b, &guest = isHostA ? b : a;
    const double deep = isHostA ? thicknessA : thicknessB; // mm, of the slot's walls
    Vec3 across = guestNormal - guestNormal.dot(axis) * axis;
    across = across.norm() > kAlongNormal ? Vec3(across.normalized()) : Vec3(axis.unitOrthogonal());
    const Vec3 along = axis.cross(across);
    const double walls = link.isTight ? kTightWalls : kOneWall;
    const auto about = [](const Vec3 &way, double stiffness) {
        return Eigen::Matrix3d(stiffness * way * way.transpose());
    };
    LinkSprings springs;
    springs.across.topLeftCorner<3, 3>() = about(across, host.press) + about(along, guest.press);
    springs.across.bottomRightCorner<3, 3>() = about(across, walls * guest.press * deep * deep) +
                                               about(axis, walls * host.press * length * length);
    if (!isAxisFree)
        springs.across.bottomRightCorner<3, 3>() +=
            about(along, walls * host.press * deep * length);
    springs.along = kSlitBottom * std::min(a.press, b.press);
    return springs;
}

/// Half of what fingers hold with, but for the axis: the other half is another link.
LinkSprings fingerSprings(const Link &link, const SlitWalls &a, const SlitWalls &b, double length)
{
    const double press = std::min(a.press, b.press);
    const Vec3 edge = edgeOf(link);
    const double deep = std::min(atLeast(link.thicknessA, kLeastThickness),
                                 atLeast(link.thicknessB, kLeastThickness));
    LinkSprings springs;
    springs.across.topLeftCorner<3, 3>() = 0.5 * press * edge * edge.transpose();
    springs.across.bottomRightCorner<3, 3>() =
        0.5 * (link.isTight ? kTightWalls : kOneWall) * press * deep * length *
        (Eigen::Matrix3d::Identity() - edge * edge.transpose());
    springs.along = kSlitBottom * press;
    return springs;
}

} // namespace

Vec3 edgeOf(const Link &link)
{
    const Vec3 edge = link.normalA.cross(link.normalB);
    return edge.norm() > kAlongNormal ? Vec3(edge.normalized()) : link.axis.unitOrthogonal();
}

LinkSprings linkSprings(const Link &link, bool isAxisFree)
{
    const double modulusA = atLeast(link.modulusA, kLeastModulus);
    const double modulusB = atLeast(link.modulusB, kLeastModulus);
    const double thicknessA = atLeast(link.thicknessA, kLeastThickness);
    const double thicknessB = atLeast(link.thicknessB, kLeastThickness);
    const double depthA = atLeast(link.depthA, kMinOverlap);
    const double depthB = atLeast(link.depthB, kMinOverlap);
    const SlitWalls a = slitWalls(modulusA, thicknessA, depthA, link.isTight);
    const SlitWalls b = slitWalls(modulusB, thicknessB, depthB, link.isTight);
    if (link.kind == LinkKind::Slot)
        return slotSprings(link, a, b, std::max(depthA, depthB), thicknessA, thicknessB,
                           isAxisFree);
    if (link.kind == LinkKind::Fingers)
        return fingerSprings(link, a, b, std::max(depthA, depthB));
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
