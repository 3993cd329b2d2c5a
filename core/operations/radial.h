// A section's contour, or holes in it, that repeat round its middle.
#pragma once

#include "core/operations/operation_kind.h"

namespace fff {

/// Input   "section": it stays one section, of another shape; the middle is its centroid as drawn.
/// Kinds   circle, star, gear: in place of its contour (holes that still fit stay), or as a hole of
///         it; holes: circles between both radii; sector: of its own contour and holes what lies
///         round the direction `phase`, so many times.
/// Source  J. McCrae et al. 2014, FlatFitFab, "Radial contour operation", figure 15.
extern const OperationKind kRadial;

} // namespace fff
