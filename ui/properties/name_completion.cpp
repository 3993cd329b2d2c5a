#include "ui/properties/name_completion.h"

#include "ui/base/theme.h"

#include <QAbstractItemView>
#include <QCompleter>
#include <QKeyEvent>
#include <QLineEdit>
#include <QStringListModel>

namespace fff::ui {

namespace {

constexpr int kListWidth = 160; // px

bool isOfName(QChar letter)
{
    return letter.isLetterOrNumber() || letter == u'_';
}

} // namespace

NameCompletion::NameCompletion(QLineEdit *line, Where where, std::function<QStringList()> names)
    : QObject(line), m_line(line), m_where(where), m_names(std::move(names))
{
    connect(m_line, &QLineEdit::textEdited, this, &NameCompletion::offer);
    m_line->installEventFilter(this);
}

void NameCompletion::makeList()
{
    m_list = new QCompleter(this);
    m_model = new QStringListModel(m_list);
    m_list->setModel(m_model);
    m_list->setWidget(m_line);
    m_list->setCaseSensitivity(Qt::CaseInsensitive);
    m_list->popup()->setObjectName(QStringLiteral("nameList"));
    connect(m_list, qOverload<const QString &>(&QCompleter::activated), this,
            &NameCompletion::complete);
}

bool NameCompletion::isOpen() const
{
    return m_list && m_list->popup()->isVisible();
}

/// A word that is not whole yet, and no unit: what stands behind a digit is one.
void NameCompletion::offer()
{
    const QString text = m_line->text();
    const qsizetype cursor = m_line->cursorPosition();
    m_wordBegin = cursor;
    while (m_wordBegin > 0 && isOfName(text[m_wordBegin - 1]))
        --m_wordBegin;
    const QString word = text.mid(m_wordBegin, cursor - m_wordBegin);
    const bool isExpression = m_where == Where::Everywhere || text.trimmed().startsWith(u'=');
    const bool isName = isExpression && !word.isEmpty() && !word[0].isDigit();
    const QStringList names = isName ? m_names() : QStringList();
    if (!m_list && names.isEmpty())
        return;
    if (!m_list)
        makeList();
    const bool isWhole = names.contains(word, Qt::CaseInsensitive);
    m_model->setStringList(names);
    m_list->setCompletionPrefix(word);
    if (!isName || m_list->completionCount() == 0 || (isWhole && m_list->completionCount() == 1)) {
        m_list->popup()->hide();
        return;
    }
    QAbstractItemView *popup = m_list->popup();
    popup->setPalette(theme().palette());
    m_list->complete(QRect(0, 0, std::max(kListWidth, m_line->width()), m_line->height() + 4));
    popup->setCurrentIndex(m_list->completionModel()->index(0, 0));
}

void NameCompletion::complete(const QString &name)
{
    const QString text = m_line->text();
    qsizetype end = m_wordBegin;
    while (end < text.size() && isOfName(text[end]))
        ++end;
    m_line->setSelection(static_cast<int>(m_wordBegin), static_cast<int>(end - m_wordBegin));
    m_line->insert(name);
    m_list->popup()->hide();
}

bool NameCompletion::eventFilter(QObject *object, QEvent *event)
{
    return (event->type() == QEvent::KeyPress && takes(*static_cast<QKeyEvent *>(event))) ||
           QObject::eventFilter(object, event);
}

bool NameCompletion::takes(const QKeyEvent &event)
{
    if (!isOpen())
        return false;
    const bool takesName =
        event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter || event.key() == Qt::Key_Tab;
    const QModelIndex chosen = m_list->popup()->currentIndex();
    if (takesName && chosen.isValid())
        complete(chosen.data().toString());
    else if (takesName || event.key() == Qt::Key_Escape)
        m_list->popup()->hide();
    return takesName || event.key() == Qt::Key_Escape;
}

} // namespace fff::ui
