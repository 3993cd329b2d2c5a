// Where two outlines meet, pair by pair, and which of these meetings are one corner.
#pragma once

#include "core/base/long_work.h"
#include "core/base/result.h"
#include "core/skin/skin_outline.h"

#include <array>
#include <vector>

namespace fff {

struct OutlinePlace
{
    int outline = 0;
    double along = 0.0; // mm
};

struct OutlineMeeting
{
    std::array<OutlinePlace, 2> places; // of two outlines
    int corner = 0; // those of three sections that meet in one place have the same, 0 … n − 1
};

/// outlines  those of the sections. Errors  Cancelled.
Result<std::vector<OutlineMeeting>> outlineMeetings(const std::vector<SectionPointer> &sections,
                                                    const std::vector<SkinOutline> &outlines,
                                                    const LongWork &work);

} // namespace fff
