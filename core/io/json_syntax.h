// Parses JSON with errors that name the line, what was found there and what was expected. Internal
// to the readers of core/io and of scripts. Qt reads it, and what is ours here is what sentences
// need: RapidJSON reads faster, but it gives the first of two members of one name, has no limit of
// levels, lets the second half of a character pass, and calls NaN, a comma too many and a sign
// alike.
#pragma once

#include "core/io/problems.h"

#include <QtCore/QJsonDocument>

namespace fff::io {

/// A null document, and an error in `problems` at the line (Truncated, BadSyntax, NonFinite), when
/// the text is not JSON, or has an escape sequence for half a character, or an object has a key
/// twice: what the first one holds would be gone without a word. A byte-order mark at the start is
/// passed over.
QJsonDocument parseJson(std::string_view bytes, Problems &problems);

/// False, with the same error (BadSyntax), for an escape sequence for half a character in what is
/// JSON otherwise, which Qt lets pass: the text could be neither written nor shown.
bool checkCharacters(std::string_view json, Problems &problems);

} // namespace fff::io
