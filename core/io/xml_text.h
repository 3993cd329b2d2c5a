// Text within XML. Internal to io.
#pragma once

#include <string>

namespace fff::io {

/// For text and attributes in double quotes. What is no UTF-8 or not allowed in XML becomes U+FFFD.
std::string escaped(const std::string &text);

} // namespace fff::io
