// The tabs of docks that share a place: their names as long as all of these can be read, else the
// icon of each dock, with the name of the one in front alone. They never scroll. Below tabs at the
// top docks have no title: the tab says the same.
#pragma once

#include <QObject>
#include <QPointer>
#include <QTabBar>

#include <vector>

class QDockWidget;
class QIcon;

namespace fff::ui {

class DockTabs : public QObject
{
public:
    /// Of the docks of one window, which are added to the list later.
    DockTabs(const std::vector<QDockWidget *> &docks, QObject *parent);

    /// px; what the names of all docks take that are there.
    int widthOfNames() const;
    /// From now on this one has the theme's colours, and names or icons by its width and its docks.
    void take(QTabBar *tabs);
    /// Once a dock came, went or moved: which of them have a title.
    void followDocks();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    bool haveNames(const QTabBar &tabs) const;
    QIcon iconOf(const QTabBar &tabs, int tab) const;
    void follow(QTabBar &tabs);

    bool isNamedAtTop(const QDockWidget &dock) const;

    const std::vector<QDockWidget *> &m_docks;
    std::vector<QPointer<QTabBar>> m_bars;
    bool m_isFollowing = false; // soon
};

} // namespace fff::ui
