// A loop of a cut as the contour of a section that follows it.
#pragma once

#include "core/geometry/contour.h"
#include "core/geometry/frame.h"
#include "core/templates/plane_cut.h"

namespace fff {

/// mm: of a section that follows a template, from the cut that it follows.
inline constexpr double kGuideError = 0.05;

/// Few cubics along the loop, in coordinates of a frame on the plane of the cut: within `tolerance`
/// (mm) of the loop everywhere, and the loop of it. Corners of the mesh stay corners; where facets
/// stand for something round, the curve is round. It runs as the loop does.
///
/// Errors  EmptyContour for a loop that encloses nothing to speak of (kMinArea), or is smaller than
/// the tolerance lets it be.
Result<Contour> guideCurve(const CutLoop &loop, const Frame &frame, double tolerance = kGuideError);

} // namespace fff
