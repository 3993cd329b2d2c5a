// Parts that stay where they lie while the others are nested around them. Internal to nestOut().
#pragma once

#include "core/fabrication/nested_layout.h"

#include <vector>

namespace fff {

/// Unlimited sheets of that size, mm, with nothing to lay on them yet.
nest::Problem plainSheets(const Vec2 &size, const LayoutOptions &options);

/// A sheet for each up to the last that has pinned parts, once; then plain ones, as many as it
/// takes. Others lie off what is pinned by the spacing, off the edge by the margin.
nest::Problem sheetsAround(const std::vector<Part> &parts, const Vec2 &size,
                           const LayoutOptions &options, const std::vector<PinnedPart> &pinned);
/// How many of its kinds have a sheet of their own.
int kindsAround(const std::vector<PinnedPart> &pinned);

struct SoundPins
{
    std::vector<PinnedPart> pinned; // that can stay, all of them
    std::vector<int> loosened;      // parts of the others
};

/// pinned  of one stock, whose sheets have that size, mm. A sheet that no number of parts could
///         need is none; of one part the first place counts.
/// Looked at by nest::faultOf(): exactly.
SoundPins soundPins(const std::vector<Part> &parts, const Vec2 &size, const LayoutOptions &options,
                    std::vector<PinnedPart> pinned);

} // namespace fff
