// Edits of what is drawn on sections (core/model/mark.h). Marks are named by their place in the
// section's list. Errors of all: UnknownReference, place = the id; BadValue, place "mark", for one
// that is not there or has no lines.
#pragma once

#include "core/model/document.h"

namespace fff {

Result<Document> addMark(Document document, SectionId id, MarkPointer mark);
Result<Document> setMark(Document document, SectionId id, std::size_t index, MarkPointer mark);
Result<Document> removeMark(Document document, SectionId id, std::size_t index);

} // namespace fff
