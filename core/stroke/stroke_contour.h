// The contour that the samples of a stroke make.
#pragma once

#include "core/geometry/contour.h"

#include <optional>
#include <vector>

namespace fff {

/// What is seen while drawing and what a release makes, from one and the same fit.
struct StrokeContour
{
    std::vector<CubicBezier> fitted;    // open chain along the samples
    std::optional<CubicBezier> closing; // from its end back to its start; none when they meet
    /// Closed, free of crossings; none while nothing is enclosed that can be told from a line or a
    /// dot: its area is below the tolerance times its extent, or that below five tolerances.
    std::optional<Contour> contour;
    bool wasCrossing = false; // the closed chain crossed itself, the largest loop was kept
};

/// samples: canvas coordinates, mm; tolerance: mm that the fit may be off them. A function of all
/// samples, so that nothing jumps at the release.
StrokeContour strokeContour(const std::vector<Vec2> &samples, double tolerance);

} // namespace fff
