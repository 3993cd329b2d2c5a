// Rows of a list with a name and, below it, what it is.
#pragma once

#include <QStyledItemDelegate>

namespace fff::ui {

/// Of an item, the text of its second line: a string.
inline constexpr int kSecondLineRole = Qt::UserRole + 40;

/// Where an item has a second line, its name stands above the middle; an editor takes that place.
class TwoLines : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;
    void updateEditorGeometry(QWidget *editor, const QStyleOptionViewItem &option,
                              const QModelIndex &index) const override;
};

} // namespace fff::ui
