// Small loops that are round.
#pragma once

#include "core/geometry/bezier.h"

#include <optional>
#include <vector>

namespace fff {

/// The ellipse that a small closed line lies about, as four segments from where it begins round to
/// there: an eye of ten pixels has no corners that anybody meant, but each of its samples is off by
/// a part of a pixel, which is much of it. None where it is no ellipse, where its ends are apart,
/// or where it is large enough to be fitted as drawn, kSmall tolerances or more.
///
/// line       without what its ends have too much (line_ends.h)
/// tolerance  that a stroke is fitted to where it is large, mm
std::optional<std::vector<CubicBezier>> smallRound(const std::vector<Vec2> &line, double tolerance);

inline constexpr double kSmall = 25.0;

} // namespace fff
