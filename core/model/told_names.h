// A document whose names are told in another language.
#pragma once

#include "core/model/document.h"

#include <functional>
#include <string>

namespace fff {

/// What a name, or a note, is in the other language; the same where it has no other word there.
using Told = std::function<std::string(const std::string &name)>;

/// Names of sections, operations, loads, values and presets, headings and notes of values. A number
/// at the end of a name stays: "Rib 2" is asked for as "Rib". A value whose name there cannot be
/// one keeps its own.
Document withNamesTold(Document document, const Told &told);

} // namespace fff
