#include "core/physics/link_compliance.h"

#include "core/physics/link_stiffness.h"

namespace fff {

namespace {

constexpr double kFree = 1e-6; // of what is not, no unit

} // namespace

Eigen::Matrix3d linkAxes(const Link &link)
{
    const Vec3 axis = link.axis.normalized();
    if (link.kind == LinkKind::Fingers) {
        const Vec3 edge = edgeOf(link);
        Eigen::Matrix3d axes;
        axes << edge, axis.cross(edge), axis;
        return axes;
    }
    const Vec3 first = (link.normalA - axis * axis.dot(link.normalA)).normalized();
    Eigen::Matrix3d axes;
    axes << first, axis.cross(first), axis;
    return axes;
}

Eigen::Matrix<double, 6, 1> linkCompliance(const Link &link)
{
    const LinkSprings springs = linkSprings(link, false);
    const Eigen::Matrix3d axes = linkAxes(link);
    const auto along = [&axes](const Eigen::Matrix3d &stiffness) -> Vec3 {
        return (axes.transpose() * stiffness * axes).diagonal();
    };
    Eigen::Matrix<double, 6, 1> stiffness;
    stiffness << along(springs.across.topLeftCorner<3, 3>()),
        along(springs.across.bottomRightCorner<3, 3>());
    stiffness[2] = springs.along;
    // What is free: so soft that it carries nothing of account.
    stiffness.head<3>() = stiffness.head<3>().cwiseMax(kFree * springs.along);
    stiffness.tail<3>() = stiffness.tail<3>().cwiseMax(kFree * stiffness.tail<3>().maxCoeff());
    return stiffness.cwiseInverse();
}

} // namespace fff
