// Which numbers of a document an expression can drive: one table, which scripts, files, fields and
// the pass before operations (driven.h) read. A kind of number is its line in a file driven_*.cpp.
#pragma once

#include "core/base/message.h"
#include "core/model/bindings.h"

#include <optional>
#include <string>
#include <vector>

namespace fff {

/// A number, a switch, a choice or a text that can be driven, as it is now.
struct DrivenNumber
{
    ValueKind kind = ValueKind::Number;
    Worth worth; // of that kind: mm, radians, kg, or plain
    Text label;  // "Thickness"
};

/// Nothing where the document has no such number: what has it is gone, or the field is none.
std::optional<DrivenNumber> drivenNumber(const Document &document, const DrivenPlace &place);
/// By the edit that a person does, so that all follows as after that.
/// Errors  those of that edit; UnknownReference, place = the key, where there is no such number.
Result<Document> withDrivenNumber(Document document, const DrivenPlace &place, const Worth &worth);

/// All of a document, ascending.
std::vector<DrivenPlace> drivablePlaces(const Document &document);
/// What a script calls it: "stock/1/thickness", "operation/9/count", "figure/5/0/diameter",
/// "joint/3/7/0/share".
std::string keyOf(const DrivenPlace &place);
std::optional<DrivenPlace> placeOfKey(const Document &document, const std::string &key);
/// "Birch plywood, Thickness"
Message nameOf(const Document &document, const DrivenPlace &place);

} // namespace fff
