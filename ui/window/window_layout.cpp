#include "ui/window/window_layout.h"

#include "ui/base/icon.h"
#include "ui/base/panes.h"
#include "ui/settings/settings.h"
#include "ui/window/dock_tabs.h"

#include <QDockWidget>
#include <QGuiApplication>
#include <QLayout>
#include <QMainWindow>
#include <QScreen>
#include <QTabBar>
#include <QToolBar>

#include <algorithm>
#include <utility>

namespace fff::ui {

namespace {

constexpr int kLeftWidth = 264, kRightWidth = 322; // px
/// Up to the larger one tabs have room for their names; with more of them they are icons.
constexpr int kNarrowRightWidth = 322, kMostNarrowRightWidth = 366; // px
constexpr int kBelowHeight = 400;                                   // px, of what is under the view
constexpr double kBelowShare = 0.4;                                 // of the left column's height
constexpr double kUnderShare = 0.45; // of the window's, at most: there is a view above it
constexpr int kTwoColumns = 1280;    // px; a narrower window has all docks at the right
/// Of what saveState() writes. Counted up when docks change so that an old state makes no sense.
constexpr int kVersion = 4;

/// Of two docks in a column, one above the other. The column is as high as what is beside it, whose
/// height is known while docks still have that of before.
void shareColumn(QMainWindow &window, QDockWidget *above, QDockWidget *below)
{
    constexpr int kTabsBetween = 28; // px
    const QWidget *beside = window.centralWidget();
    const int column = beside ? beside->height() - kTabsBetween : 0;
    const int share = static_cast<int>(kBelowShare * column);
    if (share > 0)
        window.resizeDocks({above, below}, {column - share, share}, Qt::Vertical);
}

Qt::DockWidgetArea areaOf(WindowLayout::Place place)
{
    if (place == WindowLayout::Place::Below)
        return Qt::BottomDockWidgetArea;
    return place == WindowLayout::Place::Right ? Qt::RightDockWidgetArea : Qt::LeftDockWidgetArea;
}

/// saveGeometry() knows the screen it was on; that one may be gone or smaller.
bool isOnScreen(const QRect &window)
{
    constexpr int kGrip = 80; // px of its upper edge that must be in reach
    for (const QScreen *screen : QGuiApplication::screens()) {
        const QRect seen =
            screen->availableGeometry() & QRect(window.topLeft(), QSize(window.width(), kGrip));
        if (seen.width() >= kGrip && seen.height() >= kGrip / 2)
            return true;
    }
    return false;
}

} // namespace

WindowLayout::WindowLayout(QMainWindow &window)
    : QObject(&window), m_window(window), m_tabs(new DockTabs(m_docks, this))
{
    window.setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowTabbedDocks |
                          QMainWindow::AllowNestedDocks);
    window.setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::South);
    window.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    window.setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
}

void WindowLayout::add(QDockWidget *dock, const char *icon, Place place, bool isShown)
{
    dock->setWindowIcon(themedIcon(QLatin1String(icon)));
    m_areShown.push_back(isShown ? 1 : 0);
    m_docks.push_back(dock);
    m_places.push_back(place);
    connect(dock, &QDockWidget::visibilityChanged, m_tabs, &DockTabs::followDocks);
    connect(dock, &QDockWidget::topLevelChanged, m_tabs, &DockTabs::followDocks);
    connect(dock, &QDockWidget::dockLocationChanged, m_tabs, &DockTabs::followDocks);
    // Opening one of them from the menu ends the hiding of all, and it is in front of its tabs.
    connect(dock->toggleViewAction(), &QAction::triggered, this, [this, dock](bool shows) {
        if (shows && m_isHidden)
            show(dock);
        if (shows)
            dock->raise();
        if (shows && isNarrow())
            widenForTabs();
    });
}

bool WindowLayout::isNarrow() const
{
    return m_window.width() < kTwoColumns;
}

int WindowLayout::narrowWidth() const
{
    const int names = m_tabs->widthOfNames();
    return names > kMostNarrowRightWidth ? kNarrowRightWidth : std::max(names, kNarrowRightWidth);
}

void WindowLayout::takeTabs(QObject *child)
{
    if (auto *tabs = qobject_cast<QTabBar *>(child))
        m_tabs->take(tabs);
}

/// One more tab than before: the names of all can be read still, as long as they have room.
void WindowLayout::widenForTabs()
{
    QDockWidget *first = m_docks.front();
    const int width = narrowWidth();
    if (!first->isFloating() && first->width() < width)
        m_window.resizeDocks({first}, {width}, Qt::Horizontal);
}

