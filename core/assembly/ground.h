// The ground, level or not.
#pragma once

#include "core/geometry/vector.h"

namespace fff {

/// A plane that things stand on: up · p = height. Mostly Y = 0; of what leans it is the plane that
/// leans, in the world in which the model was drawn.
struct Ground
{
    Vec3 up = Vec3::UnitY(); // unit
    double height = 0.0;     // mm

    double above(const Vec3 &p) const { return up.dot(p) - height; }
    /// Two axes along it, of X and Z turned as little as can be.
    Vec3 acrossX() const;
    Vec3 acrossZ() const;
};

/// Farther than this nothing is said to lean, it falls (10°, radians).
inline constexpr double kFarthestLean = 0.17453292519943295;

/// Tilted by less than this, something that stands ought not to fall: 10°, as for household
/// equipment (IEC 62368-1, stability). Radians.
inline constexpr double kSteadyTilt = 0.17453292519943295;

} // namespace fff
