// How to look straight at a plane.
#pragma once

#include "core/geometry/vector.h"

#include <Eigen/Geometry>

namespace fff {

/// The orientation (as Camera::orientation) that sees a plane with this unit normal frontoparallel
/// after the least turn from `current`, among the views that
///   - do not look up from below,
///   - keep the world's up upright on the screen or, where the plane lies flatter than 45° and up
///     is hardly to be seen, a quarter turn beside it, so that a slit that is drawn nearly level
///     does not end up standing.
/// Of equal turns (a plane at a right angle to the view) the one that moves the eye to its right.
Eigen::Quaterniond facingOrientation(const Eigen::Quaterniond &current, const Vec3 &normal);

} // namespace fff
