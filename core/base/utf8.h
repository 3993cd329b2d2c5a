// Text as the letters that it has.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fff {

/// The code point that begins at the byte `at`, which is moved behind it; U+FFFD for a byte that is
/// no UTF-8.
char32_t takeLetter(std::string_view text, std::size_t &at);
/// Code points, one after the other; what is no UTF-8 is U+FFFD.
std::u32string decoded(std::string_view text);
/// UTF-8.
std::string encoded(std::u32string_view letters);

} // namespace fff
