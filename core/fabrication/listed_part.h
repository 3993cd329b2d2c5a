// A line of the list of parts.
#pragma once

#include "core/base/ids.h"
#include "core/geometry/vector.h"

#include <string>
#include <vector>

namespace fff {

/// Parts that are the same but for their engraved numbers.
struct ListedPart
{
    std::vector<int> numbers; // ascending, as engraved; as many as there are of it
    std::string name;         // of the first one's section
    StockId stock;
    Vec2 size = Vec2::Zero(); // of its box as it was drawn, mm, without the kerf
    double area = 0.0;        // mm², the same
};

} // namespace fff
