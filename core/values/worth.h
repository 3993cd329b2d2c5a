// What an expression comes to, and what kinds there are of it.
#pragma once

#include "core/base/expression.h"
#include "core/base/text.h"
#include "core/base/units.h"

#include <functional>
#include <string>
#include <string_view>

namespace fff {

/// Of lengths, masses and angles that are multiplied: an area is {2, 0, 0}. Angles count, too, so
/// that 30° is no plain number.
struct Powers
{
    int length = 0, mass = 0, angle = 0;

    bool isNone() const { return *this == Powers(); }
    bool operator==(const Powers &) const = default;
};

inline constexpr Powers kLengthPowers{1, 0, 0}, kMassPowers{0, 1, 0}, kAnglePowers{0, 0, 1};

struct Worth
{
    enum class Type { Number, Truth, Text };

    Type type = Type::Number;
    Powers powers = {};
    /// A plain number that stands for one of whatever is beside it, as 5 in "2 cm + 5": one that
    /// was typed without a unit, or is made of such.
    bool isBare = false;
    double number = 0.0; // mm, kg, radians and products of these; a truth: 0 or 1
    std::string text = {};

    bool operator==(const Worth &) const = default;
};

/// What a value is, or what a field wants.
enum class ValueKind {
    Number, // plain, and in a field's unit where a length, an angle or a mass is wanted
    Length, // mm
    Angle,  // radians
    Count,  // a whole number
    Mass,   // kg
    Ratio,  // a plain number that never stands for a length
    Text,   // with {placeholders}; an expression where it begins with "="
    Choice, // one of some texts; the same
    Switch, // yes or no, or a comparison
};

/// What a number without a unit stands for, and how commas are read. It belongs to a text as it was
/// typed, so that the text means the same to whoever has set other units.
struct Reading
{
    double lengthUnit = 1.0; // mm
    double massUnit = 1e-3;  // kg
    double angleUnit = radians(1.0);
    Commas commas = Commas::Groups;

    bool operator==(const Reading &) const = default;
};

/// By the folded name; null: nothing is named so.
using Names = std::function<const Worth *(std::string_view)>;

/// "a length", "an area"
Text nounOf(const Worth &worth);
/// "a length", "a whole number"
Text nounOf(ValueKind kind);

/// Numbers that differ by less than this, as a share of the larger one or of 1, are the same to
/// comparisons and to rounding: 3 · 0.1 is 0.3, and floor(0.3/0.1) is 3.
inline constexpr double kSameNumber = 1e-9;

} // namespace fff
