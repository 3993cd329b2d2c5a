// Edits of a document's values, and of what is bound to them. What an expression comes to is worked
// out before operations are (core/operations/driven.h); these edits change no number.
#pragma once

#include "core/model/document.h"
#include "core/values/value_edits.h"

#include <string>
#include <vector>

namespace fff {

/// Appends it; its id is the document's nextId. Errors  those of addedValue().
Understood<Document> addValue(Document document, Value value);
/// Of the same id. Errors  those of changedValue().
Understood<Document> changeValue(Document document, Value value);
/// What was typed for it, and nothing else.
Understood<Document> typeValue(Document document, ValueId id, std::string typed,
                               const Reading &reading);
/// Also in all that is made of it: values and what is bound.
Understood<Document> renameValue(Document document, ValueId id, const std::string &name);

struct RemovedValue
{
    Document document;
    int users = 0; // values and numbers that were made of it, and are what they were, without it
};
/// The document as it is where there is no such value.
RemovedValue removeValue(const Document &document, ValueId id);

/// The binding of this number; null: it is a number by itself. O(log bindings)
const Binding *bindingOf(const Document &document, const DrivenPlace &place);
/// In place of the one that the number has. Nothing is looked up or worked out.
Document withBinding(Document document, Binding binding);
/// The number is one by itself. The document as it is where it is that already.
Document withoutBinding(Document document, const DrivenPlace &place);
/// That name the value, or are made of values that are made of it.
std::vector<DrivenPlace> boundTo(const Document &document, const EvaluatedValues &evaluated,
                                 ValueId id);

/// Its width, its height or a dimension on it follows an expression.
bool isStretchedByValues(const Document &document, SectionId section);

/// The values' names, and "t", the thickness of what the place is on, where that has one.
Names namesAt(const Document &document, const DrivenPlace &place, const Names &values);

} // namespace fff
