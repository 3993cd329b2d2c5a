// What edits of how parts lie on their sheets make of the document: shared by the dock's hand and
// keys, its fields and commands. Refused with EditFailed where a section is not there, or a place
// is none.
#pragma once

#include "core/interaction/section_edit.h"
#include "core/model/model.h"
#include "core/model/sheet_wishes.h"

#include <optional>
#include <span>
#include <vector>

namespace fff {

enum class PlacingBy {
    Hand, // each one is a step
    Key,  // those of the same part after each other are one step
};

/// A part is put there, and stays.
SectionEdit placedOnSheet(const Model &model, const PinnedPlace &place,
                          PlacingBy by = PlacingBy::Hand);
/// Parts stay where they lie.
SectionEdit pinnedOnSheets(const Model &model, const std::vector<PinnedPlace> &places);
/// Parts of these sections are laid with the others again.
SectionEdit unpinned(const Model &model, std::span<const SectionRef> sections);
SectionEdit allUnpinned(const Model &model);
/// How parts of these sections may be turned on their sheets. None: as all others.
SectionEdit turnedOnSheets(const Model &model, std::span<const SectionRef> sections,
                           std::optional<nest::Turning> turning);

} // namespace fff
