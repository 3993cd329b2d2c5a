// What people type where a number belongs, read once into a small tree: numbers with units, names
// of values, + - * / ^, comparisons, functions. (core/base/expression.h reads and calculates in one
// go, in one unit, and forgets.)
//
//     2*gap + 1 in     round(width / 3; 5 mm)     if(boards > 3, 4 mm, 3 mm)     sqrt(a^2 + b^2)
//
// Kinds are checked like dimensions: a length times a length is an area, and only like is added to
// like. A plain number beside a length is one in the unit of the reading, also at the top.
//
// Commas   before decimals as the reading has them, and between what a function takes, where they
//          have a blank beside them or no digit on one side; "max(2,5)" is refused, as it can be
//          read in two ways. With ";" between them commas are decimal.
// Units    as in fields: of "1/2 in" and "1 1/2 in" the unit is that of the fraction. "3 mm^2" is
//          refused for the same reason.
// Names    letters of any language, digits and _; a word behind a number is a unit, one before "("
//          a function, so that values may be named as these are. "pi" is π unless a value is.
#pragma once

#include "core/values/expression_error.h"
#include "core/values/worth.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace fff {

inline constexpr std::size_t kLongestExpression = 4000; // bytes
inline constexpr int kMostExpressionNodes = 1000;
inline constexpr int kDeepestExpression = 100; // parentheses, functions and signs in each other

struct FormulaNode
{
    enum class Kind : std::uint8_t {
        Number, // number
        Name,   // index: in Formula::names()
        Text,   // index: in Formula::texts()
        Unit,   // index: in unitSigns(), of its only child
        Negate,
        Add,
        Subtract,
        Multiply,
        Divide,
        Power,
        Less,
        AtMost,
        Greater,
        AtLeast,
        Equal,
        Unequal,
        Call, // index: in functionNames()
    };

    Kind kind = Kind::Number;
    /// Of Divide: the right side ends with a unit that is the fraction's where the left side is a
    /// plain number.
    bool isFraction = false;
    int index = -1;
    double number = 0.0;
    int firstChild = 0, childCount = 0; // in Formula::children()
    TextRange place;
};

class Formula
{
public:
    /// text  UTF-8; "=" may stand before it. Errors  what cannot be read.
    static Understood<Formula> read(std::string_view text, const Reading &reading = {});

    /// A worth of whatever kind. O(size of the text). Errors  a name that is unknown, what does not
    /// go together, what has no value (as a division by 0; what `if` does not choose may have
    /// none).
    Understood<Worth> worth(const Names &names) const;

    /// As it was typed.
    const std::string &text() const { return m_text; }
    const Reading &reading() const { return m_reading; }
    /// Folded, each once, in the order in which they are first seen.
    const std::vector<std::string> &names() const { return m_names; }
    const std::vector<std::string> &texts() const { return m_texts; }
    /// Children come before their parents; the last one is the whole.
    const std::vector<FormulaNode> &nodes() const { return m_nodes; }
    const std::vector<int> &children() const { return m_children; }
    const FormulaNode &child(const FormulaNode &of, int which) const
    {
        return m_nodes[static_cast<std::size_t>(childIndex(of, which))];
    }
    int childIndex(const FormulaNode &of, int which) const
    {
        return m_children[static_cast<std::size_t>(of.firstChild + which)];
    }

    /// The same trees: alike but for blanks, parentheses that change nothing and ways to write a
    /// sign, a number or a name.
    bool means(const Formula &other) const;

private:
    friend class FormulaParser;

    std::string m_text;
    Reading m_reading;
    std::vector<std::string> m_names, m_texts;
    std::vector<FormulaNode> m_nodes;
    std::vector<int> m_children;
};

/// A text that is read as the same tree, with blanks and parentheses in one way.
std::string writtenFormula(const Formula &formula);

} // namespace fff
