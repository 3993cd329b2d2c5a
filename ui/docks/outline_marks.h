// What the trees of the Outline have in common.
#pragma once

#include <QIcon>
#include <QString>

class QEvent;
class QModelIndex;
class QTreeWidget;
class QTreeWidgetItem;

namespace fff::ui {

inline constexpr int kOutlineRow = 24; // px

/// Frame, fonts and columns: the first one stretches, those after it up to the eye's are narrow.
void dressOutline(QTreeWidget *tree, int lastColumn);

/// Sets an icon only where it differs: every change is announced and painted. mark: what the icon
/// is made of.
void setMark(QTreeWidgetItem *item, int column, const QString &mark, const QIcon &icon,
             const QString &tip);

/// The new name that was typed into an item's first column; empty where it is as before. Where
/// nothing was typed, the name before is put back.
QString typedName(QTreeWidgetItem *item, const QString &before);

/// The eye, and what else stands right of the first such column, is a button: a click on it does
/// not select.
bool isOnButton(const QModelIndex &index, const QEvent *event, int firstColumn);

} // namespace fff::ui
