#include "ui/base/lengths.h"

#include <QCoreApplication>

namespace fff::ui {

namespace {

struct LengthText
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::LengthText)
};

} // namespace

QString unitName(LengthUnit unit)
{
    switch (unit) {
    case LengthUnit::Millimetre:
        return LengthText::tr("Millimetres");
    case LengthUnit::Centimetre:
        return LengthText::tr("Centimetres");
    case LengthUnit::Inch:
        return LengthText::tr("Inches");
    }
    return {};
}

QString lengthNumber(double millimetres, int least, int most, const QLocale &locale)
{
    return lengthNumber(millimetres, settings().unit(), least, most, locale);
}

QString lengthText(double millimetres, int least, int most, const QLocale &locale)
{
    return lengthText(millimetres, settings().unit(), least, most, locale);
}

} // namespace fff::ui
