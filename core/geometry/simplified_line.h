// A polyline with fewer points that is nowhere far from the one it is of.
#pragma once

#include "core/geometry/vector.h"

#include <cstddef>
#include <vector>

namespace fff {

/// Indices of the points that a simplified line goes through, first and last among them: every
/// point in between is within `error` (mm) of the chord, as long as the line does not go back by
/// more than twice that.
/// Source  J. Sklansky, V. Gonzalez 1980, Fast polygonal approximation of digitized curves: the
///         chord's direction has to lie in the cone that each point's disc leaves. O(n).
std::vector<std::size_t> simplified(const std::vector<Vec2> &points, double error);

} // namespace fff
