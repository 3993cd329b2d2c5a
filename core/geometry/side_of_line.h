// On which side of a line a point lies, exactly: for answers that steer topology.
#pragma once

#include "core/geometry/vector.h"

#include <cmath>

namespace fff {

/// The same, always worked out exactly; slower.
double exactSideOfLine(const Vec2 &a, const Vec2 &b, const Vec2 &c);

/// Positive when c lies to the left of the way from a to b, negative to the right, 0 on the line.
/// Only the sign is exact.
/// Source  J. R. Shewchuk 1997, Adaptive precision floating-point arithmetic: the first filter.
inline double sideOfLine(const Vec2 &a, const Vec2 &b, const Vec2 &c)
{
    constexpr double kError = 3.4e-16;
    const double left = (b.x() - a.x()) * (c.y() - a.y());
    const double right = (b.y() - a.y()) * (c.x() - a.x());
    const double difference = left - right;
    if (std::abs(difference) > kError * (std::abs(left) + std::abs(right)))
        return difference;
    return exactSideOfLine(a, b, c);
}

} // namespace fff
