// Replicas of a section in a row along another one.
#pragma once

#include "core/operations/operation_kind.h"

namespace fff {

/// Inputs       "section", which is repeated, and "along", the root.
/// Replicas     keep the section's normal and stand in the root's plane on a line at a right angle
///              to the axis in which both meet; forward is where the section's normal points.
/// Equal depth  they are shifted along the axis so that the part of it inside root and replica is
///              as long as at the source: the edge of the root where the section leaves it is
///              followed. Where the section goes through the root, or ends inside it at both ends,
///              no shift can do that; then the root's middle is followed.
/// Scale        by the root's girth along the axis there, over that at the source: all of the
///              section, or only in the axis' direction. Equal depth is then in proportion: a rib
///              of half the size is half as deep in, since a thin root could not hold it else.
/// Keys         "1", "2" … forward and "-1", "-2" … back, counted from the source; what is attached
///              to the section, below them by its id.
/// Source       J. McCrae et al. 2014, FlatFitFab, "Affine operations", figures 9 and 10.
extern const OperationKind kLinear;

} // namespace fff
