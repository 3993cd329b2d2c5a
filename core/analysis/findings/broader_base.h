// Bases that hold what falls over, by itself or by a push: a toe at the foot of a section, and a
// foot across one.
#pragma once

#include "core/analysis/finding_action.h"

namespace fff {

/// A section that is on the ground becomes longer there, to the side to which the model falls.
extern const ActionKind kWidenBase;
/// A plate across a section that is on the ground, as far to both sides as it takes.
extern const ActionKind kAddFoot;

} // namespace fff
