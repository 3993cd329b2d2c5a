// A text with places that are filled in: "Shelf {n} of {boards}", "{width/2}".
#pragma once

#include "core/values/formula.h"
#include "core/values/number_text.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fff {

/// "{{" and "}}" stand for a brace; in braces stands an expression, without braces in it.
class TextTemplate
{
public:
    struct Piece
    {
        TextRange place; // in the text, with its braces
        std::string literal;
        std::optional<Formula> formula; // in place of it
    };

    /// Errors  those of Formula::read(), at their place in the whole text; an open brace.
    static Understood<TextTemplate> read(std::string_view text, const Reading &reading = {});

    /// A text. Errors  those of Formula::worth().
    Understood<Worth> worth(const Names &names, const NumberStyle &style = {}) const;

    const std::string &text() const { return m_text; }
    const std::vector<Piece> &pieces() const { return m_pieces; }
    /// Folded, each once.
    const std::vector<std::string> &names() const { return m_names; }

private:
    std::string m_text;
    std::vector<Piece> m_pieces;
    std::vector<std::string> m_names;
};

/// Where the expressions of a text are, without their braces, also of one that cannot be read.
std::vector<TextRange> placesIn(std::string_view text);

} // namespace fff
