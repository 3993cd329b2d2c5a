// Where the docks of a window are: at first, as the person put them, hidden all together and back.
#pragma once

#include <QByteArray>
#include <QObject>
#include <Qt>

#include <utility>
#include <vector>

class QDockWidget;
class QMainWindow;
class QToolBar;

namespace fff::ui {

class DockTabs;

class WindowLayout : public QObject
{
    Q_OBJECT
public:
    /// Where a dock is at first in a wide window. Docks of one place are tabs of each other; a
    /// narrow window has those at the sides as tabs at the right, in the order in which they were
    /// added. Below: under the view, from the left column to the window's right edge.
    enum class Place { Right, Left, LeftBelow, Below };

    explicit WindowLayout(QMainWindow &window);

    /// icon     what its tab has where names have no room, as in resources/icons
    /// isShown  before the person has arranged the window
    void add(QDockWidget *dock, const char *icon, Place place, bool isShown = true);
    /// A new child of the window: the tabs that Qt makes for docks when it needs them.
    void takeTabs(QObject *child);
    const std::vector<QDockWidget *> &docks() const { return m_docks; }

    /// Every dock where it is at first, for the window's present width.
    void reset();
    /// The window's size as save() has kept it, unless this screen cannot follow. Call when all
    /// docks were added, before the window is shown.
    void restore();
    /// For the next start. Docks that are hidden all together are kept as they were before.
    void save() const;
    /// The docks as save() has kept them; what this version cannot follow is as at first. Call when
    /// the window is shown: only now its real size is known.
    void windowShown();

    /// All docks away, and back exactly as they were.
    void setHidden(bool hidden);
    bool isHidden() const { return m_isHidden; }
    /// Docks and tool bar away while there is no model to work on, and back as they were.
    void setAway(bool away);
    struct Only
    {
        std::vector<std::pair<QDockWidget *, Qt::DockWidgetArea>> docks = {}; // empty: all of them
        bool hasOwnBar = false; // in place of the others

        bool has(const QDockWidget *dock) const;
        bool operator==(const Only &) const = default;
    };
    /// These docks there, all others away; or all back exactly as they were.
    void setOnly(const Only &only);
    /// The tool bar that is there with a dock alone, and never else.
    void setOwnBar(QToolBar *bar);
    /// Call when the window has another width. Docks that are still where a window of the other
    /// kind (wide, narrow) has them go where this one has them; what the person has moved stays.
    void followWidth();
    /// Brings a dock to the front, wherever it is; the others too, if all were hidden. Nothing
    /// while another is the only one.
    void show(QDockWidget *dock);
    /// Its tab is there, behind what is looked at.
    void offer(QDockWidget *dock);

Q_SIGNALS:
    void hiddenChanged(bool hidden);

private:
    bool isNarrow() const;
    int narrowWidth() const; // px, of the column
    int heightUnder() const; // px, of what is below the view
    void leaveViewItsShare(QDockWidget *under);
    void widenForTabs();
    void follow();
    void bringBack();
    Place placeOf(std::size_t dock, bool narrow) const;
    bool isAsAtFirst(bool narrow) const;
    void forgetHiding();
    void showOnly();
    void showBars();

    QMainWindow &m_window;
    std::vector<QDockWidget *> m_docks;
    DockTabs *m_tabs;
    std::vector<Place> m_places;  // one a dock
    std::vector<char> m_areShown; // at first
    QByteArray m_beforeHiding;    // empty: nothing is hidden
    bool m_isHidden = false, m_isAway = false;
    Only m_only;
    QToolBar *m_ownBar = nullptr;
};

} // namespace fff::ui
