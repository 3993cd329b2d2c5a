// How much a joint gives by itself, besides its sections.
#pragma once

#include "core/physics/structure.h"

#include <Eigen/Core>

namespace fff {

/// Columns: the axes in which a link's stiffness is told: along normalA, square to it and the axis,
/// along the axis.
Eigen::Matrix3d linkAxes(const Link &link);

/// In those axes, of (force, moment): mm/N, then rad/(N·mm). What linkSprings() gives way by, each
/// axis by itself: plates that are not square to each other also couple them, which is left out.
Eigen::Matrix<double, 6, 1> linkCompliance(const Link &link);

} // namespace fff
