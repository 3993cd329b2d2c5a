// Parses JSON with errors that name the line, what was found there and what was expected. Internal
// to the readers of core/io.
#pragma once

#include "core/io/problems.h"

#include <QtCore/QJsonDocument>

namespace fff::io {

/// A null document, and an error in `problems` (Truncated, BadSyntax, NonFinite), when the text is
/// not JSON. A byte-order mark at the start is passed over.
QJsonDocument parseJson(std::string_view bytes, Problems &problems);

} // namespace fff::io
