// Which way the slits of a mesh's slices open, where the two sections alone do not say it. Internal
// to assembly.
#pragma once

#include "core/assembly/joint.h"

namespace fff {

/// To which end of the axis slits of a open (±1) where a and b (indices into the model, a < b) are
/// slices of one grid, or copies of such, in rows across each other: those of the row whose key
/// comes first open upwards in the world, all of them, so that a grid goes together in one
/// direction and what is on both sides of a plane of symmetry is cut alike. 0: they are no such
/// sections, or one of them reaches so far beyond what they share that its slit would be cut far
/// beyond it. Depends on these two sections and on what made them, on nothing else.
int sideInGrid(const Model &model, int a, int b, const Crossing &crossing);

} // namespace fff
