// The units that lengths are shown in, and how a length is written in one of them. What the person
// has set is ui/lengths.h's business.
#pragma once

#include <QLocale>
#include <QString>

namespace fff::ui {

enum class LengthUnit { Millimetre, Centimetre, Inch };

double millimetresPer(LengthUnit unit);
/// "mm", "cm", "in"
QString unitSign(LengthUnit unit);

/// With at least and at most so many digits: "3.0", "3.175". A real minus sign.
QString numberText(double value, int least, int most, const QLocale &locale);
/// The number alone, in this unit; the digits are those for millimetres, larger units get one more.
QString lengthNumber(double millimetres, LengthUnit unit, int least, int most,
                     const QLocale &locale);
/// "84.0 mm"
QString lengthText(double millimetres, LengthUnit unit, int least, int most, const QLocale &locale);

} // namespace fff::ui