WindowLayout::Place WindowLayout::placeOf(std::size_t dock, bool narrow) const
{
    return narrow && m_places[dock] != Place::Below ? Place::Right : m_places[dock];
}

void WindowLayout::reset()
{
    const bool narrow = isNarrow(), wide = !narrow;
    // As on the left, unless all of them are there: many tabs are looked for at the top.
    m_window.setTabPosition(Qt::RightDockWidgetArea, wide ? QTabWidget::South : QTabWidget::North);
    for (QDockWidget *dock : m_docks) {
        dock->setFloating(false);
        m_window.removeDockWidget(dock);
    }
    QDockWidget *first[4] = {nullptr, nullptr, nullptr, nullptr}; // of each place
    for (std::size_t i = 0; i < m_docks.size(); ++i) {
        QDockWidget *&leader = first[static_cast<int>(placeOf(i, narrow))];
        if (leader)
            continue;
        leader = m_docks[i];
        m_window.addDockWidget(areaOf(placeOf(i, narrow)), leader);
    }
    QDockWidget *const right = first[static_cast<int>(Place::Right)],
                       *const left = first[static_cast<int>(Place::Left)],
                       *const below = first[static_cast<int>(Place::LeftBelow)],
                       *const under = first[static_cast<int>(Place::Below)];
    if (left && below) // before tabs: what is split off a tab becomes another one
        m_window.splitDockWidget(left, below, Qt::Vertical);
    for (std::size_t i = 0; i < m_docks.size(); ++i) {
        QDockWidget *leader = first[static_cast<int>(placeOf(i, narrow))];
        if (m_docks[i] != leader)
            m_window.tabifyDockWidget(leader, m_docks[i]);
        m_docks[i]->setVisible(m_areShown[i] != 0);
    }
    for (QDockWidget *leader : {right, left, below}) {
        if (leader)
            leader->raise();
    }
    if (left && below)
        shareColumn(m_window, left, below);
    if (left)
        m_window.resizeDocks({left}, {kLeftWidth}, Qt::Horizontal);
    if (right)
        m_window.resizeDocks({right}, {wide ? kRightWidth : narrowWidth()}, Qt::Horizontal);
    if (under)
        m_window.resizeDocks({under}, {heightUnder()}, Qt::Vertical);
    forgetHiding();
}

/// Whether no dock was moved since a window of this kind was arranged; sizes, and which are shown,
/// are of no account.
bool WindowLayout::isAsAtFirst(bool narrow) const
{
    for (std::size_t i = 0; i < m_docks.size(); ++i) {
        QDockWidget *dock = m_docks[i];
        if (dock->isFloating() || m_window.dockWidgetArea(dock) != areaOf(placeOf(i, narrow)))
            return false;
        if (dock->isHidden())
            continue; // Qt does not say of those whose tabs they would be
        const QList<QDockWidget *> beside = m_window.tabifiedDockWidgets(dock);
        for (std::size_t k = 0; k < i; ++k)
            if (!m_docks[k]->isHidden() &&
                beside.contains(m_docks[k]) != (placeOf(k, narrow) == placeOf(i, narrow)))
                return false;
    }
    return true;
}

void WindowLayout::followWidth()
{
    if (m_isHidden || m_isAway || !m_only.docks.empty() || isAsAtFirst(isNarrow()) ||
        !isAsAtFirst(!isNarrow()))
        return;
    std::vector<bool> areShown;
    for (const QDockWidget *dock : m_docks)
        areShown.push_back(!dock->isHidden());
    reset();
    for (std::size_t i = 0; i < m_docks.size(); ++i)
        m_docks[i]->setVisible(areShown[i]);
}

void WindowLayout::restore()
{
    const QSize before = m_window.size();
    if (m_window.restoreGeometry(settings().windowGeometry()) &&
        !isOnScreen(m_window.frameGeometry())) {
        m_window.setWindowState(Qt::WindowNoState);
        m_window.resize(before);
        m_window.move(m_window.screen()->availableGeometry().topLeft());
    }
    reset();
}

