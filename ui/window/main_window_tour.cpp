// The tour in this window: what its steps are done with, and where it begins.
#include "ui/actions/action_set.h"
#include "ui/bench/workbench.h"
#include "ui/docks/checks_dock.h"
#include "ui/files/document_files.h"
#include "ui/tour/tour_guide.h"
#include "ui/window/badges.h"
#include "ui/window/main_tool_bar.h"
#include "ui/window/main_window.h"
#include "ui/window/window_scope.h"
#include "ui/window/windows.h"

#include <QMenu>

namespace fff::ui {

void MainWindow::makeTour()
{
    const auto targetOf = [this](Tour::Step step) -> QWidget * {
        const auto onBar = [this](const char *name) {
            return m_toolBar->findChild<QWidget *>(QLatin1String(name));
        };
        switch (step) {
        case Tour::Step::Thickness:
            return onBar("toolStock");
        case Tour::Step::Check:
            return m_badges;
        case Tour::Step::Repeat: {
            QWidget *linear = m_toolBar->widgetForAction(m_actions->action("operation.linear"));
            return linear ? linear : onBar("repeatButton");
        }
        case Tour::Step::Export:
            return onBar("exportButton");
        default:
            return nullptr; // in the view
        }
    };
    m_tour = new TourGuide(*m_bench, *m_checkList, *this, *m_view, Badges::kBelow, targetOf, this);
    connect(m_badges, &Badges::clicked, &m_tour->tour(), &Tour::verdictRead);
    connect(m_checks, &ChecksDock::chosenChanged, &m_tour->tour(), &Tour::verdictRead);
    if (auto *menu = m_toolBar->findChild<QMenu *>(QStringLiteral("toolStockMenu")))
        connect(menu, &QMenu::aboutToHide, &m_tour->tour(), &Tour::thicknessSeen);
    connect(m_scope, &WindowScope::changed, this, [this] {
        if (!m_actions->action("operation.linear")->isVisible())
            m_tour->tour().leaveOutRepeat();
    });
    connect(m_files, &DocumentFiles::exported, &m_tour->tour(), &Tour::exported);
}

/// In an empty window: this one, or one beside it.
void MainWindow::startTour()
{
    MainWindow &window = startNewDocument(*this);
    window.m_tour->tour().begin(window.m_actions->action("operation.linear")->isVisible());
}

} // namespace fff::ui
