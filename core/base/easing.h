// How animations go from 0 to 1.
#pragma once

#include <algorithm>

namespace fff {

/// Starts and ends gently (cubic in and out). u is clamped to 0 … 1.
constexpr double easeInOutCubic(double u)
{
    const double v = std::clamp(u, 0.0, 1.0);
    const double w = 2.0 - 2.0 * v;
    return v < 0.5 ? 4.0 * v * v * v : 1.0 - 0.5 * w * w * w;
}

} // namespace fff
