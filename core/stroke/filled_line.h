// The way between the few samples of a quick hand.
#pragma once

#include "core/geometry/vector.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace fff {

/// The samples and, between those that are further apart than kLeastGap tolerances, places on the
/// bend that leads from one to the next: a hand that is asked for its place ten times on its way
/// round a circle draws no decagon.
///
/// At a sample that the line turns at, the bend passes as the circle through it and its neighbours
/// does. It is a corner, and ways to it are as straight as what comes before lets them be, where it
///   - turns by kSharp or more, and is no tip that bends lead up to; or by kNextToSharp beside
///     such a one; or
///   - turns, and its neighbours hardly do: long straight, turn, long straight.
/// Where a few samples are missing among many, the bend leads from where the line comes to where
/// it goes on, if it turns on both sides about as much; at a corner it does on one alone.
/// What the bend keeps within a tenth of a tolerance of the straight way is left as it is.
///
/// tolerance  of the fit, mm
/// Result     `result` and `places` as of a call before for the samples before `from` are kept;
///            places: of each sample, its index in the result. A way depends on the samples up to
///            kFillLookAround away from its ends.
void fill(const std::vector<Vec2> &samples, double tolerance, std::size_t from,
          std::vector<Vec2> &result, std::vector<std::size_t> &places);

inline constexpr std::size_t kFillLookAround = 8;

/// The same all round, of few samples that are far apart and come back to where they began, which
/// is where the result begins and ends; what of them lies beyond is left out. None for all others.
std::optional<std::vector<Vec2>> filledRound(const std::vector<Vec2> &samples, double tolerance);

} // namespace fff
