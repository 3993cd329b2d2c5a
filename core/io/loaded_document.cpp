#include "core/io/loaded_document.h"

#include <charconv>

namespace fff::io {

std::string placeIn(const std::string &file, const std::string &where)
{
    if (file.empty() || where.empty())
        return file + where;
    return file + ":" + where;
}

std::string quoted(std::string_view text)
{
    std::string result;
    for (const char c : text) {
        // Only before a new character, so that no UTF-8 sequence is cut in two.
        const bool startsCharacter = (static_cast<unsigned char>(c) & 0xC0u) != 0x80u;
        if (result.size() >= kQuotedLength && startsCharacter)
            return result + "…";
        const bool isControl = static_cast<unsigned char>(c) < 0x20u || c == '\x7f';
        result += isControl ? ' ' : c;
        // Bytes that only go on and on are no text.
        if (result.size() >= 2 * kQuotedLength)
            return result;
    }
    return result;
}

std::string shortNumber(double value)
{
    char buffer[32];
    const auto end =
        std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 3);
    return {buffer, end.ptr};
}

std::string_view withoutByteOrderMark(std::string_view bytes)
{
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    return bytes.starts_with(mark) ? bytes.substr(mark.size()) : bytes;
}

} // namespace fff::io
