// Whether sections come upon each other without a joint, while an edit is tried.
#pragma once

#include "core/assembly/joint.h"

namespace fff {

/// Whether the slabs of two sections (indices into the model) that no joint is of share a point, to
/// kTouchingDepth. Slits are not looked at. O(edges of both) where their boxes meet.
bool touchLoosely(const Model &model, const JointList &joints, int a, int b);

} // namespace fff
