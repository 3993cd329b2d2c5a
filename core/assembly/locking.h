// Which of some rigid things can move at all, when none may go into another one.
#pragma once

#include "core/assembly/contacts.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace fff {

/// A thing that must not go into what it touches, itself a thing or at rest.
struct RigidContact
{
    static constexpr int kAtRest = -1;

    int thing = 0, other = kAtRest;
    Contact contact;   // a point of the thing before the other one; of either, it is the same
    double give = 0.0; // mm: so deep the two may be in each other there
};

/// Where a thing touches, about which it turns.
struct Pivot
{
    Vec3 at = Vec3::Zero();
    double radius = 1.0; // mm
};
/// Of each thing the middle of the box of its contacts, and half of its diagonal.
std::vector<Pivot> pivotsOf(const std::vector<RigidContact> &contacts, int things);

/// How things move, mm, six numbers a thing: along the axes of the world, and by turns about these
/// through its pivot, times the radius.
using Motion = Eigen::VectorXd;

/// From where on a thing is loose.
struct Looseness
{
    double play = 0.0;  // mm: what is taken off at every contact, beyond the gap there
    double limit = 0.5; // mm: what may move by no more is held
};

/// What contacts let rigid things do, to first order, for which ways have to be small against what
/// they touch; what is held by the curve of a surface alone counts as movable. Nothing rubs. Refers
/// to what it is made of.
///
/// A thing is kept from moving one way where pressing at the contacts can push it back, at no net
/// push on the others; the gaps there say how far it comes before. Where rounding leaves that open
/// it counts as movable.
/// Source  Z. Wang, P. Song, M. Pauly 2018, DESIA, 4.1: what is interlocked can balance every
/// force.
class Locking
{
public:
    Locking(const std::vector<RigidContact> &contacts, const std::vector<Pivot> &pivots)
        : m_contacts(contacts), m_pivots(pivots)
    {
    }

    /// A motion that changes one of its numbers by more than the limit, up or down (±1), the others
    /// as they like; none where something stops it. Least squares of 6 rows a thing.
    std::optional<Motion> motionAlong(Eigen::Index number, double way,
                                      const Looseness &looseness) const;
    /// The nearest to what is wanted of those that keep all gaps, within what gives; none where
    /// there is no such motion.
    std::optional<Motion> nearestMotion(const Motion &wanted) const;

private:
    Eigen::MatrixXd columns() const;

    const std::vector<RigidContact> &m_contacts;
    const std::vector<Pivot> &m_pivots;
};

} // namespace fff
