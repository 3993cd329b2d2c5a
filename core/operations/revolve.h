// Replicas of a section round the contour of another one.
#pragma once

#include "core/operations/operation_kind.h"

namespace fff {

/// Inputs    "section", which is repeated, and "along", the root, whose contour (or hole) is
///           followed: the boundary at which the section leaves the root.
/// Replicas  are turned in the root's plane with the boundary's tangent: the angle between the
///           section's plane and the tangent is kept, or is `angle` for all of them.
/// Range     shares of the boundary's length, counted counter-clockwise from the source; from > to
///           goes across the source. All the way round: in equal steps.
/// Side      outside: as drawn, since a section leaves its root outwards; inside: mirrored at the
///           tangent.
/// Scale     as linear, about the point on the boundary, by the root's girth from there inwards.
/// Keys      "1", "2" … counter-clockwise and "-1", "-2" … clockwise; on the inside below "in".
/// Source    J. McCrae et al. 2014, FlatFitFab, "Affine operations", figure 11.
extern const OperationKind kRevolve;

} // namespace fff
