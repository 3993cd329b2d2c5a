// What is drawn once stands on the other sides, too.
#pragma once

#include "core/operations/operation_kind.h"

namespace fff {

/// Mirror      across a plane: x = 0, y = 0, z = 0, or that of a section. Rotational: `times` times
/// round
///             the vertical through the origin, or the axis of two sections that cross.
/// Scope       the whole model as the operations above leave it, or the sections under "sections".
/// Copies      of every section that is not its own image; one of which the image is already drawn
///             is left alone, so that the same symmetry again changes nothing.
/// Its own     a section whose plane the symmetry maps to itself, and that reaches across the
///             mirror, or round the axis, stays one and becomes symmetric: of a mirrored one the
///             larger half counts, of a turned one the sector round the frame's x.
/// Parents     of copies are copies, or the section itself where it stays one.
/// Keys        mirrored: the section's id, or "o" and the operation with its key below; turned: the
///             number of the turn, 1 …, and that below it.
extern const OperationKind kMirror;
extern const OperationKind kRotational;

} // namespace fff
