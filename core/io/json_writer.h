// Writes JSON for people and for version control: keys in the order they are written, two spaces a
// level, lists of numbers on one line. Numbers are the shortest text that reads back as the same
// double. Used by the native format and by the command line's --json.
#pragma once

#include "core/geometry/vector.h"

#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fff::io {

/// Text is UTF-8; what is not becomes U+FFFD. A wrong order of calls (a value without a key in an
/// object, an end without a begin) is a bug of the caller and asserted, as is a number that is not
/// finite: JSON has none, it is written as null. -0 is written as 0: readers do not tell them
/// apart.
class JsonWriter
{
public:
    enum class Layout {
        Block, // every item on a line of its own
        Line,  // everything inside on one line
    };

    void beginObject(Layout layout = Layout::Block);
    void endObject();
    /// itemsPerLine: with Block, how many items share a line.
    void beginArray(Layout layout = Layout::Block, int itemsPerLine = 1);
    void endArray();

    void key(std::string_view name);
    void value(std::string_view text);
    void value(const char *text) { value(std::string_view(text)); }
    void value(const std::string &text) { value(std::string_view(text)); }
    void value(double number);
    void value(bool truth);
    template <std::integral Integer>
    void value(Integer number)
    {
        raw(std::to_string(number));
    }
    void null();
    /// [x, y] and [x, y, z], on one line.
    void value(const Vec2 &point);
    void value(const Vec3 &point);
    /// A list of numbers on one line.
    void value(std::span<const double> numbers);

    template <class T>
    void member(std::string_view name, const T &v)
    {
        key(name);
        value(v);
    }

    /// A number that is not finite came by and was written as null.
    bool sawNonFinite() const { return m_sawNonFinite; }
    /// What was written, closed with a line end. Everything that was begun must have ended.
    std::string take();

private:
    struct Level
    {
        bool isObject = false;
        bool isLine = false;
        int itemsPerLine = 1;
        std::int64_t count = 0;
    };

    void begin(char bracket, Level level);
    void end(char bracket, bool isObject);
    void raw(std::string_view text);
    void beforeValue();
    void separate();
    void newLine(std::size_t depth);
    void appendText(std::string_view text);

    std::string m_text;
    std::vector<Level> m_levels;
    bool m_hasKey = false;
    bool m_sawNonFinite = false;
};

} // namespace fff::io
