// What of open lines lies in a region.
#pragma once

#include "core/base/result.h"
#include "core/geometry/polygon.h"

#include <vector>

namespace fff {

/// The pieces of a line (2 points or more) that lie in the region, on the grid of booleans
/// (kClipGrid), in no order; each runs as the line does. Empty where none does. Errors
/// NotWorkedOut when Clipper fails.
Result<std::vector<Polygon>> clippedLine(const Polygon &line, const Region &region);

} // namespace fff
