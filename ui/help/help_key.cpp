#include "ui/help/help_key.h"

#include <QApplication>
#include <QCursor>
#include <QKeyEvent>

namespace fff::ui {

namespace {

bool isOf(const QWidget &window, const QWidget *widget)
{
    for (; widget; widget = widget->parentWidget())
        if (widget == &window)
            return true;
    return false;
}

} // namespace

QWidget *pointedAt(const QWidget &window)
{
    for (QWidget *widget : {QApplication::widgetAt(QCursor::pos()), QApplication::focusWidget()})
        if (isOf(window, widget))
            return widget;
    return nullptr;
}

HelpKey::HelpKey(QWidget &window, Show show)
    : QObject(&window), m_window(window), m_show(std::move(show))
{
    QCoreApplication::instance()->installEventFilter(this);
}

bool HelpKey::eventFilter(QObject *object, QEvent *event)
{
    if (event->type() != QEvent::KeyPress || static_cast<QKeyEvent *>(event)->key() != Qt::Key_F1)
        return QObject::eventFilter(object, event);
    QWidget *menu = QApplication::activePopupWidget(), *dialog = QApplication::activeModalWidget();
    QWidget *over = menu ? menu : dialog;
    if (!over || !object->isWidgetType() || !isOf(m_window, over))
        return QObject::eventFilter(object, event);
    const HelpTopic topic = topicAt(menu ? menu : pointedAt(*dialog));
    while (QWidget *popup = QApplication::activePopupWidget())
        popup->close();
    m_show(topic, dialog);
    return true;
}

} // namespace fff::ui
