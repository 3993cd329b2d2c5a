// What is up. Internal to assembly.
#pragma once

#include "core/geometry/vector.h"

#include <cmath>

namespace fff {

/// Upwards is +Y; for a level axis +X, then +Z, so that the answer does not hang on rounding.
/// direction: unit, in the world.
inline bool pointsUp(const Vec3 &direction)
{
    // Components of a unit direction below this are rounding.
    constexpr double kLevel = 1e-6;
    for (const double component : {direction.y(), direction.x(), direction.z()})
        if (std::abs(component) > kLevel)
            return component > 0.0;
    return true;
}

} // namespace fff
