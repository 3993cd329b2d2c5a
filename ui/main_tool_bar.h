// The tool bar under the menus: actions in groups, the stock of the next section, Export. Narrow
// windows fold its labels away.
#pragma once

#include <QToolBar>

class QPushButton;

namespace fff::ui {

class ActionSet;
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
    void makeExport(QAction *exporting);

    Workbench &m_bench;
    StockBox *m_stock = nullptr;
    QPushButton *m_export = nullptr;
};

} // namespace fff::ui
