#include "core/values/expression_error.h"

#include "core/base/utf8.h"

namespace fff {

namespace {

constexpr std::size_t kMostQuoted = 40; // letters

bool isSteering(char32_t c)
{
    return c < U' ' || (c >= 0x7f && c < 0xa0) || c == 0x2028 || c == 0x2029 || c == 0xfeff ||
           (c >= 0x200b && c <= 0x200f) || (c >= 0x202a && c <= 0x202e) ||
           (c >= 0x2060 && c <= 0x2069);
}

} // namespace

Named quoted(std::string_view text, TextRange place)
{
    std::u32string letters;
    for (std::size_t at = place.begin; at < std::min(place.end, text.size());) {
        if (letters.size() == kMostQuoted) {
            letters.back() = U'\u2026';
            break;
        }
        const char32_t letter = takeLetter(text, at);
        letters.push_back(isSteering(letter) ? U' ' : letter);
    }
    return {encoded(letters)};
}

} // namespace fff
