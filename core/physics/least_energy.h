// The least of a quadratic energy under equalities and bounds: what both an elastic structure and
// its unilateral contacts come to.
#pragma once

#include "core/base/long_work.h"
#include "core/physics/frontal_factors.h"

#include <Eigen/Core>
#include <utility>
#include <vector>

namespace fff {

/// Unknowns in blocks that give together, and must be in equilibrium.
struct EnergyPiece
{
    std::vector<int> blocks;   // none twice
    Eigen::MatrixXd energy;    // of their unknowns in this order; lower half
    Eigen::MatrixXd equations; // rows × their unknowns; may be of less than full rank
    Eigen::VectorXd constant;  // of each row
};

/// A bound of some sum of the unknowns of a block.
struct EnergyBound
{
    enum class Kind { AtLeast, AtMost };

    Kind kind = Kind::AtLeast;
    int block = 0;
    Eigen::VectorXd direction; // the sum: of the block's unknowns, so much
    double value = 0.0;
    bool isLoose = false; // while it is at its bound, all unknowns of the block are 0
};

/// minimise ½ x'Hx + c'x   subject to   A x + b = 0,   bounds
/// H: own and the pieces' energies, positive definite; A, b: the pieces' equations
struct EnergyProblem
{
    std::vector<int> sizes;           // of the blocks of x
    std::vector<Eigen::MatrixXd> own; // of each block, its part of H besides the pieces
    Eigen::VectorXd slope;            // c
    std::vector<EnergyPiece> pieces;
    std::vector<EnergyBound> bounds;
    double leastForce = 0.0; // unknowns that are small beside this are nothing
};

struct LeastEnergy
{
    Eigen::VectorXd unknowns;    // x
    std::vector<bool> isAtBound; // of each bound
    int passes = 0;
    bool isSettled = false; // false: the bounds in force were still changing, or it was stopped
};

/// By an active set: every pass solves with some unknowns at their bounds, then fixes those that
/// break one and frees those that pull away from theirs; all that matter at once to begin with,
/// later the worst alone, then the first (Bland), which cannot cycle. A further search starts at
/// the bounds that the last one ended with. Each solve is one factorisation of the energy and of
/// stiff springs that hold equations and bounds, refined until the springs carry nothing; so
/// motions that nothing holds are harmless while nothing drives them.
/// Source  J. Nocedal, S. Wright 2006, Numerical optimization, 16.5 and 17.3 (augmented
///         Lagrangian); R. Rockafellar 1976, the proximal point algorithm.
class LeastEnergySearch
{
public:
    explicit LeastEnergySearch(EnergyProblem problem);

    /// zeros  unknowns that are 0 besides
    LeastEnergy least(const std::vector<int> &zeros, const LongWork &work = {});

private:
    /// What holds in a pass: a bound that is reached, an unknown that is 0.
    struct Row
    {
        int block = 0;
        Eigen::VectorXd direction;
        double value = 0.0;
        int bound = -1;
        double multiplier = 0.0;
    };

    /// What is left of −c − Hx − A'q at an x and its multipliers, and of −b − Ax.
    struct Rest
    {
        Eigen::VectorXd slope, sprung; // sprung: what the springs make of the latter
        std::vector<Eigen::VectorXd> pieces;
        std::vector<double> rows;
        double missed = 0.0; // of pieces and rows, all together
    };

    void setRows(const std::vector<int> &zeros);
    bool solve();
    Rest rest();
    void refine(const Rest &rest);
    void finish();
    Eigen::VectorBlock<Eigen::VectorXd> segment(Eigen::VectorXd &x, int block) const;
    std::vector<std::pair<double, int>> faults() const;
    Eigen::VectorXd gathered(std::size_t piece, const Eigen::VectorXd &x) const;
    static std::size_t at(int i) { return static_cast<std::size_t>(i); }

    EnergyProblem m_problem;
    double m_scale = 0.0;  // of H
    double m_spring = 0.0; // what a spring gives
    std::vector<int> m_starts;
    std::vector<std::vector<int>> m_unknowns; // of each piece
    std::vector<Eigen::MatrixXd> m_held;      // of each piece, its energy and its springs
    FrontalFactors m_factors;
    // of the pass
    std::vector<bool> m_isAtBound;
    bool m_isSettled = false; // so that they are a start for the next search
    std::vector<Row> m_rows;
    Eigen::VectorXd m_x;
    std::vector<Eigen::VectorXd> m_multipliers; // of the pieces' equations
};

} // namespace fff
