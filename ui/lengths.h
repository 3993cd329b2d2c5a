// Lengths as people read and type them: in the unit that they have set, with sums in it if they
// like. Everything else has millimetres.
#pragma once

#include "ui/settings/settings.h"

#include <QLocale>
#include <QString>

#include <optional>

namespace fff::ui {

double millimetresPer(LengthUnit unit);
/// "mm", "cm", "in"
QString unitSign(LengthUnit unit);
/// "Millimetres"
QString unitName(LengthUnit unit);

/// With at least and at most so many digits: "3.0", "3.175". A real minus sign.
QString numberText(double value, int least, int most, const QLocale &locale);
/// The number alone, in the unit that is set; the digits are those for millimetres, larger units
/// get one more.
QString lengthNumber(double millimetres, int least, int most, const QLocale &locale);
/// "84.0 mm"
QString lengthText(double millimetres, int least, int most, const QLocale &locale);

/// What was typed, in mm; nothing when it is no length. A number has the unit that is set, unless
/// one stands behind it (mm, cm, m, in, ", ft): "2.5cm", "1/2 in", "1 1/2 in", "3*25.4",
/// "(10 + 2,5) / 2", "2*t". Comma and point are both good before decimals, whatever the locale.
///
/// t  what "t" stands for, mm: the thickness; nothing: it stands for nothing
std::optional<double> parseLength(const QString &text, LengthUnit unit, const QLocale &locale,
                                  std::optional<double> t = std::nullopt);

} // namespace fff::ui
