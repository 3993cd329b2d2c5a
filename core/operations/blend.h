// Sections between others, which they turn into one another.
#pragma once

#include "core/operations/operation_kind.h"

namespace fff {

/// Inputs    "sections", two or more in their order, and "along", the root that all of them cross.
/// Made      between every two of them `count` sections, equally far from each other along the
///           root's boundary, by the shorter way, or slowly from and to the ends. Each has a place
///           on the boundary, a turn relative to its tangent, and a contour, all of which go from
///           those of the one to those of the other; at the ends they would be equal to them.
/// Contours  in coordinates from where a section leaves the root: along the axis, and in the
///           section's plane square to it (core/geometry/contour_blend.h). Holes go along where
///           both have as many, each to the nearest.
/// Keys      "0/1", "0/2" … between the first two, "1/1" … between the next.
/// Source    J. McCrae et al. 2014, FlatFitFab, "Blend operation", figure 12. Deviates: contours
///           are cut and moved by their control points in place of 256 samples, which finds only
///           what belongs together.
extern const OperationKind kBlend;

} // namespace fff
