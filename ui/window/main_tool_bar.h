// The tool bar under the menus: actions in groups, the stock of the next section, Export. Narrow
// windows fold its labels away.
#pragma once

#include <QToolBar>

#include <vector>

class QToolButton;

namespace fff::ui {

class ActionSet;
class ExportButton;
class StockBox;
class Workbench;

class MainToolBar : public QToolBar
{
    Q_OBJECT
public:
    MainToolBar(Workbench &bench, const ActionSet &actions, QWidget *parent = nullptr);

    /// Shows what fits a window of this width, px.
    void fold(int windowWidth);
    /// In the colours of the theme.
    void refresh();

private:
    void makeRepeat();
    void placeOperations(bool hasButtons);
    void place(const std::vector<QAction *> &actions, bool isThere, QAction *before);
    void followSelection();
    void setFolded(bool isFolded);
    int roomOfSection() const;
    void showUsedSeparators();

    Workbench &m_bench;
    StockBox *m_stock = nullptr;
    ExportButton *m_export = nullptr;
    std::vector<QAction *> m_operations;
    std::vector<QAction *> m_ofSection; // there while one is selected
    QAction *m_ofDrawing = nullptr;     // beside them
    QAction *m_rotational = nullptr;    // in the menu alone
    QToolButton *m_repeat = nullptr;
    QAction *m_repeatAction = nullptr, *m_afterOperations = nullptr, *m_stretch = nullptr;
};

} // namespace fff::ui
