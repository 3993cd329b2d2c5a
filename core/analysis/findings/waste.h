// Chips that slits cut off: waste, which is no part.
#pragma once

#include "core/analysis/finder.h"

namespace fff {

/// Of kWaste.
struct Waste
{
    int chips = 0;
};

extern const FindingKind kWaste; // one for the whole model

void findWaste(const Looked &at, std::vector<Finding> &found);

} // namespace fff