void WindowLayout::windowShown()
{
    const bool away = std::exchange(m_isAway, false);
    const Only only = std::exchange(m_only, {});
    reset();                       // where docks are that the kept state does not know
    m_window.layout()->activate(); // or sizes are taken for those of a window without bars
    const auto firstIn = [this](Place place) {
        const auto found = std::find(m_places.begin(), m_places.end(), place);
        return found == m_places.end()
                   ? nullptr
                   : m_docks[static_cast<std::size_t>(found - m_places.begin())];
    };
    QDockWidget *left = firstIn(Place::Left), *below = firstIn(Place::LeftBelow);
    if (left && below && !isNarrow())
        shareColumn(m_window, left, below);
    m_window.restoreState(settings().windowState(), kVersion);
    followWidth();
    m_only = only;
    m_isAway = away;
    follow();
}

void WindowLayout::save() const
{
    settings().setWindowGeometry(m_window.saveGeometry());
    settings().setWindowState(m_beforeHiding.isEmpty() ? m_window.saveState(kVersion)
                                                       : m_beforeHiding);
}

void WindowLayout::setHidden(bool hidden)
{
    if (hidden == m_isHidden)
        return;
    m_isHidden = hidden;
    follow();
    Q_EMIT hiddenChanged(hidden);
}

void WindowLayout::setAway(bool away)
{
    if (away == m_isAway)
        return;
    m_isAway = away;
    follow();
}

void WindowLayout::setOnly(const Only &only)
{
    const bool isSame = only == m_only;
    m_only = only;
    if (!isSame)
        follow();
}

bool WindowLayout::Only::has(const QDockWidget *dock) const
{
    return std::any_of(docks.begin(), docks.end(),
                       [dock](const auto &placed) { return placed.first == dock; });
}

void WindowLayout::setOwnBar(QToolBar *bar)
{
    m_ownBar = bar;
    showBars();
}

void WindowLayout::follow()
{
    if (!m_isHidden && !m_isAway && m_only.docks.empty())
        return bringBack();
    if (m_beforeHiding.isEmpty())
        m_beforeHiding = m_window.saveState(kVersion);
    for (QDockWidget *dock : m_docks)
        if (!m_only.has(dock) || m_isAway)
            dock->hide();
    if (!m_only.docks.empty() && !m_isAway)
        showOnly();
    showBars();
}

void WindowLayout::showOnly()
{
    for (const auto &[dock, area] : m_only.docks) {
        dock->setFloating(false);
        m_window.addDockWidget(area, dock);
        dock->show();
        m_window.resizeDocks({dock}, {kRightWidth}, Qt::Horizontal);
    }
}

void WindowLayout::showBars()
{
    for (QToolBar *bar : m_window.findChildren<QToolBar *>())
        bar->setVisible(!m_isAway && (bar == m_ownBar) == m_only.hasOwnBar);
}

void WindowLayout::bringBack()
{
    if (m_beforeHiding.isEmpty())
        return showBars();
    if (!m_window.restoreState(std::exchange(m_beforeHiding, {}), kVersion))
        reset();
    followWidth();
    showBars();
}

void WindowLayout::show(QDockWidget *dock)
{
    if (!m_only.docks.empty() && !m_only.has(dock))
        return;
    setHidden(false);
    setAway(false);
    dock->show();
    dock->raise();
    if (!dock->isFloating() && m_window.dockWidgetArea(dock) == Qt::BottomDockWidgetArea)
        leaveViewItsShare(dock);
}

void WindowLayout::offer(QDockWidget *dock)
{
    if ((!m_only.docks.empty() && !m_only.has(dock)) || m_isHidden || !dock->isHidden())
        return;
    QDockWidget *inFront = nullptr;
    for (QDockWidget *other : m_window.tabifiedDockWidgets(dock))
        if (isSeen(other))
            inFront = other;
    dock->show();
    if (inFront)
        inFront->raise();
    if (isNarrow())
        widenForTabs();
}

/// The window may have been higher when the dock was there last.
void WindowLayout::leaveViewItsShare(QDockWidget *under)
{
    m_window.layout()->activate();
    const int most = heightUnder();
    if (under->height() > most)
        m_window.resizeDocks({under}, {most}, Qt::Vertical);
}

int WindowLayout::heightUnder() const
{
    return std::min(kBelowHeight, static_cast<int>(kUnderShare * m_window.height()));
}

void WindowLayout::forgetHiding()
{
    m_beforeHiding.clear();
    const bool wasHidden = std::exchange(m_isHidden, false);
    if (m_isAway || !m_only.docks.empty())
        follow();
    if (wasHidden)
        Q_EMIT hiddenChanged(false);
}

} // namespace fff::ui
