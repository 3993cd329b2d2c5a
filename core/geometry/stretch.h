// Contours that are drawn out on one side of a line.
#pragma once

#include "core/geometry/halfplane_clip.h"

namespace fff {

/// The contour with what of it lies outside of the halfplane so many times (factor > 0) as far from
/// its line; all else stays, bit for bit where a segment does not cross the line. Curves are cut
/// where they do, by de Casteljau's construction, and stay curves. A contour that does not cross
/// itself does not afterwards either: no two points come to lie on each other.
/// Errors  as Contour::fromSegments(). O(segments).
Result<Contour> stretchedOutside(const Contour &contour, const Halfplane &kept, double factor);

} // namespace fff
