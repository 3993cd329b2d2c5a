#include "core/base/utf8.h"

namespace fff {

char32_t takeLetter(std::string_view text, std::size_t &at)
{
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(at);
    const std::size_t more = first < 0x80 ? 0 : first < 0xe0 ? 1 : first < 0xf0 ? 2 : 3;
    bool isWhole = first < 0x80 || (first >= 0xc2 && first < 0xf5);
    char32_t letter = more == 0 ? first : first & (0x3fU >> more);
    for (std::size_t k = 1; k <= more && isWhole; ++k) {
        isWhole = at + k < text.size() && (byte(at + k) & 0xc0U) == 0x80U;
        letter = isWhole ? (letter << 6U) | (byte(at + k) & 0x3fU) : letter;
    }
    at += isWhole ? more + 1 : 1;
    return isWhole ? letter : U'\ufffd';
}

std::u32string decoded(std::string_view text)
{
    std::u32string letters;
    for (std::size_t i = 0; i < text.size();)
        letters.push_back(takeLetter(text, i));
    return letters;
}

std::string encoded(std::u32string_view letters)
{
    std::string text;
    const auto add = [&text](char32_t byte) { text.push_back(static_cast<char>(byte)); };
    for (const char32_t letter : letters) {
        if (letter < 0x80) {
            add(letter);
        } else if (letter < 0x800) {
            add(0xc0U | (letter >> 6U));
            add(0x80U | (letter & 0x3fU));
        } else if (letter < 0x10000) {
            add(0xe0U | (letter >> 12U));
            add(0x80U | ((letter >> 6U) & 0x3fU));
            add(0x80U | (letter & 0x3fU));
        } else {
            add(0xf0U | (letter >> 18U));
            add(0x80U | ((letter >> 12U) & 0x3fU));
            add(0x80U | ((letter >> 6U) & 0x3fU));
            add(0x80U | (letter & 0x3fU));
        }
    }
    return text;
}

} // namespace fff
