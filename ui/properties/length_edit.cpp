#include "ui/properties/length_edit.h"

#include "ui/lengths.h"

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

std::optional<double> LengthEdit::parsed(const QString &text) const
{
    const LengthUnit unit = settings().unit();
    if (text.endsWith(suffix())) {
        // A unit that was typed before the field's own one counts.
        const QString before = text.chopped(suffix().size());
        if (const auto value = parseLength(before, unit, locale(), m_thickness))
            return value;
    }
    return parseLength(text, unit, locale(), m_thickness);
}

double LengthEdit::valueFromText(const QString &text) const
{
    return showsValue(text) ? value() : parsed(text).value_or(value());
}

QValidator::State LengthEdit::validate(QString &text, int &) const
{
    const std::optional<double> value = parsed(text);
    if (value && *value >= minimum() && *value <= maximum())
        return QValidator::Acceptable;
    for (const QChar c : text) {
        const bool isPartOfSum = c.isDigit() || c.isSpace() || c.isLetter() ||
                                 QStringView(u"+-\u2212*\u00d7/:\u00f7().,\"").contains(c);
        if (!isPartOfSum)
            return QValidator::Invalid;
    }
    return QValidator::Intermediate;
}

} // namespace fff::ui
