#include "ui/properties/length_edit.h"

#include "ui/base/expression_text.h"
#include "ui/base/lengths.h"
#include "ui/bench/number_names.h"

#include <cmath>

namespace fff::ui {

namespace {

/// The largest of 1, 2, 5 · 10ⁿ that is not above `step`: a step that reads well in its unit.
double roundStep(double step)
{
    const double power = std::pow(10.0, std::floor(std::log10(step) + 1e-9));
    const double lead = step / power + 1e-9;
    return power * (lead >= 5.0 ? 5.0 : lead >= 2.0 ? 2.0 : 1.0);
}

} // namespace

LengthEdit::LengthEdit(const Range &range, QWidget *parent) : NumberEdit(range, {}, parent)
{
    takeUnit();
    connect(&settings(), &Settings::unitChanged, this, &LengthEdit::takeUnit);
    connect(this, &NumberEdit::numberEdited, this, &LengthEdit::lengthEdited);
}

/// The same value in another unit.
void LengthEdit::takeUnit()
{
    const LengthUnit unit = settings().unit();
    const double size = millimetresPer(unit);
    setUnit(unitSign(unit),
            unit == LengthUnit::Inch ? roundStep(range().step / size) * size : range().step);
}

QString LengthEdit::textFromValue(double value) const
{
    QLocale plain = locale();
    plain.setNumberOptions(plain.numberOptions() | QLocale::OmitGroupSeparator);
    return lengthNumber(value, range().digits, range().mostDigits, plain);
}

Expression LengthEdit::read(const QString &text) const
{
    return readLength(text.toStdString(), millimetresPer(settings().unit()), commasOf(locale()),
                      m_thickness ? m_thickness() : std::optional<double>(), numberNamesFor(this));
}

} // namespace fff::ui
