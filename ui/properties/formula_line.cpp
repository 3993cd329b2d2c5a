#include "ui/properties/formula_line.h"

#include "ui/base/theme.h"
#include "ui/properties/name_completion.h"

#include <QFocusEvent>
#include <QKeyEvent>

#include <utility>

namespace fff::ui {

namespace {

constexpr int kRoomForSum = 96; // px; a narrower field takes that of its neighbours, too

} // namespace

FormulaLine::FormulaLine(QWidget *field, std::function<QString(const QString &)> takes,
                         std::function<QStringList()> names)
    : QLineEdit(field), m_field(field), m_takes(std::move(takes))
{
    new NameCompletion(this, NameCompletion::Where::Everywhere, std::move(names));
    setObjectName(QStringLiteral("formulaLine"));
    setFocusPolicy(Qt::ClickFocus); // Tab comes through the field
    connect(this, &QLineEdit::textEdited, this, [this] { showRefused({}); });
    hide();
}

void FormulaLine::open(const QString &text)
{
    fit();
    setText(text);
    setModified(false);
    showRefused({});
    show();
    raise();
    setFocus(Qt::OtherFocusReason);
}

void FormulaLine::fit()
{
    QWidget *row = m_field->parentWidget();
    const bool isNarrow = row && m_field->width() < kRoomForSum && row->width() > m_field->width();
    QWidget *under = isNarrow ? row : m_field;
    if (parentWidget() != under) {
        const bool wasOpen = isOpen();
        setParent(under);
        setVisible(wasOpen);
    }
    setGeometry(isNarrow ? QRect(0, m_field->y(), row->width(), m_field->height())
                         : m_field->rect());
}

void FormulaLine::close()
{
    m_isClosing = true;
    if (hasFocus())
        m_field->setFocus(Qt::OtherFocusReason);
    hide();
    setParent(m_field);
    m_isClosing = false;
}

/// It is red as long as what was refused stands there, and says why under the cursor.
void FormulaLine::showRefused(const QString &why)
{
    QPalette colours = m_field->palette();
    if (!why.isEmpty())
        colours.setColor(QPalette::Text, theme().problem);
    setPalette(colours);
    setToolTip(why);
}

bool FormulaLine::isTaken()
{
    const QString why = isModified() ? m_takes(text()) : QString();
    if (why.isEmpty())
        return true;
    showRefused(why);
    Q_EMIT refused(why);
    return false;
}

void FormulaLine::enter()
{
    if (isTaken())
        close();
}

void FormulaLine::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        enter();
    else if (event->key() == Qt::Key_Escape)
        close();
    else
        QLineEdit::keyPressEvent(event);
    // Also what a line of text has no use for, such as Shift: the field would hand it on to here.
    event->accept();
}

/// As of other fields: what cannot be taken is told and gone.
void FormulaLine::focusOutEvent(QFocusEvent *event)
{
    QLineEdit::focusOutEvent(event);
    if (m_isClosing || !isOpen() || event->reason() == Qt::PopupFocusReason ||
        event->reason() == Qt::ActiveWindowFocusReason)
        return;
    const QString why = isModified() ? m_takes(text()) : QString();
    close();
    if (!why.isEmpty())
        Q_EMIT refused(why);
}

bool FormulaLine::focusNextPrevChild(bool next)
{
    if (!isTaken())
        return true;
    close();
    return QLineEdit::focusNextPrevChild(next); // from the field, which has the focus now
}

} // namespace fff::ui
