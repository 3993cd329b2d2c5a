// Regions grown by a distance, with curves.
#pragma once

#include "core/geometry/boolean.h"

namespace fff {

/// The region with every boundary moved away from its material by `distance` mm (0 or more): the
/// outer one outwards, holes inwards. Connected, so one region; holes and slits narrower than twice
/// the distance close.
///
/// Straight segments stay straight, exactly parallel; a curve becomes one cubic or several within
/// kOffsetError of the true offset curve. Corners are mitred, so that those of slits stay square;
/// spikes are cut off at right angles to their bisector, `distance` from the tip at least.
/// Distance 0 gives the region back as it is.
///
/// Method: every boundary is offset by itself, which leaves loops where it is too narrow; these are
/// wound round zero times or less (X. Chen, S. McMains 2005, Polygon Offsetting by Computing
/// Winding Numbers), and windingRegions leaves them out.
CurvedRegion grow(const CurvedRegion &region, double distance);

} // namespace fff
