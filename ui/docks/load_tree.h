// What acts on the model, below the sections in the Outline. Not there while nothing does.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "core/model/load.h"

#include <vector>

class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace fff::ui {

class Workbench;

class LoadTree : public QWidget
{
    Q_OBJECT
public:
    LoadTree(Workbench &bench, QWidget *parent);

    /// In the colours of the theme.
    void refreshColours();
    /// Its key does something to the load that is selected, as in the view.
    void addKey(QAction *action);

private:
    void followModel();
    QString titleOf(const Load &load) const;
    void writeRows();
    void fit();
    void rename(QTreeWidgetItem *item);
    void takeSelection();
    void showSelection();

    Workbench &m_bench;
    QLabel *m_title = nullptr;
    QTreeWidget *m_tree = nullptr;
    std::vector<Load> m_shown; // what the rows are of
    std::vector<QString> m_titles;
    bool m_isFilling = false;
};

} // namespace fff::ui
