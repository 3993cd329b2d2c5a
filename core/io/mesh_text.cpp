#include "core/io/mesh_text.h"

#include "core/io/loaded_document.h"

namespace fff::io {

bool MeshText::joinLine()
{
    const char *next = m_at + 1;
    if (next < m_end && *next == '\r')
        ++next;
    if (next >= m_end || *next != '\n')
        return false;
    m_at = next + 1;
    ++m_line;
    return true;
}

double MeshText::otherNumber(std::string_view word)
{
    const std::string_view digits = withoutPlus(word);
    double value = 0.0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const std::string_view rest(end, static_cast<std::size_t>(digits.data() + digits.size() - end));
    if (error == std::errc::result_out_of_range && rest.empty()) {
        const std::size_t exponent = digits.find_first_of("eE");
        const bool isTiny = exponent != std::string_view::npos && exponent + 1 < digits.size() &&
                            digits[exponent + 1] == '-';
        return isTiny ? 0.0 : std::numeric_limits<double>::infinity();
    }
    // "-nan(ind)", "1.#QNAN", "-1.#IND", "1.#INF"
    const bool isNone = error == std::errc() && !digits.empty() &&
                        (rest.starts_with("#") || (rest.starts_with("(") && rest.ends_with(")")));
    if (isNone)
        return std::numeric_limits<double>::quiet_NaN();
    failExpected(word, QT_TRANSLATE_NOOP("Error", "a number"));
    return 0.0;
}

void MeshText::failExpected(std::string_view found, const char *expected)
{
    if (found.empty() && m_at >= m_end)
        m_builder.fail(ErrorCode::Truncated, where(), {expected});
    else
        m_builder.fail(ErrorCode::BadSyntax, where(), {quoted(found), expected});
}

} // namespace fff::io
