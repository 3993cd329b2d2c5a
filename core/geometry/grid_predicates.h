// Exact answers about points of the booleans' grid. Internal to geometry.
#pragma once

#include "core/geometry/clip_grid.h"

#include <cmath>
#include <limits>

namespace fff {

__extension__ using Int128 = __int128;

/// On which side of the line from a to b lies p: 1 left, −1 right, 0 on it. In floating point
/// where that is certain, else in 128 bits.
inline int sideOf(const GridPoint &a, const GridPoint &b, const GridPoint &p)
{
    // Both products and their difference are rounded once; the differences below 2^53 are exact.
    constexpr double kProductError = 4.0 * std::numeric_limits<double>::epsilon();
    const std::int64_t bx = b.x - a.x, by = b.y - a.y, px = p.x - a.x, py = p.y - a.y;
    const double left = static_cast<double>(bx) * static_cast<double>(py);
    const double right = static_cast<double>(by) * static_cast<double>(px);
    const double difference = left - right;
    if (std::abs(difference) > kProductError * (std::abs(left) + std::abs(right)))
        return difference > 0.0 ? 1 : -1;
    const Int128 exact = Int128(bx) * Int128(py) - Int128(by) * Int128(px);
    return exact > 0 ? 1 : (exact < 0 ? -1 : 0);
}

} // namespace fff
