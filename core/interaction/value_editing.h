// What edits of values with names make of the document, and of numbers that are made of them:
// shared by the dock, fields and commands. What would make a value or a number wrong is refused
// with the sentence that says why (newlyWrong(), core/operations/driven.h).
#pragma once

#include "core/interaction/section_edit.h"
#include "core/model/bindings.h"

#include <string>

namespace fff {

/// At the end of the list.
SectionEdit valueAdded(const Document &document, Value value);
/// Of the same id. merges: as Step's.
SectionEdit valueChanged(const Document &document, Value value, std::string merges = {});
/// Also in all that is made of it.
SectionEdit valueRenamed(const Document &document, ValueId id, const std::string &name);
/// What was made of it is plain numbers then; the note says how many.
SectionEdit valueRemoved(const Document &document, ValueId id);

/// What is set now of the shown values, under that name; one that has it already is replaced.
SectionEdit presetKept(const Document &document, const std::string &name);
/// All of its settings at once.
SectionEdit presetTaken(const Document &document, const std::string &name);
SectionEdit presetRemoved(const Document &document, const std::string &name);

/// The number follows this text from now on; a plain number is set once.
SectionEdit numberBound(const Document &document, const DrivenPlace &place, std::string typed,
                        const Reading &reading);
/// It stays as it is, by itself.
SectionEdit numberReleased(const Document &document, const DrivenPlace &place);

/// Whoever opens the model adjusts its shown values, and no more; or has all of it again.
SectionEdit handedOn(const Document &document, bool isHandedOn);
bool hasShownValue(const Values &values);

/// For a new value: this one, or the first of it with a number that no value has.
std::string freeValueName(const Values &values, const std::string &wanted);

} // namespace fff
