// Regions made equal to their images.
#pragma once

#include "core/geometry/contour.h"
#include "core/geometry/halfplane_clip.h"

#include <vector>

namespace fff {

/// What of the region lies in the halfplane, and its mirror image across the halfplane's line, as
/// one: connected pieces, largest first. Curves are kept. Empty when nothing lies there. Errors
/// as clip(), windingRegions() and mapped().
Result<std::vector<ClippedPiece>>
mirroredHalf(const Contour &contour, const std::vector<Contour> &holes, const Halfplane &half);

/// What of it lies in the sector of 2π / count round a direction from the centre, so many times
/// round. count = 1: as it is. Errors  the same.
Result<std::vector<ClippedPiece>> repeatedSector(const Contour &contour,
                                                 const std::vector<Contour> &holes,
                                                 const Vec2 &centre, int count, double direction);

} // namespace fff
