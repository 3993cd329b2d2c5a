// The same equilibrium by other means: forces are the unknowns, the least complementary energy
// among all sets of feet and links that may be at their bounds. For small structures of plates that
// are square to each other; shares nothing with core/physics but the structure.
#pragma once

#include "core/physics/structure.h"

#include <Eigen/Dense>

#include <optional>

namespace fff::test {

struct ForceMethod
{
    Eigen::VectorXd wrenches; // 6 for each link: on a, about its point; N, N·mm
    Eigen::VectorXd feet;     // N, upwards
};

/// Rows: three forces and three moments by the size about its centroid for each member. Columns:
/// six of each link (moments by the size), one of each foot.
inline Eigen::MatrixXd equilibriumMatrix(const Structure &structure)
{
    const auto links = static_cast<int>(structure.links.size());
    const auto feet = static_cast<int>(structure.feet.size());
    const auto members = static_cast<int>(structure.members.size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(6 * members, 6 * links + feet);
    const auto put = [&](int member, int column, const Vec3 &point, const Vec3 &force,
                         const Vec3 &moment) {
        const Vec3 about = moment + (point - structure.members[member].centroid).cross(force);
        matrix.block<3, 1>(6 * member, column) += force;
        matrix.block<3, 1>(6 * member + 3, column) += about / structure.size;
    };
    for (int j = 0; j < links; ++j) {
        const Link &link = structure.links[j];
        for (int k = 0; k < 3; ++k) {
            const Vec3 unit = Vec3::Unit(k);
            put(link.a, 6 * j + k, link.point, unit, Vec3::Zero());
            put(link.b, 6 * j + k, link.point, -unit, Vec3::Zero());
            put(link.a, 6 * j + 3 + k, link.point, Vec3::Zero(), structure.size * unit);
            put(link.b, 6 * j + 3 + k, link.point, Vec3::Zero(), -structure.size * unit);
        }
    }
    for (int k = 0; k < feet; ++k)
        put(structure.feet[k].member, 6 * links + k, structure.feet[k].point, structure.up,
            Vec3::Zero());
    return matrix;
}

inline Eigen::VectorXd appliedForces(const Structure &structure)
{
    Eigen::VectorXd applied = Eigen::VectorXd::Zero(6 * structure.members.size());
    for (std::size_t i = 0; i < structure.members.size(); ++i)
        applied.segment<3>(6 * i) += structure.members[i].mass * structure.gravity;
    for (const MemberLoad &load : structure.loads) {
        const Vec3 arm = load.point - structure.members[load.member].centroid;
        applied.segment<3>(6 * load.member) += load.force;
        applied.segment<3>(6 * load.member + 3) +=
            (arm.cross(load.force) + load.moment) / structure.size;
    }
    return applied;
}

/// Of one link, moments by the size, from section 1.3 written down once more.
inline Eigen::Matrix<double, 6, 6> compliance(const Link &link, double size)
{
    const double pressA = link.modulusA * link.thicknessA, pressB = link.modulusB * link.thicknessB;
    const double walls = link.isTight ? 0.29 : 0.155;
    Eigen::Matrix3d axes;
    axes << link.normalA, link.normalB, link.axis;
    const Vec3 shift(pressB, pressA, 0.5 * std::min(pressA, pressB));
    const Vec3 turn(
        walls * pressA * link.depthA * link.depthA, walls * pressB * link.depthB * link.depthB,
        0.15 * (pressA * link.thicknessA * link.depthB + pressB * link.thicknessB * link.depthA));
    Eigen::Matrix<double, 6, 6> result = Eigen::Matrix<double, 6, 6>::Zero();
    result.topLeftCorner<3, 3>() = axes * shift.cwiseInverse().asDiagonal() * axes.transpose();
    result.bottomRightCorner<3, 3>() =
        size * size * axes * turn.cwiseInverse().asDiagonal() * axes.transpose();
    return result;
}

/// Nothing when no forces are in equilibrium and within their bounds.
inline std::optional<ForceMethod> forceMethod(const Structure &structure, bool areBounded = false)
{
    const Eigen::MatrixXd matrix = equilibriumMatrix(structure);
    const Eigen::VectorXd applied = appliedForces(structure);
    const auto links = static_cast<int>(structure.links.size());
    const auto feet = static_cast<int>(structure.feet.size());
    const int unknowns = 6 * links + feet, rows = static_cast<int>(matrix.rows());
    Eigen::MatrixXd energy = Eigen::MatrixXd::Zero(unknowns, unknowns);
    for (int j = 0; j < links; ++j)
        energy.block<6, 6>(6 * j, 6 * j) = compliance(structure.links[j], structure.size);
    for (int k = 0; k < feet; ++k)
        energy(6 * links + k, 6 * links + k) = 1.0 / structure.feet[k].stiffness;
    energy /= energy.diagonal().maxCoeff();

    const double scale = applied.norm(), slack = 1e-9 * scale;
    double least = std::numeric_limits<double>::infinity();
    std::optional<ForceMethod> best;
    const int bounds = feet + (areBounded ? links : 0);
    for (unsigned atBound = 0; atBound < 1u << bounds; ++atBound) {
        // Feet at their bound carry nothing, links at theirs the grip.
        std::vector<int> bound;
        for (int i = 0; i < bounds; ++i) {
            if (atBound >> i & 1u)
                bound.push_back(i);
        }
        const int count = static_cast<int>(bound.size()), all = unknowns + rows + count;
        Eigen::MatrixXd system = Eigen::MatrixXd::Zero(all, all);
        Eigen::VectorXd right = Eigen::VectorXd::Zero(all);
        system.topLeftCorner(unknowns, unknowns) = energy;
        system.block(unknowns, 0, rows, unknowns) = matrix;
        right.segment(unknowns, rows) = -applied;
        for (int i = 0; i < count; ++i) {
            const int row = unknowns + rows + i;
            if (bound[i] < feet) {
                system(row, 6 * links + bound[i]) = 1.0;
            } else {
                const int j = bound[i] - feet;
                system.block<1, 3>(row, 6 * j) = structure.links[j].axis.transpose();
                right[row] = structure.links[j].grip;
            }
        }
        system.topRightCorner(unknowns, rows + count) =
            system.bottomLeftCorner(rows + count, unknowns).transpose();
        const Eigen::VectorXd x =
            Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(system).solve(right).head(
                unknowns);
        bool isWithin =
            (matrix * x + applied).norm() <= 1e-7 * scale && x.tail(feet).minCoeff() >= -slack;
        for (int j = 0; j < links && areBounded; ++j)
            isWithin = isWithin && structure.links[j].axis.dot(x.segment<3>(6 * j)) <=
                                       structure.links[j].grip + slack;
        const double stored = x.dot(energy * x);
        if (isWithin && stored < least) {
            least = stored;
            best = ForceMethod{x.head(6 * links), x.tail(feet)};
        }
    }
    for (int j = 0; best && j < links; ++j)
        best->wrenches.segment<3>(6 * j + 3) *= structure.size;
    return best;
}

} // namespace fff::test
