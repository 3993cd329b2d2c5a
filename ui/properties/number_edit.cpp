#include "ui/properties/number_edit.h"

#include "ui/base/expression_text.h"
#include "ui/base/lengths.h"
#include "ui/bench/number_names.h"

#include <QFocusEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QStyleOptionSpinBox>
#include <QTimer>
#include <QToolTip>
#include <QWheelEvent>

namespace fff::ui {

namespace {

constexpr int kWidth = 120;         // px; figures are not of one width in Qt 6.4's fonts
constexpr int kCompactWidth = 48;   // px
constexpr int kSettleTime = 350;    // ms after the last step of an arrow
constexpr int kRefusalTime = 30000; // ms that a reason is said
constexpr int kAfterLists = 50;    // ms, by when a list of names is closed that would take it along
constexpr int kStoredDecimals = 9; // the value is exact, only what is shown is rounded
constexpr char16_t kThinSpace = u'\u202f';

} // namespace

NumberEdit::NumberEdit(const Range &range, const QString &unit, QWidget *parent)
    : QDoubleSpinBox(parent), m_range(range)
{
    setDecimals(kStoredDecimals);
    setRange(range.least, range.most);
    setKeyboardTracking(false);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumWidth(kWidth);
    lineEdit()->setPlaceholderText(tr("mixed"));
    lineEdit()->installEventFilter(this);
    setUnit(unit, range.step);

    m_settled.setSingleShot(true);
    m_settled.setInterval(kSettleTime);
    connect(&m_settled, &QTimer::timeout, this, &NumberEdit::announce);
    connect(this, &QDoubleSpinBox::valueChanged, this, [this] {
        if (!m_isSetting)
            m_settled.start();
    });
    connect(this, &QAbstractSpinBox::editingFinished, this, &NumberEdit::announce);
}

void NumberEdit::setUnit(const QString &sign, double step)
{
    const bool isMixed = !m_shown && text().isEmpty();
    m_isSetting = true;
    setSingleStep(step);
    m_suffix = sign.isEmpty() ? QString() : QChar(kThinSpace) + sign;
    setSuffix(m_isCompact ? QString() : m_suffix); // writes the number anew
    if (isMixed)
        showNothing();
    m_isSetting = false;
}

void NumberEdit::setCompact()
{
    m_isCompact = true;
    setButtonSymbols(NoButtons);
    setMinimumWidth(kCompactWidth);
    setSizePolicy(QSizePolicy::Ignored, sizePolicy().verticalPolicy());
    setSuffix({});
}

int NumberEdit::widthFor(const QString &number) const
{
    constexpr int kBesideText = 6; // px that a line of text leaves free, with the cursor
    QStyleOptionSpinBox option;
    initStyleOption(&option);
    option.rect = QRect(0, 0, kWidth, sizeHint().height());
    const int room =
        style()
            ->subControlRect(QStyle::CC_SpinBox, &option, QStyle::SC_SpinBoxEditField, this)
            .width();
    return fontMetrics().horizontalAdvance(number + m_suffix) + kBesideText + kWidth - room;
}

/// Without its unit, beside which the word "mixed" would not be seen.
void NumberEdit::showNothing()
{
    setSuffix(QString());
    clear();
}

void NumberEdit::setNumber(std::optional<double> number)
{
    if (m_settled.isActive() || (hasFocus() && lineEdit()->isModified()))
        return;
    m_isSetting = true;
    m_shown.reset();
    if (number) {
        setSuffix(m_isCompact ? QString() : m_suffix);
        setValue(*number);
        m_shown = value(); // within the range: what is there without an edit
    } else {
        showNothing();
    }
    // "Mixed" is a word about the field, not a value in it.
    QFont words = font();
    words.setItalic(!number);
    lineEdit()->setFont(words);
    m_isSetting = false;
    showMark();
}

/// What was typed and not entered.
void NumberEdit::takeBack()
{
    m_settled.stop();
    lineEdit()->setModified(false);
    setNumber(m_shown);
}

void NumberEdit::announce()
{
    m_settled.stop();
    lineEdit()->setModified(false);
    // Nothing was typed into a field that says "mixed", or the value is what was shown.
    if (text().isEmpty() || text() == suffix())
        return;
    if (m_shown && textFromValue(value()) == textFromValue(*m_shown))
        return;
    m_shown = value();
    Q_EMIT numberEdited(value());
}

bool NumberEdit::showsValue(const QString &text) const
{
    QString number = text;
    if (number.endsWith(suffix()))
        number.chop(suffix().size());
    return number.trimmed() == textFromValue(value());
}

QString NumberEdit::textFromValue(double value) const
{
    QLocale plain = locale();
    plain.setNumberOptions(plain.numberOptions() | QLocale::OmitGroupSeparator);
    return numberText(value, m_range.digits, m_range.mostDigits, plain);
}

Expression NumberEdit::read(const QString &text) const
{
    return readNumber(text.toStdString(), m_suffix.trimmed().toStdString(), commasOf(locale()),
                      numberNamesFor(this));
}

/// A unit that was typed before the field's own one counts.
Expression NumberEdit::readWithUnit(const QString &text) const
{
    return read(text.endsWith(suffix()) ? text.chopped(suffix().size()) : text);
}

/// Such as "not rated".
bool NumberEdit::isSpecial(const QString &text) const
{
    return !specialValueText().isEmpty() && text == specialValueText();
}

double NumberEdit::valueFromText(const QString &text) const
{
    if (isSpecial(text))
        return minimum();
    return showsValue(text) ? value() : readWithUnit(text).value.value_or(value());
}

/// Anything may be typed on the way to a sum; refusal() says at the end what is wrong with it.
QValidator::State NumberEdit::validate(QString &text, int &) const
{
    if (isSpecial(text))
        return QValidator::Acceptable;
    const std::optional<double> value = readWithUnit(text).value;
    return value && *value >= minimum() && *value <= maximum() ? QValidator::Acceptable
                                                               : QValidator::Intermediate;
}

std::optional<double> NumberEdit::typed() const
{
    const std::optional<double> value = readWithUnit(text()).value;
    return value && *value >= minimum() && *value <= maximum() ? value : std::nullopt;
}

QString NumberEdit::refusal() const
{
    const Expression typed = readWithUnit(text());
    if (typed.fault == Expression::Fault::Empty || showsValue(text()) || isSpecial(text()))
        return {}; // nothing was typed
    return whyNot(typed);
}

QString NumberEdit::whyNot(const Expression &typed) const
{
    if (!typed.value)
        return refusalText(typed);
    if (*typed.value >= minimum() && *typed.value <= maximum())
        return {};
    return *typed.value < minimum()
               //: %1 is the smallest value, with its unit
               ? tr("At least %1.").arg(textFromValue(minimum()) + m_suffix)
               //: %1 is the largest value, with its unit
               : tr("At most %1.").arg(textFromValue(maximum()) + m_suffix);
}

void NumberEdit::refuse(const QString &reason)
{
    QTimer::singleShot(kAfterLists, this, [this, reason] {
        if (isVisible())
            QToolTip::showText(mapToGlobal(QPoint(0, height() - 12)), reason, this, {},
                               kRefusalTime);
    });
    Q_EMIT refused(reason);
}

void NumberEdit::keyPressEvent(QKeyEvent *event)
{
    if (takesKey(event))
        return;
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    const QString reason = isEnter ? refusal() : QString();
    if (!reason.isEmpty()) {
        refuse(reason);
        event->accept();
        return;
    }
    if (QToolTip::isVisible())
        QToolTip::hideText();
    if (event->key() == Qt::Key_Escape && lineEdit()->isModified())
        takeBack();
    QDoubleSpinBox::keyPressEvent(event);
}

void NumberEdit::focusOutEvent(QFocusEvent *event)
{
    const QString reason = lineEdit()->isModified() ? refusal() : QString();
    QDoubleSpinBox::focusOutEvent(event);
    if (!reason.isEmpty() && event->reason() != Qt::PopupFocusReason)
        refuse(reason);
}

void NumberEdit::wheelEvent(QWheelEvent *event)
{
    // Scrolling the panel must not change numbers on the way.
    if (hasFocus())
        QDoubleSpinBox::wheelEvent(event);
    else
        event->ignore();
}

} // namespace fff::ui
