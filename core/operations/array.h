// Copies one after the other along a line through space.
#pragma once

#include "core/operations/operation_kind.h"

namespace fff {

/// Copies      `count` with the sections themselves, each moved by one step (x, y, z in the world)
///             more than the one before. They are images: an edit of one is an edit of all.
/// Parents     of copies are copies, or the section itself where that is not copied.
/// Nothing     for a step of no length: all would lie in one place.
/// Keys        the number of the copy, 1 …, and below it the section's, as of a symmetry.
extern const OperationKind kArray;

} // namespace fff
