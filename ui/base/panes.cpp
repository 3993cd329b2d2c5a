#include "ui/base/panes.h"

#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>

#include <algorithm>

namespace fff::ui {

namespace {

/// Where it comes: by column, in one from top to bottom; floating ones last.
int rankOf(const QMainWindow &window, QDockWidget *dock)
{
    if (dock->isFloating())
        return 4;
    switch (window.dockWidgetArea(dock)) {
    case Qt::LeftDockWidgetArea:
        return 0;
    case Qt::TopDockWidgetArea:
        return 1;
    case Qt::RightDockWidgetArea:
        return 2;
    default:
        return 3;
    }
}

/// The first that Tab would find inside; null without one.
QWidget *firstField(QWidget *pane)
{
    if (pane->focusPolicy() != Qt::NoFocus)
        return pane;
    for (QWidget *next = pane->nextInFocusChain(); next && next != pane;
         next = next->nextInFocusChain()) {
        const bool takesKeys = (next->focusPolicy() & Qt::TabFocus) == Qt::TabFocus;
        if (pane->isAncestorOf(next) && takesKeys && next->isEnabled() && isSeen(next))
            return next;
    }
    return nullptr;
}

} // namespace

bool isSeen(const QWidget *widget)
{
    // By where it lies: a dock without a title is covered with its content, and has no visible
    // region of its own.
    QRect seen = widget->rect();
    for (const QWidget *at = widget; !at->isWindow() && at->parentWidget(); at = at->parentWidget())
        seen = seen.translated(at->pos()) & at->parentWidget()->rect();
    return widget->isVisible() && !seen.isEmpty();
}

void goToPane(QMainWindow &window, QWidget *toolBar, QWidget *view, int step)
{
    QList<QDockWidget *> docks;
    for (QDockWidget *dock : window.findChildren<QDockWidget *>()) {
        if (isSeen(dock))
            docks += dock;
    }
    std::stable_sort(docks.begin(), docks.end(), [&window](QDockWidget *a, QDockWidget *b) {
        const int rankA = rankOf(window, a), rankB = rankOf(window, b);
        return rankA != rankB ? rankA < rankB : a->y() < b->y();
    });
    QList<QWidget *> panes{toolBar};
    for (QDockWidget *dock : docks) {
        if (rankOf(window, dock) == 0)
            panes += dock->widget();
    }
    panes += view;
    for (QDockWidget *dock : docks) {
        if (rankOf(window, dock) != 0)
            panes += dock->widget();
    }
    const QWidget *focus = QApplication::focusWidget();
    const qsizetype count = panes.size();
    qsizetype at = panes.indexOf(view); // outside of all: on from the view
    for (qsizetype i = 0; i < count; ++i) {
        if (focus && (panes[i] == focus || panes[i]->isAncestorOf(focus)))
            at = i;
    }
    for (qsizetype i = 1; i <= count; ++i) {
        QWidget *pane = panes[((at + step * i) % count + count) % count];
        QWidget *last = pane->focusWidget(); // that had it last in there
        QWidget *to = last && isSeen(last) && last->isEnabled() ? last : firstField(pane);
        if (!to)
            continue;
        to->window()->activateWindow();
        to->setFocus(Qt::TabFocusReason);
        return;
    }
}

bool isInDock(const QWidget *widget)
{
    while (widget && !qobject_cast<const QDockWidget *>(widget))
        widget = widget->parentWidget();
    return widget != nullptr;
}

void goInto(QDockWidget &dock)
{
    dock.show();
    dock.raise();
    if (QWidget *field = dock.widget() ? firstField(dock.widget()) : nullptr)
        field->setFocus(Qt::ShortcutFocusReason);
}

} // namespace fff::ui
