#include "ui/properties/length_edit.h"

#include "ui/measures.h"

#include <QLineEdit>
#include <QWheelEvent>

#include <cmath>

namespace fff::ui {

namespace {

constexpr int kWidth = 120;      // px; figures are not of one width in Qt 6.4's fonts
constexpr int kSettleTime = 350; // ms after the last step of an arrow
constexpr char16_t kThinSpace = u'\u202f', kMinus = u'\u2212';

} // namespace

LengthEdit::LengthEdit(const Range &range, QWidget *parent)
    : QDoubleSpinBox(parent), m_digits(range.digits)
{
    setRange(range.least, range.most);
    setSingleStep(range.step);
    setDecimals(range.mostDigits);
    setSuffix(QChar(kThinSpace) + tr("mm"));
    setKeyboardTracking(false);
    setFocusPolicy(Qt::StrongFocus);
    setFixedWidth(kWidth);
    lineEdit()->setPlaceholderText(tr("mixed"));

    m_settled.setSingleShot(true);
    m_settled.setInterval(kSettleTime);
    connect(&m_settled, &QTimer::timeout, this, &LengthEdit::announce);
    connect(this, &QDoubleSpinBox::valueChanged, this, [this] {
        if (!m_isSetting)
            m_settled.start();
    });
    connect(this, &QAbstractSpinBox::editingFinished, this, &LengthEdit::announce);
}

void LengthEdit::setLength(std::optional<double> millimetres)
{
    if (m_settled.isActive() || (hasFocus() && lineEdit()->isModified()))
        return;
    m_isSetting = true;
    m_shown.reset();
    if (millimetres) {
        setValue(*millimetres);
        m_shown = value(); // rounded, and within the range: what is there without an edit
    } else {
        clear();
    }
    m_isSetting = false;
}

void LengthEdit::announce()
{
    m_settled.stop();
    lineEdit()->setModified(false);
    // Nothing was typed into a field that says "mixed", or the value is what was shown.
    if (text().isEmpty() || text() == suffix())
        return;
    if (m_shown && std::abs(value() - *m_shown) < 0.5 * std::pow(10.0, -decimals()))
        return;
    m_shown = value();
    Q_EMIT lengthEdited(value());
}

QString LengthEdit::textFromValue(double value) const
{
    return numberText(value, m_digits, decimals(), locale());
}

/// The keyboard's minus is as good as the real one.
double LengthEdit::valueFromText(const QString &text) const
{
    return QDoubleSpinBox::valueFromText(
        QString(text).replace(QChar(kMinus), locale().negativeSign()));
}

QValidator::State LengthEdit::validate(QString &text, int &position) const
{
    QString plain = text;
    plain.replace(QChar(kMinus), locale().negativeSign());
    return QDoubleSpinBox::validate(plain, position);
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
