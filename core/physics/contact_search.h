// Springs between rigid members, some of which only press: which of them do, and with what force.
#pragma once

#include "core/geometry/vector.h"
#include "core/physics/block_system.h"

#include <optional>
#include <vector>

namespace fff {

/// Displacements of a member are six lengths: of its centroid, and its rotation times `size`, so
/// that stiffnesses compare. What does work on them is a force, and a moment divided by `size`.
struct SpringNet
{
    /// Resists what a point fixed to `a` moves and turns more than the same point fixed to `b`.
    struct Joint
    {
        int a = 0, b = 0;
        Vec3 armA = Vec3::Zero(), armB = Vec3::Zero(); // mm, from the centroids to the point
        Block6 stiffness = Block6::Zero();             // N/mm, N·mm/rad; symmetric

        bool operator==(const Joint &) const = default;
    };
    /// Resists the length rowA · displacement of a + rowB · displacement of b.
    struct Spring
    {
        int a = 0, b = -1; // −1: the ground
        Vec6 rowA = Vec6::Zero(), rowB = Vec6::Zero();
        double stiffness = 0.0; // N/mm
        double start = 0.0;     // one that only presses does so from this length on downwards, mm
        bool isOn = true;

        bool operator==(const Spring &) const = default;
    };

    int members = 0;
    double size = 1.0; // mm
    std::vector<Joint> joints;
    std::vector<Spring> holding;  // pull and press
    std::vector<Spring> pressing; // force = stiffness · max(0, start − length)

    /// What the point, so far from the centroid of a member, does with its six lengths.
    Block6 atPoint(const Vec3 &arm) const;
    /// The row of a point's translation in a direction.
    Vec6 row(const Vec3 &arm, const Vec3 &direction) const;

    bool operator==(const SpringNet &) const = default;
};

struct SpringForces
{
    std::vector<Vec6> joints;              // on a, about the point: N, N·mm
    std::vector<double> holding, pressing; // N, along the rows
    Eigen::VectorXd displacements;         // 6 for each member, as SpringNet counts them, mm
    double residual = 0.0;                 // largest of what is left over on a member, N
};

/// Solves a net for one load after another.
///
///     minimise  ½ Σ k length² + ½ Σ k max(0, start − length)² − load · displacements
///
/// The function is convex, smooth and quadratic by pieces. Each pass solves the piece that it is in
/// (all springs that press there are kept, all others dropped, at once) and goes on to the least
/// along that way, so that no set of springs is met twice and no rule against cycles is needed.
/// While only few springs changed, the last factors serve as preconditioner of conjugate gradients.
/// A part that can move freely and has no load that would move it is no fault.
///
/// Source  L. Qi, J. Sun 1993, A nonsmooth version of Newton's method; the product's mechanics,
///         section 1.1 (a), of which the dropping and re-adding here is the globalised form.
class ContactSearch
{
public:
    explicit ContactSearch(SpringNet net);

    const SpringNet &net() const { return m_net; }
    /// Another net between the same pairs of members, with as many springs that press: the order of
    /// elimination stays. False, and nothing done, for any other.
    bool replace(const SpringNet &net);
    /// Springs that hold take part or not; where that changes, factors are made anew.
    void hold(const std::vector<char> &isOn);
    /// load: 6 for each member. Begins with the springs that pressed last time. Nothing when the
    /// load moves it without end: `motion` then tells how.
    std::optional<SpringForces> solve(const Eigen::VectorXd &load);
    const Eigen::VectorXd &motion() const { return m_motion; }
    /// Passes and factorisations of the last solve.
    int passes() const { return m_passes; }
    int factorisations() const { return m_factorisations; }

private:
    void writeBase();
    double length(const SpringNet::Spring &spring, const Eigen::VectorXd &displacements) const;
    std::vector<char> pressingAt(const Eigen::VectorXd &displacements) const;
    bool use(const std::vector<char> &active);
    bool factorise();
    Eigen::VectorXd step(const Eigen::VectorXd &residual);
    void addForces(const Eigen::VectorXd &by, const std::vector<char> &active,
                   SpringForces &forces) const;
    Eigen::VectorXd leftOver(const Eigen::VectorXd &load, const SpringForces &forces) const;
    SpringForces forcesAt(const Eigen::VectorXd &displacements) const;
    std::optional<double> leastAlong(const Eigen::VectorXd &way, double slope) const;
    void refine(const Eigen::VectorXd &load, SpringForces &forces);

    SpringNet m_net;
    BlockSystem m_system;
    Eigen::VectorXd m_base;          // its values without what only presses
    std::vector<char> m_active;      // pressing, as the matrix has them
    std::vector<char> m_factorised;  // as the factors have them
    Eigen::VectorXd m_soft;          // what is added to the diagonal, N/mm
    Eigen::VectorXd m_displacements; // of the last solve
    Eigen::VectorXd m_motion;
    bool m_isWritten = false, m_hasFactors = false;
    int m_passes = 0, m_factorisations = 0;
};

} // namespace fff
