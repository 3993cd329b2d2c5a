// Which values are made of which.
#pragma once

#include "core/values/values.h"

#include <map>
#include <string>
#include <vector>

namespace fff {

/// By index in the list.
struct ValueGraph
{
    std::map<std::string, int, std::less<>> byName; // folded; of two alike the one of the lower id
    std::vector<std::vector<int>> uses;             // each once, as they are first seen in its text
    std::vector<std::vector<int>> users;            // ascending
    std::vector<int> order;                         // each behind all that it uses, but for circles
    /// Of those on one way round a circle: its members from this one on, and -1 behind the first
    /// twelve of many. Who is only in other circles with them has none, but isInCircle.
    std::vector<std::vector<int>> circles;
    std::vector<bool> isInCircle;
};

/// O(values and uses · log values), without recursion. Follows R. Tarjan 1972, "Depth-first search
/// and linear graph algorithms", whose components come out in the order that is wanted.
ValueGraph graphOf(const Values &values);

} // namespace fff
