// Closing a stroke of which most is settled.
#pragma once

#include "core/geometry/settled_fit.h"

#include <optional>
#include <vector>

namespace fff {

/// The closed chain of a stroke that comes back to where it began (closed_line.h); none for all
/// others.
///
/// samples  all of them, looked at (SampledLine::usable)
/// settled  of the open stroke. What of it lies between the two ends, away from both, is part of
///          the chain as it is; the ends, which are led together, are fitted once more as one
///          stretch across the place where they meet. With nothing settled, fitClosedCurve().
std::optional<std::vector<CubicBezier>> closedFit(const std::vector<Vec2> &samples,
                                                  const std::vector<FittedPiece> &settled,
                                                  const FitOptions &options);

/// Of the pieces those that begin and end at least `length` mm of chords from the ends of the line
/// that they are of, as a range of indices; nothing else is known about how the line goes on there.
/// Only a range that starts at a sample. Empty when there are none.
struct PieceRange
{
    std::size_t begin = 0, end = 0;
    bool isEmpty() const { return begin >= end; }
};
PieceRange awayFromEnds(const std::vector<FittedPiece> &pieces, double length);

} // namespace fff
