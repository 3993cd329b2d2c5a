// The ends of a line as they were meant.
#pragma once

#include "core/geometry/vector.h"

#include <cstddef>
#include <vector>

namespace fff {

/// A line that is to be closed, without what its ends have too much.
struct MeantEnds
{
    std::vector<Vec2> line;
    /// Of the samples those that are kept, and what the first of them is in the line.
    std::size_t from = 0, to = 0, place = 0;
    /// The line begins and ends at a corner.
    bool isCorner = false;
    /// The ends cross, and so much lay beyond that it was no slip of the hand: a loop was kept.
    bool isLoop = false;
};

/// What of the samples closes:
///   - a hook at either end, where the hand turned back sharply as it was put down or lifted, goes,
///     as does what lies beyond the nearest approach of one end to the other, or beyond where they
///     cross: a quarter of the line at most;
///   - ends that meet in a corner, straight ones or such as turn far more than they bend, are led
///     on, or cut off, to where they cross each other: the line begins and ends there;
///   - of ends that do not, but point past each other, so much goes that what closes them
///     (closedLine(), closingSegment()) is no notch.
/// A line whose ends are far apart, further than kFarApart tolerances and a part of its length,
/// stays as it is: it is open on purpose.
///
/// samples    all of them looked at (SampledLine::usable); tolerance: of the fit, mm. O(n).
MeantEnds meantEnds(const std::vector<Vec2> &samples, double tolerance);

/// Without a hook at its end (isAtEnd) or its start, whether it closes or not: `samples` from the
/// first to the last that stay.
struct WithoutHooks
{
    std::size_t from = 0, to = 0;
};
WithoutHooks withoutHooks(const std::vector<Vec2> &samples, double tolerance);

} // namespace fff
