// The shapes of letters. Internal to model.
#pragma once

#include <string_view>

namespace fff {

/// A letter on a grid whose capitals are 10 high and stand on 0.
struct LetterShape
{
    char32_t letter;
    double width;
    /// m x y: go there; l x y: a line; h x y, v x y: a quarter of an ellipse that leaves
    /// horizontally (vertically) and arrives the other way; c: a cubic Bézier.
    std::string_view strokes;
};

/// Null for what is no letter of the alphabet.
const LetterShape *letterShape(char32_t letter);

/// A letter with something on top of it, or below.
struct MadeLetter
{
    char32_t letter, base, accent;
};

/// Null for one that is not made of two.
const MadeLetter *madeLetter(char32_t letter);

/// What stands on top of a small letter 5 wide.
const LetterShape *accentShape(char32_t accent);

} // namespace fff
