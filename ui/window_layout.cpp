#include "ui/window_layout.h"

#include <QDockWidget>
#include <QMainWindow>

namespace fff::ui {

namespace {

constexpr int kLeftWidth = 264, kRightWidth = 314, kNarrowRightWidth = 306; // px
constexpr int kTwoColumns = 1280; // px; a narrower window has all docks at the right

} // namespace

WindowLayout::WindowLayout(QMainWindow &window) : QObject(&window), m_window(window)
{
    window.setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowTabbedDocks |
                          QMainWindow::AllowNestedDocks);
    window.setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
}

void WindowLayout::add(QDockWidget *dock, Place place)
{
    m_docks.push_back(dock);
    m_places.push_back(place);
}

void WindowLayout::reset()
{
    const bool wide = m_window.width() >= kTwoColumns;
    for (QDockWidget *dock : m_docks) {
        dock->setFloating(false);
        m_window.removeDockWidget(dock);
    }
    QList<QDockWidget *> columns;
    QList<int> widths;
    QDockWidget *right = nullptr;
    for (std::size_t i = 0; i < m_docks.size(); ++i) {
        const bool isLeft = wide && m_places[i] == Place::Left;
        m_window.addDockWidget(isLeft ? Qt::LeftDockWidgetArea : Qt::RightDockWidgetArea,
                               m_docks[i]);
        m_docks[i]->show();
        if (m_places[i] == Place::Right)
            right = m_docks[i];
        if (wide) {
            columns += m_docks[i];
            widths += isLeft ? kLeftWidth : kRightWidth;
        }
    }
    if (!wide && right) {
        for (QDockWidget *dock : m_docks) {
            if (dock != right)
                m_window.tabifyDockWidget(right, dock);
        }
        right->raise();
        columns += right;
        widths += kNarrowRightWidth;
    }
    m_window.resizeDocks(columns, widths, Qt::Horizontal);
    m_beforeHiding.clear();
    if (m_isHidden) {
        m_isHidden = false;
        Q_EMIT hiddenChanged(false);
    }
}

void WindowLayout::setHidden(bool hidden)
{
    if (hidden == m_isHidden)
        return;
    m_isHidden = hidden;
    if (hidden) {
        m_beforeHiding = m_window.saveState();
        for (QDockWidget *dock : m_docks)
            dock->hide();
    } else {
        m_window.restoreState(m_beforeHiding);
    }
    Q_EMIT hiddenChanged(hidden);
}

} // namespace fff::ui
