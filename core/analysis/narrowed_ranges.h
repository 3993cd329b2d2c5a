// Ranges of values in which all is well, as far as it was tried.
#pragma once

#include "core/analysis/value_trials.h"

#include <optional>
#include <vector>

namespace fff {

struct NarrowedRange
{
    double least = 0.0, most = 0.0;   // of numbers, as in RangedValue
    std::vector<std::string> choices; // of a choice: those that are left
    bool operator==(const NarrowedRange &) const = default;
};

struct NarrowedRanges
{
    std::vector<NarrowedRange> ranges; // one a value, as they are in the trials
    std::optional<TrialPlace> moves;   // where the values have to go; none: they stay
};

/// Part of the ranges, found greedily, in which every place that was tried holds and at least one
/// was: as long as there are others, the cut is made that keeps `now` inside, if that can be, most
/// places and most of the range. Values stay at `now`, or go to the first place that holds there.
/// Nothing where no place holds, or a switch alone decides.
/// O(places³ · values)
std::optional<NarrowedRanges> narrowedRanges(const ValueTrials &trials, const TrialPlace &now);

/// The document with these ranges. Errors  as placed() has them.
tl::expected<Document, Message> withRanges(const Document &document, const ValueTrials &trials,
                                           const NarrowedRanges &ranges);

} // namespace fff
