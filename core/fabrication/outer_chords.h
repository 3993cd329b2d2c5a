// The outline of a part as straight edges that are nowhere inside it. Internal to fabrication.
#pragma once

#include "core/geometry/boolean.h"

namespace fff {

/// Holds all of the outline, and no more than twice kCutChord beside it: where a curve bulges out
/// of the part its tangents stand for it, where it bulges into it its chords. Straight edges are as
/// they are, so that two of them can lie on each other. The chords of the region are as near, but
/// the curves go beyond them. O(number of chords).
Region outerChords(const CurvedRegion &outline);

} // namespace fff
