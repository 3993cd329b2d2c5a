#include "core/values/tokens.h"

#include "core/base/letters.h"
#include "core/base/utf8.h"

#include <array>
#include <optional>
#include <utility>

namespace fff {

namespace {

using TokenKind = ExpressionToken::Kind;

constexpr std::array<std::pair<std::u32string_view, char32_t>, 6> kPairedSigns{{{U"<=", U'\u2264'},
                                                                                {U">=", U'\u2265'},
                                                                                {U"==", U'='},
                                                                                {U"!=", U'\u2260'},
                                                                                {U"<>", U'\u2260'},
                                                                                {U"**", U'^'}}};
constexpr std::array<std::pair<char32_t, char32_t>, 5> kOtherSigns{
    {{U'\u00d7', U'*'}, {U'\u00b7', U'*'}, {U'\u00f7', U'/'}, {U':', U'/'}, {U'\u2212', U'-'}}};
constexpr std::u32string_view kSigns = U"+-*/^(),;<>=\u2264\u2265\u2260%\u00b0\"";

class Tokeniser
{
public:
    explicit Tokeniser(std::string_view text) : m_text(text) {}

    std::vector<ExpressionToken> all()
    {
        while (true) {
            while (isBlank(here()))
                next();
            if (m_at == m_text.size())
                break;
            const std::size_t begin = m_at;
            ExpressionToken token = one();
            token.place = {begin, m_at};
            m_tokens.push_back(std::move(token));
        }
        m_tokens.push_back({TokenKind::End, {m_text.size(), m_text.size()}});
        return std::move(m_tokens);
    }

private:
    char32_t peek(std::size_t at) const
    {
        return at < m_text.size() ? takeLetter(m_text, at) : U'\0';
    }
    char32_t here() const { return peek(m_at); }
    char32_t after() const
    {
        std::size_t at = m_at;
        if (at < m_text.size())
            takeLetter(m_text, at);
        return peek(at);
    }
    char32_t next() { return takeLetter(m_text, m_at); }

    bool followsOperand() const
    {
        return !m_tokens.empty() && (m_tokens.back().kind == TokenKind::Digits ||
                                     m_tokens.back().kind == TokenKind::Word ||
                                     m_tokens.back().kind == TokenKind::Text ||
                                     m_tokens.back().is(U')') || m_tokens.back().is(U'%') ||
                                     m_tokens.back().is(U'\u00b0') || m_tokens.back().is(U'"'));
    }
    bool followsNumber() const
    {
        return !m_tokens.empty() &&
               (m_tokens.back().kind == TokenKind::Digits || m_tokens.back().is(U')'));
    }

    ExpressionToken one()
    {
        const char32_t c = here();
        const bool isMark = c == U'.' || (c == U',' && !followsOperand());
        if (isDigit(c) || (isMark && isDigit(after())))
            return digits();
        if (isNameLetter(c))
            return word();
        if (c == U'\u201c' || c == U'\u201e')
            return quotedText(U"\u201c\u201d");
        if (c == U'\'' || (c == U'"' && !followsNumber()))
            return quotedText(c == U'"' ? U"\"" : U"'");
        return sign();
    }

    /// A comma at the end is none of them.
    ExpressionToken digits()
    {
        next();
        while (isDigit(here()) || here() == U'.' || (here() == U',' && isDigit(after())))
            next();
        return {TokenKind::Digits, {}};
    }

    ExpressionToken word()
    {
        while (isNameLetter(here()) || isDigit(here()))
            next();
        return {TokenKind::Word, {}};
    }

    /// A straight quote that is doubled stands for itself.
    ExpressionToken quotedText(std::u32string_view closing)
    {
        next();
        std::string text;
        while (m_at < m_text.size()) {
            const std::size_t begin = m_at;
            if (closing.find(next()) == closing.npos) {
                text += m_text.substr(begin, m_at - begin);
                continue;
            }
            if (closing.size() > 1 || here() != closing.front())
                return {TokenKind::Text, {}, 0, std::move(text)};
            next();
            text += static_cast<char>(closing.front());
        }
        return {TokenKind::OpenText, {}};
    }

    ExpressionToken sign()
    {
        for (const auto &[pair, meant] : kPairedSigns)
            if (here() == pair[0] && after() == pair[1]) {
                next();
                next();
                return {TokenKind::Sign, {}, meant};
            }
        char32_t c = next();
        for (const auto &[other, meant] : kOtherSigns)
            c = c == other ? meant : c;
        const bool isKnown = kSigns.find(c) != kSigns.npos;
        return {isKnown ? TokenKind::Sign : TokenKind::Unknown, {}, c};
    }

    const std::string_view m_text;
    std::size_t m_at = 0;
    std::vector<ExpressionToken> m_tokens;
};

} // namespace

std::vector<ExpressionToken> tokensOf(std::string_view text)
{
    return Tokeniser(text).all();
}

} // namespace fff
