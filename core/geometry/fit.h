// Smooth curves through what a hand drew.
#pragma once

#include "core/geometry/bezier.h"

#include <optional>
#include <vector>

namespace fff {

struct FitOptions
{
    double tolerance = 0.5; // mm that the curve may be off the samples
    /// The line turns by more than this within `reach` of a sample: a corner. Radians.
    double cornerAngle = 0.5;
    /// Corners and tangents are judged over this many tolerances along the line; also the longest
    /// gap between samples that is left without further ones on the straight way.
    double reach = 4.0;
    /// The way at the first (at the last) sample, unit; none: that of the line there.
    std::optional<Vec2> startDirection = {}, endDirection = {};
};

/// An open chain of cubic Béziers along the polyline through the samples, from the first to the
/// last; each segment starts where the one before ended.
///
/// samples  in the order of drawing, mm. Repeated and non-finite ones are left out.
/// Result   every sample lies within `tolerance` of the chain and the chain within about twice that
///          of the polyline. At corners the tangent breaks and the sample itself is kept; elsewhere
///          the chain is G1. Empty for fewer than two different samples.
/// A function of all samples: what is fitted while drawing is what is fitted at the end. Cost
/// O(n log n) for usual strokes.
/// Source   P. Schneider 1990, "An Algorithm for Automatically Fitting Digitized Curves", Graphics
///          Gems, pp. 612-626. Different here: corners are found first; gaps are filled with
///          samples on the straight way, and the error is also taken half-way between samples, so
///          that a curve cannot swing out between them; tangents are taken over a stretch of the
///          line, not from the nearest sample, because pixels are coarse.
std::vector<CubicBezier> fitCurve(const std::vector<Vec2> &samples, const FitOptions &options = {});

/// The same for a closed line: the first sample follows the last. The chain ends where it starts,
/// G1 there as well, or at a corner when there is one.
std::vector<CubicBezier> fitClosedCurve(const std::vector<Vec2> &samples,
                                        const FitOptions &options = {});

/// The piece that closes an open chain (not empty), tangent to both of its ends. Its handles are a
/// third of its chord, less where that would make it loop.
CubicBezier closingSegment(const std::vector<CubicBezier> &chain);

/// Unit direction at the start (end) of a segment, also when a handle has no length. Zero for a
/// segment that is a point.
Vec2 startDirection(const CubicBezier &segment);
Vec2 endDirection(const CubicBezier &segment);

} // namespace fff
