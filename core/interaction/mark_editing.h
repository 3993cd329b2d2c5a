// What edits of that which is drawn on sections make of the document: shared by the tool, commands
// and the fields of the window.
#pragma once

#include "core/interaction/section_edit.h"
#include "core/model/mark.h"
#include "core/model/model.h"

namespace fff {

/// On the section that the ref is an image of. Refused where that is locked or made by an
/// operation in its own way.
SectionEdit markAdded(const Model &model, const SectionRef &section, MarkPointer mark);
SectionEdit markRemoved(const Model &model, const SectionRef &section, std::size_t index);
SectionEdit markKindChanged(const Model &model, const SectionRef &section, std::size_t index,
                            Mark::Kind kind);
/// A mark of words. Refused (LetterUnknown) where the alphabet has one of its letters not.
SectionEdit letteringAdded(const Model &model, const SectionRef &section,
                           const Lettering &lettering, Mark::Kind kind);
/// A mark that has words. Changes of the same one after each other are one step.
SectionEdit letteringChanged(const Model &model, const SectionRef &section, std::size_t index,
                             const Lettering &lettering);

} // namespace fff
