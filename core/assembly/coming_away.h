// Whether rigid things come away from each other and from what is at rest, followed on their way.
#pragma once

#include "core/assembly/body.h"

#include <vector>

namespace fff {

/// Bodies that move each as one with others, among bodies at rest.
struct RigidThings
{
    std::vector<std::vector<BodyPointer>> things;
    std::vector<BodyPointer> atRest; // near to them
};

/// In each other by less, mm, bodies only graze each other.
inline constexpr double kGraze = 0.02;
/// mm: what moves by no more is held.
inline constexpr double kHeldMove = 0.7;

/// Of each thing whether it moves by more than kHeldMove, in whatever way, turns included, and none
/// of all on its way in another one by kGraze, or by that more than the two are from the start. Of
/// the others those move as they like that come away, too; what only rattles makes no room.
///
/// What contacts can balance to first order, once kGripLoss is taken off at each of them, is held
/// (locking.h). For what they cannot, that tells a way, which the things are led along in steps
/// that keep to what contacts allow where they are by then. So what comes off round a corner is
/// loose, and what has room to rattle only is not. Where no way is found they are held.
///
/// Costs contactsOf() of all that is near to each other, once, and of what is not held to first
/// order once more a step: some ten steps where it comes away, mostly fewer where it does not.
std::vector<char> whatComesAway(const RigidThings &things);

} // namespace fff
