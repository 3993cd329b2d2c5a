// Cuts a template into sections: in parallel planes, across an axis of the world or like a section,
// in two directions that slide into each other, round an axis, or across a section's contour.
#pragma once

#include "core/operations/operation_kind.h"

namespace fff {

/// Keys: the axis that planes are across (or "r", round; "s", like a section; "c", along a curve),
/// the number of the plane, and of what it cuts the larger first: "x/3/0". Each follows the
/// template within kGuideError by few curves. Along a curve a plane has one piece (spine_planes.h).
extern const OperationKind kSlices;

} // namespace fff
