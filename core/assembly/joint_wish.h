// From what a person wants of a joint to what its slits are cut by. Internal to assembly.
#pragma once

#include "core/assembly/slits.h"

namespace fff {

/// What is wanted of the joint of two sections (indices into the model, a < b), as their crossing
/// has it now: a direction is taken by the end of the axis that it points to, a share by the
/// overlap that it lies in, or nearest to as far as half of that one's length. What matches nothing
/// is passed over.
JointWish wishFor(const Model &model, int a, int b, const Crossing &crossing);

/// To which end of the axis a direction (world, unit) points, ±1; 0 when it is square to it: then
/// it means neither.
int signAlong(const Vec3 &direction, const Axis &axis);

/// Whether tabs are, which need no crossing.
bool wantsTabs(const Model &model, int a, int b);

/// The overlap that a share is meant for now, an index into those of the crossing; −1: none.
int overlapOf(const JointOverride::Share &share, const Frame &frameOfA, const Crossing &crossing);

} // namespace fff
