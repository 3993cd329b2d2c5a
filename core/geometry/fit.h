// Smooth curves through what a hand drew.
#pragma once

#include "core/geometry/bezier.h"

#include <optional>
#include <vector>

namespace fff {

struct FitOptions
{
    double tolerance = 0.5; // mm that the curve may be off the samples
    /// The line turns by more than this all at once: a corner. Radians.
    double cornerAngle = 0.5;
    /// Corners and directions are judged over this many tolerances along the line, or a few times
    /// that where the line allows.
    double reach = 4.0;
    /// The way at the first (at the last) sample, unit; none: that of the line there.
    std::optional<Vec2> startDirection = {}, endDirection = {};
    /// Counts the samples that cubics were held against: what a fit costs, on any machine.
    std::size_t *work = nullptr;
};

/// A segment of a chain, and the samples that it runs from and to.
struct FittedPiece
{
    CubicBezier curve;
    std::size_t from = 0, to = 0;
    /// The chain passes its start (its end) in one direction.
    bool isStartSmooth = false, isEndSmooth = false;
    bool isStartBetween = false; // it starts after the sample `from`, before the next one
};

/// An open chain of cubic Béziers along the polyline through the samples, from the first to the
/// last; each segment starts where the one before ended.
///
/// samples  in the order of drawing, mm. Repeated and non-finite ones are left out.
/// Result   every sample lies within `tolerance` of the chain, and the chain within that of the
///          polyline through the samples: it does not swing out between them, nor beyond the ends.
///          At corners the direction breaks (by 0.2 at least) and the sample itself is kept;
///          elsewhere the chain is G1. Straight runs are true lines (CubicBezier::line). No segment
///          crosses itself. Empty for fewer than two different samples.
/// A function of all samples, made anew each time; settled_fit.h is for lines that grow. Cost O(n +
/// segments log n) for usual strokes: 300 samples take half a millisecond at most, 2,000 less than
/// four (where the benchmarks' kernel takes 80).
///
/// How it is done and from which papers: sampled_line.h (what is a corner, which way the line
/// goes), fit_span.h (one cubic), chain_fitter.h (the fewest of them). The frame is that of P.
/// Schneider 1990, "An Algorithm for Automatically Fitting Digitized Curves", Graphics Gems, pp.
/// 612-626: corners first, then directions, then handles by least squares.
std::vector<CubicBezier> fitCurve(const std::vector<Vec2> &samples, const FitOptions &options = {});

/// The same with the samples that each segment runs along. Of samples that are all looked at
/// (SampledLine::usable).
std::vector<FittedPiece> fitPieces(const std::vector<Vec2> &samples,
                                   const FitOptions &options = {});

/// The same for a closed line: the first sample follows the last. The chain ends where it starts,
/// G1 there as well, or at a corner when there is one.
std::vector<CubicBezier> fitClosedCurve(const std::vector<Vec2> &samples,
                                        const FitOptions &options = {});

/// The piece that closes an open chain (not empty), tangent to both of its ends. Its handles are a
/// third of its chord, less where that would make it loop. Straight where one end points to the
/// other, which lies at a corner: an edge that was not drawn to its end.
CubicBezier closingSegment(const std::vector<CubicBezier> &chain);

/// Unit direction at the start (end) of a segment, also when a handle has no length. Zero for a
/// segment that is a point.
Vec2 startDirection(const CubicBezier &segment);
Vec2 endDirection(const CubicBezier &segment);

} // namespace fff
