// Cuts a template into sections: in parallel planes, in two directions that slide into each other,
// or round an upright axis.
#pragma once

#include "core/operations/operation_kind.h"

namespace fff {

/// Keys: the axis that planes are across (or "r", round), the number of the plane, and of what it
/// cuts the larger first: "x/3/0". Each follows the template within kGuideError by few curves.
extern const OperationKind kSlices;

} // namespace fff
