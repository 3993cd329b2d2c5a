#include "ui/window/dock_tabs.h"

#include "ui/base/theme.h"
#include "ui/docks/dock_title.h"

#include <QDockWidget>
#include <QEvent>
#include <QFont>
#include <QFontMetrics>
#include <QIcon>
#include <QStyle>

#include <algorithm>
#include <utility>

namespace fff::ui {

namespace {

/// Of a tab: its words, and what is beside them, px (resources/style/window.qss).
constexpr int kTabWords = 12, kTabBorders = 14;
constexpr int kTabIcon = 16;             // px
constexpr char kAreIcons[] = "areIcons"; // the style sheet's word for it

int widthOfName(const QFont &font, const QString &name)
{
    QFont words = font;
    words.setPixelSize(kTabWords);
    return QFontMetrics(words).horizontalAdvance(name) + kTabBorders;
}

} // namespace

DockTabs::DockTabs(const std::vector<QDockWidget *> &docks, QObject *parent)
    : QObject(parent), m_docks(docks)
{
}

int DockTabs::widthOfNames() const
{
    int width = 0;
    for (const QDockWidget *dock : m_docks)
        if (!dock->isHidden())
            width += widthOfName(dock->font(), dock->windowTitle());
    return width;
}

void DockTabs::take(QTabBar *tabs)
{
    if (!tabs->property(kAreIcons).isValid()) {
        tabs->setProperty(kAreIcons, false);
        tabs->setUsesScrollButtons(false);
        tabs->setIconSize({kTabIcon, kTabIcon});
        tabs->installEventFilter(this);
        std::erase_if(m_bars, [](const QPointer<QTabBar> &bar) { return bar.isNull(); });
        m_bars.emplace_back(tabs);
    }
    dress(tabs);
    follow(*tabs);
}

bool DockTabs::eventFilter(QObject *watched, QEvent *event)
{
    auto *tabs = qobject_cast<QTabBar *>(watched);
    if (tabs && event->type() == QEvent::Resize)
        follow(*tabs);
    // A dock that comes or goes beside the others: no other event says so.
    else if (tabs && event->type() == QEvent::Paint)
        QMetaObject::invokeMethod(
            tabs, [this, tabs] { follow(*tabs); }, Qt::QueuedConnection);
    return QObject::eventFilter(watched, event);
}

bool DockTabs::isNamedAtTop(const QDockWidget &dock) const
{
    return !dock.isFloating() &&
           std::any_of(m_bars.begin(), m_bars.end(), [&dock](const QPointer<QTabBar> &bar) {
               if (!bar || !bar->isVisible() || bar->shape() != QTabBar::RoundedNorth)
                   return false;
               int tab = 0;
               while (tab < bar->count() && bar->tabText(tab) != dock.windowTitle())
                   ++tab;
               return tab < bar->count() && bar->count() > 1;
           });
}

/// Later: Qt has not put the tabs in order yet as it says that a dock came.
void DockTabs::followDocks()
{
    if (std::exchange(m_isFollowing, true))
        return;
    QMetaObject::invokeMethod(
        this,
        [this] {
            m_isFollowing = false;
            for (QDockWidget *dock : m_docks)
                setDockTitled(*dock, !isNamedAtTop(*dock));
        },
        Qt::QueuedConnection);
}

bool DockTabs::haveNames(const QTabBar &tabs) const
{
    int width = 0;
    for (int i = 0; i < tabs.count(); ++i)
        width += widthOfName(tabs.font(), tabs.tabText(i));
    return width <= tabs.width();
}

QIcon DockTabs::iconOf(const QTabBar &tabs, int tab) const
{
    const auto dock = std::find_if(m_docks.begin(), m_docks.end(), [&](const QDockWidget *one) {
        return one->windowTitle() == tabs.tabText(tab);
    });
    return dock == m_docks.end() ? QIcon() : (*dock)->windowIcon();
}

/// Changes only what differs: each change paints the tabs again.
void DockTabs::follow(QTabBar &tabs)
{
    followDocks();
    const bool areIcons = !haveNames(tabs);
    for (int i = 0; i < tabs.count(); ++i) {
        const QIcon icon = areIcons ? iconOf(tabs, i) : QIcon();
        if (icon.cacheKey() != tabs.tabIcon(i).cacheKey())
            tabs.setTabIcon(i, icon);
    }
    if (tabs.property(kAreIcons).toBool() == areIcons)
        return;
    tabs.setProperty(kAreIcons, areIcons);
    tabs.style()->unpolish(&tabs);
    tabs.style()->polish(&tabs);
    // Sizes are measured anew where something of a tab changes.
    if (tabs.count() > 0)
        tabs.setTabText(0, tabs.tabText(0));
}

} // namespace fff::ui
