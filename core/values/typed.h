// What a person typed where something of a kind is wanted, read once: an expression, a text with
// placeholders, one of some choices, yes or no. A field keeps it, and so does a value.
#pragma once

#include "core/values/formula.h"
#include "core/values/text_template.h"

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace fff {

class Typed
{
public:
    /// text  a text or a choice is an expression where it begins with "="; a number, a length and
    ///       the like always is one.
    /// Errors  what cannot be read.
    static Understood<Typed> read(std::string_view text, ValueKind kind,
                                  const Reading &reading = {});

    /// Of the kind: a plain number is in the unit of the reading, a count is whole.
    /// Errors  those of Formula::worth(), and what it is instead of the kind.
    Understood<Worth> worth(const Names &names) const;

    ValueKind kind() const { return m_kind; }
    /// As it was typed.
    const std::string &text() const;
    /// That it depends on: folded, each once.
    const std::vector<std::string> &names() const;
    /// A number with or without a unit, or a text without placeholders: nothing to be worked out.
    bool isConstant() const;
    /// Where the name stands first; all of the text if it does not.
    TextRange placeOf(std::string_view foldedName) const;

private:
    friend std::string withoutName(const Typed &typed, std::string_view foldedName,
                                   const Names &names);
    /// What is no expression: "yes", a choice.
    struct Literal
    {
        std::string text;
        Worth worth;
    };

    ValueKind m_kind = ValueKind::Number;
    std::variant<Literal, Formula, TextTemplate> m_content;
};

/// What is typed in place of it so that it is the same without that name: an expression with the
/// name becomes a number, a placeholder its text. The text as it is where it has not the name, or
/// no worth.
std::string withoutName(const Typed &typed, std::string_view foldedName, const Names &names);

} // namespace fff
