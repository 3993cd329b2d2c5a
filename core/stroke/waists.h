// Where a half comes down to its axis between two of its parts, as at the waist of a wasp.
#pragma once

#include "core/geometry/vector.h"

#include <vector>

namespace fff {

/// The line with its waists drawn up, so that a fit to the tolerance leaves some material there:
/// where a hand that came down to the axis has touched or just missed it, both parts are meant.
///
/// line: u along the axis, v away from it, mm; largest: how far it reaches from the axis, mm.
/// What goes farther under the axis, or runs along it for long, is left as it is, and so is what
/// has no part as high as kWaistPart of `largest` on both sides.
std::vector<Vec2> withWaists(std::vector<Vec2> line, double tolerance, double largest);

inline constexpr double kWaistPart = 0.15;

} // namespace fff
