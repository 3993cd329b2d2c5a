// How much work it is to take apart a contour that may cross itself. Internal to geometry but for
// those who say that it is too much.
#pragma once

#include "core/geometry/contour.h"

namespace fff {

/// How often a sweep over the contour's chords of kCutChord has an edge beside another one: about
/// the number of steps of resolveCrossings(), no less. A page of what people draw has a few for
/// each edge; a million places at random, each joined to the next, have a third of their square.
double crossingWork(const Contour &contour);

/// What a person waits for: more than this is refused. No unit.
inline constexpr double kMostCrossingWork = 5e6;

} // namespace fff
