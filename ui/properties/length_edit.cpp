#include "ui/properties/length_edit.h"

#include "ui/lengths.h"

#include <QLineEdit>
#include <QWheelEvent>

#include <cmath>

namespace fff::ui {

namespace {

constexpr int kWidth = 120;        // px; figures are not of one width in Qt 6.4's fonts
constexpr int kSettleTime = 350;   // ms after the last step of an arrow
constexpr int kStoredDecimals = 9; // the value is exact, only what is shown is rounded
constexpr char16_t kThinSpace = u'\u202f';

/// The largest of 1, 2, 5 · 10ⁿ that is not above `step`: a step that reads well in its unit.
double roundStep(double step)
{
    const double power = std::pow(10.0, std::floor(std::log10(step) + 1e-9));
    const double lead = step / power + 1e-9;
    return power * (lead >= 5.0 ? 5.0 : lead >= 2.0 ? 2.0 : 1.0);
}

} // namespace

LengthEdit::LengthEdit(const Range &range, QWidget *parent) : QDoubleSpinBox(parent), m_range(range)
{
    setDecimals(kStoredDecimals);
    setRange(range.least, range.most);
    setKeyboardTracking(false);
    setFocusPolicy(Qt::StrongFocus);
    setFixedWidth(kWidth);
    lineEdit()->setPlaceholderText(tr("mixed"));
    takeUnit();
    connect(&settings(), &Settings::unitChanged, this, &LengthEdit::takeUnit);

    m_settled.setSingleShot(true);
    m_settled.setInterval(kSettleTime);
    connect(&m_settled, &QTimer::timeout, this, &LengthEdit::announce);
    connect(this, &QDoubleSpinBox::valueChanged, this, [this] {
        if (!m_isSetting)
            m_settled.start();
    });
    connect(this, &QAbstractSpinBox::editingFinished, this, &LengthEdit::announce);
}

/// The same value in another unit.
void LengthEdit::takeUnit()
{
    const LengthUnit unit = settings().unit();
    const bool isMixed = !m_shown && text().isEmpty();
    m_isSetting = true;
    setSingleStep(unit == LengthUnit::Inch
                      ? roundStep(m_range.step / millimetresPer(unit)) * millimetresPer(unit)
                      : m_range.step);
    setSuffix(QChar(kThinSpace) + unitSign(unit)); // writes the number anew
    if (isMixed)
        clear();
    m_isSetting = false;
}

void LengthEdit::setLength(std::optional<double> millimetres)
{
    if (m_settled.isActive() || (hasFocus() && lineEdit()->isModified()))
        return;
    m_isSetting = true;
    m_shown.reset();
    if (millimetres) {
        setValue(*millimetres);
        m_shown = value(); // within the range: what is there without an edit
    } else {
        clear();
    }
    // "Mixed" is a word about the field, not a value in it.
    QFont words = font();
    words.setItalic(!millimetres);
    lineEdit()->setFont(words);
    m_isSetting = false;
}

void LengthEdit::announce()
{
    m_settled.stop();
    lineEdit()->setModified(false);
    // Nothing was typed into a field that says "mixed", or the value is what was shown.
    if (text().isEmpty() || text() == suffix())
        return;
    if (m_shown && textFromValue(value()) == textFromValue(*m_shown))
        return;
    m_shown = value();
    Q_EMIT lengthEdited(value());
}

QString LengthEdit::textFromValue(double value) const
{
    QLocale plain = locale();
    plain.setNumberOptions(plain.numberOptions() | QLocale::OmitGroupSeparator);
    return lengthNumber(value, m_range.digits, m_range.mostDigits, plain);
}

std::optional<double> LengthEdit::parsed(QString text) const
{
    const QString own = suffix();
    if (text.endsWith(own)) {
        // A unit that was typed before the field's own one counts.
        const QString before = text.chopped(own.size());
        if (const auto value = parseLength(before, settings().unit(), locale(), m_thickness))
            return value;
    }
    return parseLength(text, settings().unit(), locale(), m_thickness);
}

double LengthEdit::valueFromText(const QString &text) const
{
    // The digits that are shown stand for all that the value has.
    const double now = value();
    QString number = text;
    if (number.endsWith(suffix()))
        number.chop(suffix().size());
    if (number.trimmed() == textFromValue(now))
        return now;
    return parsed(text).value_or(now);
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

void LengthEdit::wheelEvent(QWheelEvent *event)
{
    // Scrolling the panel must not change numbers on the way.
    if (hasFocus())
        QDoubleSpinBox::wheelEvent(event);
    else
        event->ignore();
}

} // namespace fff::ui
