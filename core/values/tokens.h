// The words, numbers and signs of an expression.
#pragma once

#include "core/values/expression_error.h"

#include <string>
#include <string_view>
#include <vector>

namespace fff {

struct ExpressionToken
{
    enum class Kind {
        Digits, // with its points and commas
        Word,   // a name, a function or a unit
        Text,   // in quotes
        Sign,
        OpenText, // a quote that is not closed, and all behind it
        Unknown,
        End,
    };

    Kind kind = Kind::End;
    TextRange place;
    char32_t sign = 0; // × and · are *, ÷ and : are /, − is -; <= is ≤, >= is ≥, == is =, <> is ≠
    std::string text = {}; // without its quotes

    bool is(char32_t which) const { return kind == Kind::Sign && sign == which; }
};

/// At least the end. A quote behind a number or a parenthesis is the sign of inches.
std::vector<ExpressionToken> tokensOf(std::string_view text);

} // namespace fff
