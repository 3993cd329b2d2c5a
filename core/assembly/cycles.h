// Rings of sections whose joints slide in different directions: the paper's sign of what cannot be
// put together.
#pragma once

#include "core/assembly/joint.h"

namespace fff {

/// Whether ways to slide are one, or each other's opposite; of unit vectors, to
/// kPracticallyParallel.
bool areParallel(const Vec3 &a, const Vec3 &b);

/// Rings in which not all axes are parallel, as indices of sections: for each joint that holds, but
/// those of one direction (that of most, if there is such a one: without the others there is no
/// such ring), a shortest one through it. Each ring once, the shortest first, then by its sections.
/// A ring begins with its lowest section and goes on to the lower one of its two neighbours.
/// Whether the sections can be put together all the same is for planning to say. O(joints of other
/// directions · (sections + joints)). Source  paper, section Fabrication (physical assembly).
std::vector<std::vector<int>> cyclesOf(std::size_t sectionCount, const JointList &joints);

} // namespace fff
