// The least of a quadratic energy under equalities and bounds: what both an elastic structure and
// its unilateral contacts come to.
#pragma once

#include "core/physics/long_work.h"

#include <Eigen/SparseCore>
#include <vector>

namespace fff {

/// A bound of one unknown.
struct EnergyBound
{
    enum class Kind { None, AtLeast, AtMost };

    Kind kind = Kind::None;
    double value = 0.0;
    int follows = -1; // an unknown with a bound: this one is 0 while that one is at its bound
};

/// minimise ½ x'Hx + c'x   subject to   A x + b = 0,   bounds
struct EnergyProblem
{
    Eigen::SparseMatrix<double> energy;    // H, n × n, both halves, positive definite
    Eigen::VectorXd slope;                 // c, n
    Eigen::SparseMatrix<double> equations; // A, m × n; may be of less than full rank
    Eigen::VectorXd constant;              // b, m
    std::vector<EnergyBound> bounds;       // n
};

struct LeastEnergy
{
    Eigen::VectorXd unknowns;    // x
    Eigen::VectorXd multipliers; // q of A'q
    std::vector<bool> isAtBound;
    Eigen::VectorXd residual; // A x + b: 0 but where no x does
    int passes = 0;
    bool isSettled = false; // false: the bounds in force were still changing, or it was stopped
};

/// By an active set: every pass solves with some unknowns at their bounds, then fixes those that
/// break one and frees those that pull away from theirs; all at once to begin with, later the worst
/// alone, then the first (Bland), which cannot cycle. Each solve is one sparse LDL' of the
/// optimality conditions, made quasi-definite by weak springs, and refined until the springs carry
/// nothing; so motions that nothing holds are harmless while nothing drives them.
/// Source  J. Nocedal, S. Wright 2006, Numerical optimization, 16.5; R. Vanderbei 1995, Symmetric
///         quasi-definite matrices; R. Rockafellar 1976, the proximal point algorithm.
LeastEnergy leastEnergy(const EnergyProblem &problem, const LongWork &work = {});

} // namespace fff
