// How the slits of a mesh's slices are cut, where the two sections alone do not say it. Internal to
// assembly.
#pragma once

#include "core/assembly/slits.h"

namespace fff {

/// What is wanted of the joint of a and b (indices into the model, a < b) by itself; nothing where
/// they are no slices of one mesh, or copies of such. Depends on these two sections and on what
/// made them, on nothing else.
///
/// Of a grid, of whose two rows they are: slits of the row whose key comes first open upwards in
/// the world, all of them, so that a grid goes together in one direction and what is on both sides
/// of a plane of symmetry is cut alike. Not where one of them reaches so far beyond what they share
/// that its slit would be cut far beyond it.
///
/// Of three and more around one axis: each is left whole along a stretch of it, all stretches
/// equal, the first one's at the top. So all but the uppermost are slid in from above, one after
/// the other, and none is cut in two. By halves those in between would be.
JointWish wishInSlices(const Model &model, int a, int b, const Crossing &crossing);

} // namespace fff
