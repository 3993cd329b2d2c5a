// What is said of joints to a person: kinds, directions, and why something cannot be had.
#pragma once

#include "core/assembly/joint_state.h"

#include <QString>

namespace fff::ui {

/// "cross lap", for the middle of a line
QString jointKindText(JointKind kind);
/// "Cross lap", to be chosen
QString jointKindName(JointKind kind);
/// A whole sentence without its full stop; empty for no obstacle.
QString jointObstacleText(JointObstacle obstacle);
/// "Up", "Left" and so on: the world's axis that is nearest to the direction.
QString directionName(const Vec3 &direction);

} // namespace fff::ui
