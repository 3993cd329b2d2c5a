// How much of the window is there.
#include "ui/actions/action_set.h"
#include "ui/bench/status_line.h"
#include "ui/bench/workbench.h"
#include "ui/docks/values_dock.h"
#include "ui/window/adjust_bar.h"
#include "ui/window/main_tool_bar.h"
#include "ui/window/main_window.h"
#include "ui/window/window_layout.h"
#include "ui/window/window_scope.h"

#include <QMenuBar>

namespace fff::ui {

void MainWindow::makeScope()
{
    m_adjustBar = new AdjustBar(*m_actions, this);
    addToolBar(m_adjustBar);
    m_adjustBar->hide();
    m_scope = new WindowScope(*m_bench, *m_actions, *m_layout,
                              {.simple = m_checks, .values = m_values, .adjustBar = m_adjustBar},
                              *menuBar(), this);
    connect(m_scope, &WindowScope::changed, this, [this] {
        m_toolBar->fold(width());                    // it was not asked meanwhile
        m_bench->run(QStringLiteral("view.fitAll")); // there is another room for it
    });
}

/// Then it says so: what was wanted would edit the design.
bool MainWindow::isOnlyAdjusted()
{
    if (m_scope->isAdjusting())
        m_status->say(tr("This model is here to be adjusted. “Edit the design” brings all back."));
    return m_scope->isAdjusting();
}

} // namespace fff::ui
