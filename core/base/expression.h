// What people type into number fields: numbers and sums of them, with units where the field has
// them, and what it is that cannot be read in anything else. Our own in place of muParser, to which
// 2 mm · 3 mm is 6, 1/0 infinite, "1 1/2 in" and "−" no expression, and "," either decimal or not.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace fff {

/// Text is UTF-8.
struct Expression
{
    enum class Fault {
        None,
        Empty,
        Unreadable,      // piece: what cannot be read
        Unfinished,      // piece: what something is missing behind
        OpenParenthesis, // one is not closed
        LooseParenthesis,
        DivisionByZero,
        UnknownName, // piece: that nothing is called so
        NotALength,  // an area, or a length beside a number of another kind
        NoThickness, // "t" where nothing has one thickness
        NotAMass,    // a mass times another one, or something that is none
    };

    std::optional<double> value; // none with a fault
    Fault fault = Fault::None;
    std::string piece = {};
    bool isLength = false; // the value is in mm; of readAny()
};

/// What a name stands for.
struct NamedValue
{
    double value = 0.0;
    bool isLength = false; // mm; else a plain number
};
/// Nothing for a name that stands for nothing; null: there are none.
using NumberNames = std::function<std::optional<NamedValue>(std::string_view)>;

/// Comma and point are both good before decimals, whatever a person is used to, but for this.
enum class Commas {
    Decimals, // "1,000" is one
    Groups,   // a thousand: nobody there writes decimals so
};

/// A length, in mm. A number has the unit `unit`, unless one stands behind it (mm, cm, m, in, ",
/// ft): "2.5cm", "1/2 in", "1 1/2 in", "3*25.4", "(10 + 2,5) / 2", "2*t".
///
/// unit  of numbers without one, mm
/// t     what "t" stands for, mm: the thickness; nothing: it stands for nothing
Expression readLength(std::string_view text, double unit, Commas commas,
                      std::optional<double> t = std::nullopt, const NumberNames &names = {});

/// A mass, in kg: the same with g, kg, oz and lb. Numbers that have names are no masses, but for
/// plain ones.
///
/// unit  of numbers without one, kg
Expression readMass(std::string_view text, double unit, Commas commas,
                    const NumberNames &names = {});

/// A number without a unit, or with `sign` behind it, which changes nothing: "360/7", "2*(3+4) °".
Expression readNumber(std::string_view text, std::string_view sign, Commas commas,
                      const NumberNames &names = {});

/// A length where there is a unit in it, or a name of a length; else a plain number.
Expression readAny(std::string_view text, Commas commas, const NumberNames &names = {});

} // namespace fff
