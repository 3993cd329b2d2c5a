// Text as the letters that it has.
#pragma once

#include <string>
#include <string_view>

namespace fff {

/// Code points, one after the other; what is no UTF-8 is U+FFFD.
std::u32string decoded(std::string_view text);
/// UTF-8.
std::string encoded(std::u32string_view letters);

} // namespace fff
