// How far one direction turns from another.
#pragma once

#include "core/geometry/vector.h"

#include <cmath>

namespace fff {

/// From a to b, radians, −π … π, positive to the left.
inline double signedTurn(const Vec2 &a, const Vec2 &b)
{
    return std::atan2(cross(a, b), a.dot(b));
}

/// Between the two, radians, 0 … π.
inline double turnBetween(const Vec2 &a, const Vec2 &b)
{
    return std::abs(signedTurn(a, b));
}

} // namespace fff
