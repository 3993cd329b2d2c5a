// The window of a model that was handed on for adjusting (Document::opensForAdjusting): the view to
// look at, the shown values, Export. It follows the document, so that undoing the step, a copy and
// what a crash left look as they should.
#pragma once

#include <QObject> // first: moc stumbles over some standard headers

#include <string_view>
#include <vector>

class QMenu;
class QMenuBar;

namespace fff::ui {

class ActionSet;
class AdjustBar;
class ValuesDock;
class WindowLayout;
class Workbench;

class Adjusting : public QObject
{
    Q_OBJECT
public:
    /// menus  with all that is in them; all outlive it
    Adjusting(Workbench &bench, ActionSet &actions, WindowLayout &layout, ValuesDock &values,
              AdjustBar &bar, const QMenuBar &menus, QObject *parent);

    bool isOn() const { return m_isOn; }
    /// What can be done to a model that is only adjusted: to look at it, to save and export it, and
    /// to have all of it again.
    static bool lets(std::string_view command);
    /// Brings the values to the front where a model was opened that shows some, once; call when the
    /// window shows it.
    void offerValues();

Q_SIGNALS:
    void changed();

private:
    void follow();
    void showUsedMenus();

    Workbench &m_bench;
    ActionSet &m_actions;
    WindowLayout &m_layout;
    ValuesDock &m_values;
    AdjustBar &m_bar;
    std::vector<QMenu *> m_menus; // of the bar, but for those that nobody sees
    bool m_isOn = false;
    bool m_isOpened = false; // another model, whose values were not offered yet
};

} // namespace fff::ui
