#include "ui/docks/outline_tree.h"

#include "ui/docks/outline_marks.h"

#include <QEvent>
#include <QKeyEvent>

namespace fff::ui {

OutlineTree::OutlineTree(int lockColumn, QWidget *parent)
    : QTreeWidget(parent), m_lockColumn(lockColumn)
{
}

bool OutlineTree::viewportEvent(QEvent *event)
{
    if (event->type() == QEvent::Leave)
        left();
    return QTreeWidget::viewportEvent(event);
}

void OutlineTree::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Space && currentItem())
        toggle(currentItem());
    else
        QTreeWidget::keyPressEvent(event);
}

QItemSelectionModel::SelectionFlags OutlineTree::selectionCommand(const QModelIndex &index,
                                                                  const QEvent *event) const
{
    if (isOnButton(index, event, m_lockColumn))
        return QItemSelectionModel::NoUpdate;
    return QTreeWidget::selectionCommand(index, event);
}

} // namespace fff::ui
