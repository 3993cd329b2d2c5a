// Files that are packed with gzip. Internal to io.
#pragma once

#include "core/base/result.h"

#include <string>
#include <string_view>

namespace fff::io {

/// By the first bytes, whatever the file is called.
bool isCompressed(std::string_view bytes);

/// What is packed in there, of one packed file or several behind each other.
/// place  how errors call the file
/// Errors  BadSyntax for what is damaged, Truncated for what ends too early, BadCount for more than
///         `most` bytes: a few thousand can stand for a billion.
Result<std::string> uncompressed(std::string_view bytes, std::size_t most,
                                 const std::string &place);

} // namespace fff::io
