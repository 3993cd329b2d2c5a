// What people type into number fields: numbers and sums of them, with units where the field has
// them, and in words why something typed is no answer.
#pragma once

#include "ui/view/length_unit.h"

#include <functional>
#include <optional>

namespace fff::ui {

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
    };

    std::optional<double> value; // none with a fault
    Fault fault = Fault::None;
    QString piece = {};
    bool isLength = false; // the value is in mm; of readAny()
};

/// What a name stands for.
struct NamedValue
{
    double value = 0.0;
    bool isLength = false; // mm; else a plain number
};
/// Nothing for a name that stands for nothing; null: there are none.
using NumberNames = std::function<std::optional<NamedValue>(const QString &)>;

/// A length, in mm. A number has the unit `unit`, unless one stands behind it (mm, cm, m, in, ",
/// ft): "2.5cm", "1/2 in", "1 1/2 in", "3*25.4", "(10 + 2,5) / 2", "2*t". Comma and point are both
/// good before decimals, whatever the locale.
///
/// t  what "t" stands for, mm: the thickness; nothing: it stands for nothing
Expression readLength(const QString &text, LengthUnit unit, const QLocale &locale,
                      std::optional<double> t = std::nullopt, const NumberNames &names = {});

/// A number without a unit, or with `sign` behind it, which changes nothing: "360/7", "2*(3+4) °".
Expression readNumber(const QString &text, const QString &sign, const QLocale &locale,
                      const NumberNames &names = {});

/// A length where there is a unit in it, or a name of a length; else a plain number.
Expression readAny(const QString &text, const QLocale &locale, const NumberNames &names = {});

/// One sentence for the person who typed it; empty without a fault.
QString refusalText(const Expression &expression);

} // namespace fff::ui
