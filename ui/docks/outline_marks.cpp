#include "ui/docks/outline_marks.h"

#include <QEvent>
#include <QHeaderView>
#include <QTreeWidget>

namespace fff::ui {

namespace {

constexpr int kMarkRole = Qt::UserRole + 16; // what a column's icon is made of
constexpr int kMarkWidth = 24;               // px

} // namespace

void dressOutline(QTreeWidget *tree, int lastColumn)
{
    tree->header()->setStretchLastSection(false);
    tree->header()->setMinimumSectionSize(kMarkWidth);
    tree->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    for (int column = 1; column <= lastColumn; ++column) {
        tree->header()->setSectionResizeMode(column, QHeaderView::Fixed);
        tree->setColumnWidth(column, kMarkWidth);
    }
    tree->setFrameShape(QFrame::NoFrame);
    tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
    tree->setEditTriggers(QAbstractItemView::EditKeyPressed);
    tree->setAllColumnsShowFocus(true);
    tree->setIconSize({16, 16});
    tree->setIndentation(16);
    tree->setUniformRowHeights(true);
}

void setMark(QTreeWidgetItem *item, int column, const QString &mark, const QIcon &icon,
             const QString &tip)
{
    if (item->data(column, kMarkRole).toString() == mark)
        return;
    item->setData(column, kMarkRole, mark);
    item->setIcon(column, icon);
    item->setToolTip(column, tip);
    item->setData(column, Qt::AccessibleTextRole, tip);
}

QString typedName(QTreeWidgetItem *item, const QString &before)
{
    const QString name = item->text(0).trimmed();
    if (name.isEmpty())
        item->setText(0, before);
    return name == before ? QString() : name;
}

bool isOnButton(const QModelIndex &index, const QEvent *event, int firstColumn)
{
    return event && index.column() >= firstColumn &&
           (event->type() == QEvent::MouseButtonPress ||
            event->type() == QEvent::MouseButtonRelease);
}

} // namespace fff::ui
