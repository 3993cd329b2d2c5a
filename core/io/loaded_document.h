// What the readers of core/io hand back, and what their phrases have in common.
#pragma once

#include "core/model/document.h"

#include <string>
#include <string_view>
#include <vector>

namespace fff::io {

struct Format;

/// A whole document; `warnings` say what in it is not quite as the file has it, in file order.
struct LoadedDocument
{
    Document document;
    std::vector<Warning> warnings;
    const Format *format = nullptr; // set by readDocument()
};

/// Where in a file: "fish.txt:340", "fish.fff:$.sections[3]"; only `where` without a file name.
std::string placeIn(const std::string &file, const std::string &where);

/// A piece of a file as an error may quote it: one line, without control characters, at most
/// kQuotedLength bytes and then "…".
std::string quoted(std::string_view text);
inline constexpr std::size_t kQuotedLength = 40;

/// To three digits, for sentences: no file format is written with it.
std::string shortNumber(double value);

/// The text behind a byte-order mark of UTF-8, if it starts with one.
std::string_view withoutByteOrderMark(std::string_view bytes);

} // namespace fff::io
