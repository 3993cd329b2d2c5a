// Angles as findings say them.
#pragma once

#include "core/base/message.h"

#include <numbers>

namespace fff {

/// Nearest to it: whole degrees are written rounded down, as what something bears has to be.
inline Quantity nearestAngleOf(double radians)
{
    constexpr double kOneDegree = std::numbers::pi / 180.0;
    return angleOf(radians < kOneDegree ? radians : radians + 0.5 * kOneDegree);
}

} // namespace fff
