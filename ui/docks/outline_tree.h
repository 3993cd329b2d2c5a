// The list of sections in the outline: a tree in which Space is for the eye, and a press on the
// lock selects nothing.
#pragma once

#include <QTreeWidget>

#include <functional>

namespace fff::ui {

class OutlineTree : public QTreeWidget
{
public:
    /// lockColumn: where the buttons are that lock a row.
    OutlineTree(int lockColumn, QWidget *parent);

    std::function<void(QTreeWidgetItem *)> toggle; // by Space
    std::function<void()> left;                    // by the mouse

protected:
    bool viewportEvent(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    QItemSelectionModel::SelectionFlags selectionCommand(const QModelIndex &index,
                                                         const QEvent *event) const override;

private:
    const int m_lockColumn;
};

} // namespace fff::ui
