// How much of the window is there: all of it; the simple part, with which one draws, checks and
// exports (a setting, for classes); or the view, the shown values and Export, of a model that was
// handed on for adjusting (Document::opensForAdjusting). It follows the document and the setting,
// so that undoing the step, a copy and what a crash left look as they should.
#pragma once

#include <QObject> // first: moc stumbles over some standard headers

#include <string_view>
#include <vector>

class QDockWidget;
class QMenu;
class QMenuBar;
class QToolBar;

namespace fff::ui {

class ActionSet;
class ValuesDock;
class WindowLayout;
class Workbench;

class WindowScope : public QObject
{
    Q_OBJECT
public:
    enum class Scope { Whole, Simple, Adjusting };
    /// What the scopes need: of the simple one the dock that stays, of adjusting its dock and bar.
    struct Parts
    {
        QDockWidget *simple = nullptr;
        ValuesDock *values = nullptr;
        QToolBar *adjustBar = nullptr;
    };

    /// menus  with all that is in them; all outlive it
    WindowScope(Workbench &bench, ActionSet &actions, WindowLayout &layout, const Parts &parts,
                const QMenuBar &menus, QObject *parent);

    Scope scope() const { return m_scope; }
    bool isAdjusting() const { return m_scope == Scope::Adjusting; }
    /// What can be done in it: to a model that is only adjusted, to look at it, to save and export
    /// it, and to have all of it again.
    static bool lets(Scope scope, std::string_view command);
    /// Brings the values to the front where a model was opened that shows some, once; call when the
    /// window shows it.
    void offerValues();

Q_SIGNALS:
    void changed();

private:
    Scope wanted() const;
    void follow();
    void showUsedMenus();

    Workbench &m_bench;
    ActionSet &m_actions;
    WindowLayout &m_layout;
    const Parts m_parts;
    std::vector<QMenu *> m_menus; // of the bar, but for those that nobody sees
    Scope m_scope = Scope::Whole;
    bool m_hasValues = false; // to be set in it
    bool m_isOpened = false;  // another model, whose values were not offered yet
};

} // namespace fff::ui
