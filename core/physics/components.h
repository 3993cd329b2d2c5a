// What of a structure hangs together, whether or not the ground joins it.
#pragma once

#include "core/physics/structure.h"

#include <vector>

namespace fff {

/// Members that links join to one another, with what is on them: indices into the structure's
/// lists, ascending.
struct Component
{
    std::vector<int> members, links, feet, loads;
};

/// Whether all that mechanics asks of it is finite and of a member that is there. What is not is
/// left out of everything.
bool isSound(const Structure &structure, const Link &link);
bool isSound(const Structure &structure, const Foot &foot);
bool isSound(const Structure &structure, const MemberLoad &load);
bool isSound(const Member &member);
/// Whether all of it is.
bool isSound(const Structure &structure);

/// Ordered by their first member. O(all, nearly).
std::vector<Component> components(const Structure &structure);

} // namespace fff
