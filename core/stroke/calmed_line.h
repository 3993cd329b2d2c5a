// What a hand meant where its samples are noise.
#pragma once

#include "core/geometry/vector.h"

#include <cstddef>
#include <vector>

namespace fff {

/// The samples with as much taken off as each of them is off by chance: of a device or a hand that
/// is off anew with every sample, by half a tolerance or more. Elsewhere they stay, bit for bit.
///
/// How far the samples are off follows from their third differences, in which a smooth way leaves
/// next to nothing; the median of those around does not see a corner. It is noise only where the
/// second differences are smaller than these: few samples of a quick hand differ the other way
/// round. Then each sample goes to where a parabola in time passes that is laid through its
/// neighbours: as many, and on as many sides, as one can follow within that noise, so that corners
/// stay.
/// Source  V. Katkovnik, K. Egiazarian, J. Astola 2006, Local Approximation Techniques in Signal
///         and Image Processing, for windows that are judged by their residuals; A. Savitzky,
///         M. Golay 1964 for the parabola.
///
/// tolerance  of the fit, mm
/// Result     of `result` as of a call before, what lies before `from` is kept; as many as samples.
///            A sample depends on those up to kLookAround away from it. O(1) each.
void calm(const std::vector<Vec2> &samples, double tolerance, std::size_t from,
          std::vector<Vec2> &result);

inline constexpr std::size_t kCalmLookAround = 22;

} // namespace fff
