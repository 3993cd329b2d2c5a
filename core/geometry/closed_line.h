// Closing what a hand meant to close. Internal to geometry and stroke.
#pragma once

#include "core/geometry/vector.h"

#include <optional>
#include <vector>

namespace fff {

/// The samples as a closed line, for fitClosedCurve(), when the last one comes back to the first:
///   - going on in the direction in which the line began, over a gap so short that the straight way
///     stays within half a tolerance of any bend that closes it;
///   - or at a corner, by no more than kCornerGap tolerances.
/// What was drawn beyond the start, beside what is there already, is left out. By how much the ends
/// pass beside each other is shared out over a stretch of both, so that there is no dent; at a
/// corner the end alone is led to the start. Samples are moved by that, at the ends by up to two
/// tolerances (three at a corner), and by nothing elsewhere. None for all other strokes.
///
/// tolerance, reach: as in FitOptions, mm
/// between           mm of the line that were left out of `samples`, somewhere between its ends,
///                   beyond the straight way over the gap that this makes. What is looked at lies
///                   within kEndReaches of the ends.
std::optional<std::vector<Vec2>> closedLine(const std::vector<Vec2> &samples, double tolerance,
                                            double reach, double between = 0.0);
inline constexpr double kEndReaches = 24.0;

} // namespace fff
