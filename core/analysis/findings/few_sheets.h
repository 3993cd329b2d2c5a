// Whether there are as many sheets of a stock as its parts may take.
#pragma once

#include "core/analysis/finder.h"
#include "core/fabrication/layout.h"

namespace fff {

/// Of kFewSheets.
struct FewSheets
{
    std::string stock; // its name
    int taken = 0;     // at most: parts lie closer together when they are nested
    int there = 0;
};

extern const FindingKind kFewSheets;

/// layout  of all parts: by boxes, on whole sheets, or as they are nested
void findFewSheets(const Model &model, const Layout &layout, std::vector<Finding> &found);

} // namespace fff
