// How members stand after they have given way: each is moved as a whole so that they fit together
// again.
#pragma once

#include "core/physics/elastic_equilibrium.h"
#include "core/physics/equilibrium.h"

namespace fff {

/// How far a member gives where it is held, but for a motion of the whole.
struct MemberGive
{
    std::vector<MemberAttachment> attachments;
    std::vector<WrenchVector> moved; // of each: displacement (mm) and rotation (rad) about the
                                     // link's point, or the foot's; world
};

struct FittingMotions
{
    std::vector<RigidMotion> members; // of each about its centroid
    double worstGap = 0.0;            // mm that are left between what is joined; rotations times
                                      // the structure's size
};

/// Rigid motions after which links and pressing feet are where their forces say:
///
///     moved_a − moved_b = −C w at links,   up · moved = −force / stiffness at feet
///
/// in the least squares. Forces of an elastic equilibrium leave no gap; a link that is open is free
/// along its axis, a foot that is lifted altogether. What nothing holds stays where it is.
/// gives  of each member; of what is rigid none
FittingMotions fittingMotions(const Structure &structure, const std::vector<MemberGive> &gives,
                              const Equilibrium &equilibrium);

} // namespace fff
