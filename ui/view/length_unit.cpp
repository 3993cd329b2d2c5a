#include "ui/view/length_unit.h"

#include <QCoreApplication>

#include <cmath>

namespace fff::ui {

namespace {

struct LengthText
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::LengthText)
};

} // namespace

double millimetresPer(LengthUnit unit)
{
    return unit == LengthUnit::Centimetre ? 10.0 : unit == LengthUnit::Inch ? 25.4 : 1.0;
}

QString unitSign(LengthUnit unit)
{
    switch (unit) {
    case LengthUnit::Millimetre:
        return LengthText::tr("mm");
    case LengthUnit::Centimetre:
        return LengthText::tr("cm");
    case LengthUnit::Inch:
        return LengthText::tr("in");
    }
    return {};
}

QString numberText(double value, int least, int most, const QLocale &locale)
{
    // What is written as nothing has no sign.
    const bool isNothing = std::abs(value) < 0.5 * std::pow(10.0, -most);
    QString text = locale.toString(isNothing ? 0.0 : value, 'f', most);
    for (int digits = most; digits > least && text.endsWith(locale.zeroDigit()); --digits)
        text.chop(1);
    if (least == 0 && most > 0 && text.endsWith(locale.decimalPoint()))
        text.chop(1);
    return text.replace(locale.negativeSign(), QChar(0x2212));
}

QString lengthNumber(double millimetres, LengthUnit unit, int least, int most,
                     const QLocale &locale)
{
    const int more = unit == LengthUnit::Millimetre ? 0 : 1;
    return numberText(millimetres / millimetresPer(unit), least + more, most + more, locale);
}

QString lengthText(double millimetres, LengthUnit unit, int least, int most, const QLocale &locale)
{
    return QStringLiteral("%1\u202f%2")
        .arg(lengthNumber(millimetres, unit, least, most, locale), unitSign(unit));
}

} // namespace fff::ui
