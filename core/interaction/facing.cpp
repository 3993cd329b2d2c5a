#include "core/interaction/facing.h"

#include "core/base/tolerances.h"

#include <cmath>
#include <numbers>

namespace fff {

namespace {

/// Cosine of the tilt below which a plane counts as lying, so that it may be seen rolled (45°).
constexpr double kLying = std::numbers::sqrt2 / 2.0;
/// Sine of the angle between a plane and the line of sight below which its sides are as near
/// (0.5°).
constexpr double kSidesAlike = 0.0087;
/// Sine of how far a plane leans that counts as upright (15°).
constexpr double kUpright = 0.26;

Eigen::Quaterniond fromAxes(const Vec3 &up, const Vec3 &backward)
{
    Eigen::Matrix3d axes;
    axes << up.cross(backward), up, backward;
    return Eigen::Quaterniond(axes).normalized();
}

/// The direction in the plane that is most upwards; away from the person for a level plane.
Vec3 uprightIn(const Vec3 &backward)
{
    Vec3 up = Vec3::UnitY() - backward.y() * backward;
    if (up.norm() < kSameDirection)
        up = -Vec3::UnitZ() + backward.z() * backward;
    return up.normalized();
}

} // namespace

bool isFaced(const Vec3 &normal, const Vec3 &towardsEye)
{
    return std::abs(normal.dot(towardsEye)) >= std::cos(kFacedAngle);
}

Eigen::Quaterniond facingOrientation(const Eigen::Quaterniond &current, const Vec3 &normal)
{
    Eigen::Quaterniond best = current;
    double bestTurn = std::numeric_limits<double>::infinity();
    const Vec3 right = current * Vec3::UnitX();
    const double side = right.dot(normal) < 0.0 ? -1.0 : 1.0;
    const double faced = (current * Vec3::UnitZ()).dot(normal);
    for (const Vec3 &backward : {Vec3(side * normal), Vec3(-side * normal)}) {
        const bool isFarther = std::abs(faced) > kSidesAlike && faced * backward.dot(normal) < 0.0;
        const bool isBelow = std::abs(faced) <= kSidesAlike && backward.y() < -kUpright;
        if (isFarther || isBelow)
            continue;
        Vec3 up = uprightIn(backward);
        for (int quarter = 0; quarter < 4; ++quarter, up = backward.cross(up)) {
            const bool isUsable =
                quarter == 0 || (std::abs(backward.y()) > kLying && up.y() > -kSameDirection);
            if (!isUsable)
                continue;
            const Eigen::Quaterniond candidate = fromAxes(up, backward);
            const double turn = current.angularDistance(candidate);
            if (turn < bestTurn - kSameDirection) {
                best = candidate;
                bestTurn = turn;
            }
        }
    }
    return best;
}

} // namespace fff
