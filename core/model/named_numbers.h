// Edits of the numbers that have names (core/model/named_number.h).
#pragma once

#include "core/base/expression.h"
#include "core/model/document.h"

#include <string_view>

namespace fff {

/// A letter or _, then letters, digits and _ of ASCII, no more than kMaxNameLength; "t" is taken,
/// by the thickness, and so are the signs of units: a name that reads as mm, cm, m, in, inch or ft.
bool isNumberName(std::string_view name);
/// Null when there is none. Upper and lower case are the same.
const NamedNumber *findNumber(const Document &document, std::string_view name);

/// Gives the number its value, or adds it at the end. Errors  BadValue, place "name" or "value".
Result<Document> setNumber(Document document, NamedNumber number);
/// Errors  UnknownReference, place = the name: there is none, or, for the new one, there is one.
Result<Document> removeNumber(Document document, std::string_view name);
Result<Document> renameNumber(Document document, std::string_view name, std::string to);

/// What may be typed in place of those numbers that stand before one; capitals or not are the same.
/// Reads each of them once.
NumberNames namesBefore(const Document &document, std::size_t index);

/// As setNumber(), with what an expression of lengths, plain numbers and the names before it is
/// worth; those behind it that are made of it follow. Errors  the expression that cannot be read.
///
/// name  isNumberName()
tl::expected<Document, Expression> setExpression(Document document, const std::string &name,
                                                 const std::string &expression, Commas commas);

inline constexpr std::size_t kMaxNameLength = 40;

} // namespace fff
