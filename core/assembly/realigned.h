// An assembly whose sections have got other places in the model. Internal to assembly.
#pragma once

#include "core/assembly/joint.h"

#include <vector>

namespace fff {

struct Realigned
{
    /// Rows for the new places; joints and slits of sections that are gone are left out. Joints
    /// have new ids, slits still have the old ones.
    Assembly assembly;
    bool hasNewIds = false;
};

/// places: of each section now its index before, or −1; those that were there stand in the order in
/// which they stood. O(joints).
Realigned realigned(const Assembly &before, const std::vector<int> &places);

} // namespace fff
