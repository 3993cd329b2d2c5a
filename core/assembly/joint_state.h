// One joint as a person looks at it: what it is, what else it could be, and the overrides that make
// it so. Everything is in the order of its JointRef, which need not be that of the model.
#pragma once

#include "core/assembly/found_joint.h"
#include "core/model/joint_ref.h"

#include <array>
#include <optional>
#include <vector>

namespace fff {

/// Why a kind of joint cannot be had of two sections.
enum class JointObstacle {
    None,
    NoWidth,       // a negative clearance leaves the slits none
    EndsOnHole,    // no slit can open to the outside
    OppositeWays,  // here they could only slide one way, there only the other
    NothingHolds,  // they could slide, but nowhere would both have a slit
    ReachesBeyond, // one section does, whichever way they slide: their slits are never equal
    EndsWithin,    // neither section reaches beyond the other
    SeveralPlaces, // they meet in more than one
    DoesNotFit,    // neither fits through the other
    DoNotCross,    // one only ends on the other
    EndsNowhere,   // neither ends on the other's face
    NoRoom,        // for tabs
    TooOblique     // for tabs
};

struct JointState
{
    /// In the order in which a person chooses from them.
    static constexpr std::array kKinds{JointKind::CrossLap, JointKind::ExtendedCrossLap,
                                       JointKind::Mortise, JointKind::Tabs, JointKind::None};

    JointRef ref;
    int a = 0, b = 0; // indices in the model, not in their order
    JointKind kind = JointKind::None;
    Crossing crossing;
    std::vector<Slit> slitsOfA, slitsOfB;
    /// +1: a's slits open along the axis' direction and b's against it, −1: the other way round, 0:
    /// there is no side (a mortise, none).
    int sign = 0;
    bool canFlip = false; // the slits can open to the other side
    /// Of a's slit, one an overlap; none where the overlap is not shared by two slits.
    std::vector<std::optional<double>> shares;
    std::array<JointObstacle, kKinds.size()> obstacles{}; // one a kind

    // What is so because a person wants it.
    JointOverride wanted; // empty: nothing
    std::vector<bool> isShareWanted;

    JointObstacle obstacleTo(JointKind of) const;
    /// Why sections that nobody wants without a joint have none.
    JointObstacle whyNoJoint() const
    {
        return wanted.kind ? JointObstacle::None : obstacleTo(JointKind::CrossLap);
    }
    /// Where the slits of b open to, a unit vector of the world; zero when there is no side.
    Vec3 openingOfB() const { return -sign * crossing.axis.direction; }
    /// Where the slits of the overlap meet, or its middle. World.
    Vec3 meetingPoint(int overlap) const;
};

/// Nothing when one of them is not there or they do not meet.
std::optional<JointState> jointState(const Model &model, const JointRef &joint);
/// Whether there is such a joint now.
bool hasJoint(const Model &model, const JointRef &joint);

// What is to be wanted of it instead, for setJointOverride(); all else stays. What it does by
// itself anyway is not wanted.

/// For a kind without an obstacle. A cross lap may slide the other way for it.
JointOverride withKind(const Model &model, const JointState &state, JointKind kind);
JointOverride flipped(const Model &model, const JointState &state);
/// share: of a's slit, is clamped to kLeastShare … 1 − kLeastShare; one half is what it is by
/// itself.
JointOverride withShare(const Model &model, const JointState &state, int overlap, double share);

} // namespace fff
