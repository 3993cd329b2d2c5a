// Whether all parts fit the sheets of their stocks.
#pragma once

#include "core/analysis/finder.h"

#include <optional>

namespace fff {

struct Nested;

/// Of kFitsSheet.
struct SheetUse
{
    int sheets = 0;            // 0: not counted, where there are offcuts as well
    Vec2 sheet = Vec2::Zero(); // size, mm; zero where they are of several sizes
    /// Parts lie there. Else they were packed by their boxes alone: it takes no more sheets when
    /// they are nested, and how much of these will be used is not known.
    bool isNested = false;
    double share = 0.0; // of nested ones: of the sheets, what parts cover, 0 … 1
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
/// As the parts of that analysis lie on their sheets, and as Export writes them. Nothing where they
/// do not all.
std::optional<SheetUse> sheetUseOf(const Nested &nested);

} // namespace fff
