// How to look straight at a plane.
#pragma once

#include "core/geometry/vector.h"

#include <Eigen/Geometry>

namespace fff {

/// A plane whose normal is this near to the line of sight is seen well enough to draw on: the view
/// does not turn to it (30°).
inline constexpr double kFacedAngle = 0.5235987755982988;

/// Whether a plane with this unit normal is seen so, from either side. towardsEye: unit.
bool isFaced(const Vec3 &normal, const Vec3 &towardsEye);

/// The orientation (as Camera::orientation) that sees a plane with this unit normal frontoparallel,
/// from the side that is nearer to the view from `current`, whatever way the plane leans: so it
/// never goes past what it looks at. Where both are as near (a plane at a right angle to the view),
/// from the side that
///   - does not look up from below by more than a plane that stands nearly upright makes it,
///   - takes the lesser turn; of equal ones the one that moves the eye to its right.
/// It keeps the world's up upright on the screen or, where the plane lies flatter than 45° and up
/// is hardly to be seen, a quarter turn beside it, so that a slit that is drawn nearly level does
/// not end up standing.
Eigen::Quaterniond facingOrientation(const Eigen::Quaterniond &current, const Vec3 &normal);

} // namespace fff
