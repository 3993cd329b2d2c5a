// Slits cut into the side of a boundary, without a boolean of everything: what nearly every section
// of nearly every model needs.
#pragma once

#include "core/geometry/boolean.h"

#include <optional>

namespace fff {

/// What `subtract` gives where each cut takes a bite out of the contour's side: the contour enters
/// it once and leaves it once, through two different sides. Each bite replaces a stretch of the
/// boundary and all else stays as it is, so the cost is that of the cuts and of copying the curves.
///
/// contour, holes   counter-clockwise and clockwise; none touches itself or another (isApart)
/// cuts             convex polygons, counter-clockwise
/// Nothing where it is not that plain: cuts that meet each other or a hole, that lie inside or
/// outside, or whose sides meet the contour within rounding of a corner. Then `subtract` tells.
/// Topology is decided exactly on the same grid as there; ends of curves are where they cross the
/// cuts' lines, as there. The chords of the result are those given, not moved to the grid.
std::optional<CurvedRegion> cutNotches(const Contour &contour, const std::vector<Contour> &holes,
                                       const std::vector<Polygon> &cuts, double chord);
/// The same where the contour's chords are at hand.
std::optional<CurvedRegion> cutNotches(const Contour &contour, const Polyline &chords,
                                       const std::vector<Contour> &holes,
                                       const std::vector<Polygon> &cuts, double chord);

} // namespace fff
