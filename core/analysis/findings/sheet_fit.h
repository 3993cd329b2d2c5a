// Whether all parts fit the sheets of their stocks.
#pragma once

#include "core/analysis/finder.h"

namespace fff {

/// Of kFitsSheet.
struct SheetUse
{
    int sheets = 0;            // 0: not counted, where there are offcuts as well
    Vec2 sheet = Vec2::Zero(); // size, mm; zero where they are of several sizes
    double share = 0.0;        // of the sheets' area that parts cover, 0 … 1
};
/// Of kTooLarge.
struct TooLargePart
{
    Vec2 size = Vec2::Zero();  // as designed, its longer side first, mm
    Vec2 sheet = Vec2::Zero(); // mm
    double margin = 0.0;       // that the sheet's edges leave free, mm
    int parts = 1;             // of that section that do not fit
};

extern const FindingKind kFitsSheet;
extern const FindingKind kTooLarge;   // one a section with such a part
extern const ActionKind kChooseSheet; // for the stock of its section

void findSheetFit(const Looked &at, std::vector<Finding> &found);

} // namespace fff
