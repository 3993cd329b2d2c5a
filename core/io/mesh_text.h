// Words of text formats of meshes, line by line, as fast as they can be read. Internal to io.
#pragma once

#include "core/io/mesh_builder.h"

#include <charconv>
#include <limits>

namespace fff::io {

class MeshText
{
public:
    /// comment: what is behind it on a line is nothing; 0: there are no comments. firstLine: the
    /// number of the first one.
    MeshText(std::string_view bytes, MeshBuilder &builder, char comment, std::size_t firstLine = 1)
        : m_at(bytes.data()), m_begin(bytes.data()), m_end(bytes.data() + bytes.size()),
          m_builder(builder), m_comment(comment), m_line(firstLine)
    {
    }

    /// The next word of the line; empty where it ends. A backslash at its end joins the next line.
    std::string_view word()
    {
        skipBlanks();
        const char *const begin = m_at;
        while (m_at<m_end &&static_cast<unsigned char>(*m_at)> ' ')
            ++m_at;
        return {begin, static_cast<std::size_t>(m_at - begin)};
    }

    /// On to the next line; false behind the last one.
    bool nextLine()
    {
        while (m_at < m_end && *m_at != '\n')
            ++m_at;
        if (m_at >= m_end)
            return false;
        ++m_at;
        ++m_line;
        return m_at < m_end;
    }
    /// The next word, on whatever line it is; empty at the end of the file.
    std::string_view anyWord()
    {
        std::string_view found = word();
        while (found.empty() && nextLine())
            found = word();
        return found;
    }

    /// Words as numbers. An error, and 0, where one is none; NaN and infinity are numbers here.
    double number(std::string_view word)
    {
        double value = 0.0;
        const std::string_view digits = withoutPlus(word);
        const auto [end, error] =
            std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (error == std::errc() && end == digits.data() + digits.size())
            return value;
        return otherNumber(word);
    }
    std::int64_t integer(std::string_view word)
    {
        std::int64_t value = 0;
        const std::string_view digits = withoutPlus(word);
        const auto [end, error] =
            std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (error != std::errc() || end != digits.data() + digits.size())
            failExpected(word, QT_TRANSLATE_NOOP("Error", "a whole number"));
        return value;
    }
    /// A whole number that is not negative.
    std::uint64_t count(std::string_view word)
    {
        const std::int64_t value = integer(word);
        if (value < 0)
            failExpected(word, QT_TRANSLATE_NOOP("Error", "a count"));
        return static_cast<std::uint64_t>(std::max<std::int64_t>(value, 0));
    }
    Vec3 point()
    {
        const double x = number(word()), y = number(word()), z = number(word());
        return {x, y, z};
    }

    /// Truncated at the end of the file, else BadSyntax.
    void failExpected(std::string_view found, const char *expected);

    std::string where() const { return std::to_string(m_line); }
    /// Of the file.
    double share() const
    {
        return static_cast<double>(m_at - m_begin) /
               static_cast<double>(std::max<std::ptrdiff_t>(m_end - m_begin, 1));
    }
    std::size_t offset() const { return static_cast<std::size_t>(m_at - m_begin); }
    std::size_t left() const { return static_cast<std::size_t>(m_end - m_at); }

private:
    static std::string_view withoutPlus(std::string_view word)
    {
        const bool hasPlus = word.size() > 1 && word[0] == '+' && word[1] != '-';
        return hasPlus ? word.substr(1) : word;
    }
    void skipBlanks()
    {
        while (m_at < m_end && *m_at != '\n' && static_cast<unsigned char>(*m_at) <= ' ')
            ++m_at;
        if (m_at >= m_end)
            return;
        if (m_comment != 0 && *m_at == m_comment)
            while (m_at < m_end && *m_at != '\n')
                ++m_at;
        else if (*m_at == '\\' && joinLine())
            skipBlanks();
    }
    bool joinLine();
    /// What std::from_chars does not know: too small, too large, and what others write for NaN.
    double otherNumber(std::string_view word);

    const char *m_at, *m_begin, *m_end;
    MeshBuilder &m_builder;
    const char m_comment;
    std::size_t m_line;
};

} // namespace fff::io
