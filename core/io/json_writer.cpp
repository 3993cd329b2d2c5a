#include "core/io/json_writer.h"

#include <cassert>
#include <charconv>
#include <cmath>

namespace fff::io {

namespace {

/// Length in bytes of the UTF-8 sequence at the start of `text`, 0 when there is no valid one
/// (Unicode 15, table 3-7: no overlong forms, no surrogates, nothing above U+10FFFF).
std::size_t utf8Length(std::string_view text)
{
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80)
        return 1;
    const std::size_t length = lead >= 0xC2 && lead <= 0xDF   ? 2
                               : lead >= 0xE0 && lead <= 0xEF ? 3
                               : lead >= 0xF0 && lead <= 0xF4 ? 4
                                                              : 0;
    if (length == 0 || text.size() < length)
        return 0;
    const unsigned char low = lead == 0xE0 ? 0xA0 : lead == 0xF0 ? 0x90 : 0x80;
    const unsigned char high = lead == 0xED ? 0x9F : lead == 0xF4 ? 0x8F : 0xBF;
    if (byte(1) < low || byte(1) > high)
        return 0;
    for (std::size_t i = 2; i < length; ++i) {
        if (byte(i) < 0x80 || byte(i) > 0xBF)
            return 0;
    }
    return length;
}

/// The escape of a character that JSON does not take as it is, or nothing.
std::string escape(char c)
{
    switch (c) {
    case '"':
        return "\\\"";
    case '\\':
        return "\\\\";
    case '\n':
        return "\\n";
    case '\r':
        return "\\r";
    case '\t':
        return "\\t";
    default:
        break;
    }
    const auto code = static_cast<unsigned char>(c);
    if (code >= 0x20 && code != 0x7F)
        return {};
    constexpr std::string_view digits = "0123456789abcdef";
    return std::string("\\u00") + digits[code >> 4] + digits[code & 0xF];
}

} // namespace

void JsonWriter::beginObject(Layout layout)
{
    begin('{', {.isObject = true, .isLine = layout == Layout::Line});
}

void JsonWriter::endObject()
{
    end('}', true);
}

void JsonWriter::beginArray(Layout layout, int itemsPerLine)
{
    assert(itemsPerLine > 0 && "a line holds at least one item");
    begin('[', {.isLine = layout == Layout::Line, .itemsPerLine = itemsPerLine});
}

void JsonWriter::endArray()
{
    end(']', false);
}

void JsonWriter::key(std::string_view name)
{
    assert(!m_levels.empty() && m_levels.back().isObject && !m_hasKey &&
           "a key stands in an object, once before its value");
    separate();
    appendText(name);
    m_text += ": ";
    m_hasKey = true;
}

void JsonWriter::value(std::string_view text)
{
    beforeValue();
    appendText(text);
}

void JsonWriter::value(double number)
{
    assert(std::isfinite(number) && "JSON has no nan and no infinity");
    if (!std::isfinite(number)) {
        m_sawNonFinite = true;
        null();
        return;
    }
    char buffer[32]; // the longest double has 24 characters
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, number == 0.0 ? 0.0 : number);
    raw(std::string_view(buffer, static_cast<std::size_t>(end.ptr - buffer)));
}

void JsonWriter::value(bool truth)
{
    raw(truth ? "true" : "false");
}

void JsonWriter::null()
{
    raw("null");
}

void JsonWriter::value(const Vec2 &point)
{
    value(std::span<const double>(point.data(), 2));
}

void JsonWriter::value(const Vec3 &point)
{
    value(std::span<const double>(point.data(), 3));
}

void JsonWriter::value(std::span<const double> numbers)
{
    beginArray(Layout::Line);
    for (const double number : numbers)
        value(number);
    endArray();
}

std::string JsonWriter::take()
{
    assert(m_levels.empty() && "everything that was begun has ended");
    m_text += '\n';
    return std::move(m_text);
}

void JsonWriter::begin(char bracket, Level level)
{
    beforeValue();
    // What stands on one line keeps all that is inside on it.
    level.isLine = level.isLine || (!m_levels.empty() && m_levels.back().isLine);
    m_text += bracket;
    m_levels.push_back(level);
}

void JsonWriter::end(char bracket, [[maybe_unused]] bool isObject)
{
    assert(!m_levels.empty() && m_levels.back().isObject == isObject && !m_hasKey &&
           "an end closes what was begun last");
    const Level level = m_levels.back();
    m_levels.pop_back();
    if (level.count > 0 && !level.isLine)
        newLine(m_levels.size());
    m_text += bracket;
}

void JsonWriter::raw(std::string_view text)
{
    beforeValue();
    m_text += text;
}

void JsonWriter::beforeValue()
{
    if (m_levels.empty())
        return;
    assert(m_levels.back().isObject == m_hasKey && "in an object every value has a key");
    if (!m_hasKey)
        separate();
    m_hasKey = false;
}

void JsonWriter::separate()
{
    Level &level = m_levels.back();
    const bool isFirst = level.count == 0;
    if (!isFirst)
        m_text += ',';
    if (!level.isLine && level.count % level.itemsPerLine == 0)
        newLine(m_levels.size());
    else if (!isFirst)
        m_text += ' ';
    ++level.count;
}

void JsonWriter::newLine(std::size_t depth)
{
    m_text += '\n';
    m_text.append(2 * depth, ' ');
}

void JsonWriter::appendText(std::string_view text)
{
    m_text += '"';
    while (!text.empty()) {
        const std::size_t length = utf8Length(text);
        if (length == 0)
            m_text += "\xEF\xBF\xBD"; // U+FFFD
        else if (const std::string escaped = escape(text.front()); !escaped.empty())
            m_text += escaped;
        else
            m_text += text.substr(0, length);
        text.remove_prefix(length == 0 ? 1 : length);
    }
    m_text += '"';
}

} // namespace fff::io
