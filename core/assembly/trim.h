// One section cut back to another one's faces, for two that no slit lets slide together.
#pragma once

#include "core/assembly/slits.h"

namespace fff {

/// What stays of the section's shape without all that is in the other's slab, and without what
/// falls off: the largest piece. Curves stay curves. The other one's own slits are of no account.
///
/// Errors  NearlyParallel for planes that meet at less than kMinJointAngle; EmptyContour when
///         nothing stays; BadValue, place "section", when nothing of it is in the other's slab, or
///         only what would make a slot inside of it: there the other one is what could be trimmed.
///         As subtract().
/// O(n log n)
Result<ShapePointer> trimmed(const JointSide &section, const JointSide &to);

} // namespace fff
