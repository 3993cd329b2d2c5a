// The stock of the next section in the tool bar: looks like a choice box, opens a menu with the
// stocks, a slider for the thickness and the stock editor.
#pragma once

#include "ui/properties/choice_box.h"

class QAction;
class QMenu;

namespace fff::ui {

class ThicknessField;
class Workbench;

class StockBox : public ChoiceBox
{
    Q_OBJECT
public:
    explicit StockBox(Workbench &bench, QWidget *parent = nullptr);

    /// Shows no more than the thickness.
    void setShort(bool isShort);
    /// What opens the editor of stocks; where it is not to be had, it is not offered.
    void setEditorAction(const QAction *action) { m_editorAction = action; }

    void showPopup() override;
    void hidePopup() override;

Q_SIGNALS:
    void editorWanted();

private:
    void refresh();
    void fillMenu();

    Workbench &m_bench;
    QMenu *m_menu = nullptr;
    ThicknessField *m_thickness = nullptr;
    const QAction *m_editorAction = nullptr;
    bool m_isShort = false;
};

} // namespace fff::ui
