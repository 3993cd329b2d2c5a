// Parts that stay where they lie while the others are nested around them. Internal to nestOut().
#pragma once

#include "core/fabrication/nested_layout.h"
#include "core/fabrication/sheet_supply.h"

#include <vector>

namespace fff {

/// The sheets that there are, each up to the last whole one that has pinned parts once, then plain
/// ones, as many as it takes. Others lie off what is pinned by the spacing, off the edge by the
/// margin.
nest::Problem sheetsAround(const std::vector<Part> &parts, const SheetSupply &supply,
                           const LayoutOptions &options, const std::vector<PinnedPart> &pinned);
/// How many whole sheets there are up to the last one of these.
int wholeSheetsOf(const std::vector<PinnedPart> &pinned);

struct SoundPins
{
    std::vector<PinnedPart> pinned; // that can stay, all of them
    std::vector<int> loosened;      // parts of the others
};

/// pinned  of one stock. A sheet that there is not, or that no number of parts could need, is none;
///         of one part the first place counts.
/// Looked at by nest::faultOf(): exactly.
SoundPins soundPins(const std::vector<Part> &parts, const SheetSupply &supply,
                    const LayoutOptions &options, std::vector<PinnedPart> pinned);

} // namespace fff
