// The sections as a tree by parent, with a filter. Selecting works both ways with the view; F2
// renames.
#pragma once

#include <QDockWidget>

class QLabel;
class QLineEdit;
class QTreeWidget;
class QTreeWidgetItem;

namespace fff::ui {

class Workbench;

class OutlineDock : public QDockWidget
{
    Q_OBJECT
public:
    explicit OutlineDock(Workbench &bench, QWidget *parent = nullptr);

    /// In the colours of the theme.
    void refreshColours();

private:
    void rebuild();
    void rename(QTreeWidgetItem *item);
    void applyFilter();
    void takeSelection();
    void showSelection();

    Workbench &m_bench;
    QLineEdit *m_filter = nullptr;
    QTreeWidget *m_tree = nullptr;
    QLabel *m_empty = nullptr;
    bool m_isFilling = false;
    bool m_showsPreview = false;
};

} // namespace fff::ui
