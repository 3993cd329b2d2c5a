#include "core/base/letters.h"

#include "core/base/utf8.h"

#include <algorithm>

namespace fff {

bool isBlank(char32_t c)
{
    return c == U' ' || (c >= U'\t' && c <= U'\r') || c == U'\u0085' || c == U'\u00a0' ||
           c == U'\u1680' || (c >= U'\u2000' && c <= U'\u200a') || c == U'\u2028' ||
           c == U'\u2029' || c == U'\u202f' || c == U'\u205f' || c == U'\u3000';
}

bool isDigit(char32_t c)
{
    return c >= U'0' && c <= U'9';
}

bool isLetter(char32_t c)
{
    if (c < U'\u00c0')
        return (c >= U'a' && c <= U'z') || (c >= U'A' && c <= U'Z') || c == U'\u00aa' ||
               c == U'\u00b5' || c == U'\u00ba';
    const bool isSign = c == U'\u00d7' || c == U'\u00f7' || isBlank(c) ||
                        (c >= U'\u2000' && c < U'\u2100') || (c >= U'\u2190' && c < U'\u2c00') ||
                        (c >= U'\u3001' && c < U'\u3040') || c >= U'\ufe00';
    return !isSign;
}

bool isNameLetter(char32_t c)
{
    return isLetter(c) || c == U'_';
}

char32_t folded(char32_t c)
{
    const auto within = [c](char32_t first, char32_t last) { return c >= first && c <= last; };
    if (within(U'A', U'Z') || (within(0xc0, 0xde) && c != 0xd7) || within(0x391, 0x3a9) ||
        within(0x410, 0x42f))
        return c + 0x20;
    if (within(0x400, 0x40f))
        return c + 0x50;
    // Latin with marks beyond the first 256: large and small take turns.
    const bool evenIsLarge = within(0x100, 0x12f) || within(0x132, 0x137) || within(0x14a, 0x177);
    const bool oddIsLarge = within(0x139, 0x148) || within(0x179, 0x17e);
    if ((evenIsLarge && c % 2 == 0) || (oddIsLarge && c % 2 == 1))
        return c + 1;
    return c == 0x178 ? U'\u00ff' : c;
}

std::string foldedName(std::string_view name)
{
    std::u32string letters = decoded(name);
    std::transform(letters.begin(), letters.end(), letters.begin(),
                   [](char32_t c) { return folded(c); });
    return encoded(letters);
}

} // namespace fff
