// What fingers hold between each other. Internal to assembly.
#pragma once

#include "core/assembly/joint_grips.h"

namespace fff {

/// Of a joint that has fingers (areFingers()): a finger of the one is held over the depth to which
/// one piece of the other stands kGripWall beside both of its flanks, all fingers together. Of two
/// pieces that hold each other so over gripDepth(), one that does is enough.
JointGrips fingerGrips(const Joint &joint, const GripSide &a, const GripSide &b);

} // namespace fff
