// What trials of values (core/analysis/value_trials.h) are good for: to go to a place that was
// tried, and to leave out what does not hold.
#pragma once

#include "core/analysis/value_trials.h"
#include "core/interaction/section_edit.h"

namespace fff {

/// The values as they were in this place.
SectionEdit valuesAt(const Document &document, const ValueTrials &trials, const TrialPlace &place);
/// Ranges in which every place that was tried holds; refused where there are none.
SectionEdit rangesNarrowed(const Model &model, const ValueTrials &trials);

} // namespace fff
