// Rings of sections whose joints slide in different directions: the paper's sign of what cannot be
// put together.
#pragma once

#include "core/assembly/joint.h"

namespace fff {

/// Of each joint that holds the shortest ring through it in which not all axes are parallel, as
/// indices of sections; each ring once, the shortest first, then by its sections. A ring begins
/// with its lowest section and goes on to the lower one of its two neighbours. Whether the sections
/// can be put together all the same is for planning to say.
/// O(joints · (sections + joints)) where axes differ, O(joints) where all of them are parallel.
/// Source  paper, section Fabrication (physical assembly).
std::vector<std::vector<int>> cyclesOf(std::size_t sectionCount, const JointList &joints);

} // namespace fff
