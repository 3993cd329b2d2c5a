// Lines cut off at a clip path. Internal to io.
#pragma once

#include "core/geometry/contour.h"
#include "core/geometry/curve_path.h"

#include <vector>

namespace fff::io {

/// Of a closed line what it encloses within the clip, of an open one what lies in it. The clip is
/// the union of its contours; an empty one leaves nothing. Errors  as subtractContours() and
/// clippedLine().
Result<std::vector<CurvePath>> clippedPath(const CurvePath &path, const std::vector<Contour> &clip);

} // namespace fff::io
