#include "core/io/loaded_document.h"

#include <charconv>

namespace fff::io {

namespace {

/// Bytes at the start of `text` that would steer a terminal or break the line: control characters
/// of ASCII and of Latin-1 (U+0080 to U+009F), separators of lines and paragraphs. 0: none.
std::size_t controlSequence(std::string_view text)
{
    const auto byte = static_cast<unsigned char>(text.front());
    if (byte < 0x20u || byte == 0x7fu)
        return 1;
    if (byte == 0xC2u && text.size() > 1 && static_cast<unsigned char>(text[1]) < 0xA0u)
        return 2;
    if (text.starts_with("\u2028") || text.starts_with("\u2029"))
        return 3;
    return 0;
}

} // namespace

std::string placeIn(const std::string &file, const std::string &where)
{
    if (file.empty() || where.empty())
        return file + where;
    return file + ":" + where;
}

std::string quoted(std::string_view text)
{
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        // Only before a new character, so that no UTF-8 sequence is cut in two.
        const bool startsCharacter = (static_cast<unsigned char>(text[i]) & 0xC0u) != 0x80u;
        if (result.size() >= kQuotedLength && startsCharacter)
            return result + "…";
        // Bytes that only go on and on are no text.
        if (result.size() >= 2 * kQuotedLength)
            return result;
        const std::size_t control = controlSequence(text.substr(i));
        result += control > 0 ? ' ' : text[i];
        i += control > 0 ? control - 1 : 0;
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
