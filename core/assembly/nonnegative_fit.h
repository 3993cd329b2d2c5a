// The nearest point that a sum of columns, none taken less than zero times, comes to. Internal to
// assembly.
#pragma once

#include <Eigen/Core>

namespace fff {

/// How far from `target` the nearest sum of the columns is, each taken a number of times that is
/// not negative. Off by rounding; farther than the truth where it does not settle.
/// Source  C. Lawson, R. Hanson 1974, Solving Least Squares Problems, 23.3.
double distanceFromCone(const Eigen::MatrixXd &columns, const Eigen::VectorXd &target);
/// From that sum to the target. No column makes an angle of less than 90° with it.
Eigen::VectorXd restBeyondCone(const Eigen::MatrixXd &columns, const Eigen::VectorXd &target);

} // namespace fff
