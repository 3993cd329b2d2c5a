#include "ui/properties/formula_line.h"

#include "ui/properties/name_completion.h"

#include <QFocusEvent>
#include <QKeyEvent>

#include <utility>

namespace fff::ui {

FormulaLine::FormulaLine(QWidget *field, std::function<QString(const QString &)> takes,
                         std::function<QStringList()> names)
    : QLineEdit(field), m_field(field), m_takes(std::move(takes))
{
    new NameCompletion(this, NameCompletion::Where::Everywhere, std::move(names));
    setObjectName(QStringLiteral("formulaLine"));
    setFocusPolicy(Qt::ClickFocus); // Tab comes through the field
    hide();
}

void FormulaLine::open(const QString &text)
{
    setGeometry(m_field->rect());
    setText(text);
    setModified(false);
    show();
    raise();
    setFocus(Qt::OtherFocusReason);
}

void FormulaLine::close()
{
    m_isClosing = true;
    if (hasFocus())
        m_field->setFocus(Qt::OtherFocusReason);
    hide();
    m_isClosing = false;
}

void FormulaLine::enter()
{
    if (isModified()) {
        const QString why = m_takes(text());
        if (!why.isEmpty()) {
            Q_EMIT refused(why);
            return;
        }
        setModified(false);
    }
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
    const QString why = isModified() ? m_takes(text()) : QString();
    if (!why.isEmpty()) {
        Q_EMIT refused(why);
        return true;
    }
    close();
    return QLineEdit::focusNextPrevChild(next); // from the field, which has the focus now
}

} // namespace fff::ui
