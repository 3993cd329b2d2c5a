// Documents as strokes make them: each section but the first stands on a slit in one that was there
// before.
#pragma once

#include "core/model/document.h"

#include <cstdint>

namespace fff::test {

/// Two to eight sections, all of it from the seed. Wavy contours, rectangles and arms; slits from
/// the edge inwards, along the edge, across all of the parent, to equal ends or not; shelves across
/// two sections that cross; mortises; planes at 20° to 90°; windows; sheets of 1 to 6 mm,
/// clearances of 0 to 0.2 mm.
Document randomDrawing(std::uint64_t seed);

} // namespace fff::test
