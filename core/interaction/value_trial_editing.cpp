#include "core/interaction/value_trial_editing.h"

#include "core/analysis/narrowed_ranges.h"

#include <optional>
#include <utility>

namespace fff {

namespace {

constexpr Text kSetValues = FFF_TEXT("Step", "Set the values");
constexpr Text kNarrowRanges = FFF_TEXT("Step", "Narrow the ranges");
constexpr Text kNoneHolds =
    FFF_TEXT("Hint", "No narrower ranges were found in which the model holds.");

SectionEdit editOf(tl::expected<Document, Message> document, const Text &step)
{
    if (document)
        return EditedSections{*std::move(document), {step}};
    Hint hint(std::move(document.error()));
    hint.isRefusal = true;
    return tl::unexpected(std::move(hint));
}

} // namespace

SectionEdit valuesAt(const Document &document, const ValueTrials &trials, const TrialPlace &place)
{
    return editOf(placed(document, trials.values, place), kSetValues);
}

SectionEdit rangesNarrowed(const Model &model, const ValueTrials &trials)
{
    TrialPlace now;
    for (const RangedValue &value : trials.values)
        now.push_back(value.now(model));
    const std::optional<NarrowedRanges> ranges = narrowedRanges(trials, now);
    if (!ranges)
        return editOf(tl::unexpected(Message{kNoneHolds, {}}), kNarrowRanges);
    return editOf(withRanges(model.document, trials, *ranges), kNarrowRanges);
}

} // namespace fff
