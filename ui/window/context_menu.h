// The menu that a right click opens in the view, or the menu key: what can be done with what lies
// there, of the table of actions.
#pragma once

#include <QObject> // first: moc stumbles over some standard headers

class QAction;
class QPoint;
class QWidget;

namespace fff::ui {

class ActionSet;
class Workbench;

class ContextMenu : public QObject
{
    Q_OBJECT
public:
    /// All outlive it.
    ContextMenu(Workbench &bench, ActionSet &actions, QWidget *view);

    /// Of what the cursor is on, which is selected for it; in a place of the view.
    void openAt(const QPoint &inView);
    /// Of what is selected, at its middle.
    void openForSelection();
    /// The same in a list of what there is, at a place on the screen; rename: what it adds.
    void openInList(const QPoint &onScreen, QAction *rename);

private:
    /// Key of the menu in the table. Selects what the cursor is on.
    const char *chooseHovered();
    const char *ofSelection() const;
    void open(const char *key, const QPoint &onScreen, QAction *rename = nullptr);

    Workbench &m_bench;
    ActionSet &m_actions;
    QWidget *m_view;
};

} // namespace fff::ui
