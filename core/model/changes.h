// What differs between two models that one edit lies between.
#pragma once

#include "core/model/model.h"

#include <optional>
#include <vector>

namespace fff {

/// The sections of `after`, drawn and generated, that `before` does not have as they are: added or
/// changed ones, and those whose stock was changed. Sorted. Compares pointers, and values where
/// those differ: what an edit leaves alone costs one comparison.
std::vector<SectionRef> changedSections(const Model &before, const Model &after);

/// The sections, as they stand in either of the models, that `now` does not have: what a step
/// between them takes away or would bring back. Compares as changedSections().
std::vector<SectionPointer> missingSections(const Model &before, const Model &after,
                                            const Model &now);

/// Of each section of `now` its index in `before`, or −1, by what it is called; nothing when all
/// that both have stand at the same places, so that what is derived from them can be kept as it is.
/// O(sections).
std::optional<std::vector<int>> placesBefore(const Model &now, const Model &before);

} // namespace fff
