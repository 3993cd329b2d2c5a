// The edits of how parts lie on their sheets (sheet_wishes.h). Each pin and each turning stands
// once in a document, in the order of sections. Errors of all: UnknownReference, place = the id,
// for a drawn section that is not there.
#pragma once

#include "core/base/result.h"
#include "core/model/document.h"

#include <functional>
#include <optional>
#include <span>

namespace fff {

/// Null where that part is not pinned.
const PinnedPlace *pinOf(const Document &document, const SectionRef &section, int body);

/// The part stays there from now on. Errors also: BadValue, place "sheet", "body", "turn" or
/// "offset" for what makes no sense.
Result<Document> setPin(Document document, const PinnedPlace &place);
/// Parts of these sections are laid with the others again.
Document withoutPins(Document document, std::span<const SectionRef> sections);

/// None: as all others.
Result<Document> setTurning(Document document, const SectionRef &section,
                            std::optional<nest::Turning> turning);
/// What is wanted of the section itself, else of what an operation copied it from; none: nothing.
std::optional<nest::Turning> turningOf(const Document &document, const Section &section);

/// All that is wanted of sections that are gone goes with them.
void forgetSheetWishes(Document &document, const std::function<bool(const SectionRef &)> &isGone);
/// Under other names: `follow` gives that of now. Of two with one name the first one stays.
void renameSheetWishes(Document &document,
                       const std::function<SectionRef(const SectionRef &)> &follow);

} // namespace fff
