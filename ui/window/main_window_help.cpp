// The help in this window: what opens it, and where in it.
#include "core/interaction/tool.h"
#include "ui/bench/workbench.h"
#include "ui/help/help_key.h"
#include "ui/help/help_window.h"
#include "ui/window/main_window.h"
#include "ui/window/windows.h"

#include <QMenu>
#include <QMenuBar>

namespace fff::ui {

/// over  a dialog that nothing else is let by; null: none is
void MainWindow::showHelp(const HelpTopic &topic, QWidget *over)
{
    const auto actions = [this] { return listedActions(*menuBar()); };
    if (over) {
        auto *help = new HelpWindow(actions, over);
        // Another window: the dialog stays about what is shown in this one.
        connect(help, &HelpWindow::lessonChosen, this,
                [this](const QString &path) { ui::openFiles(*openWindow(this), {path}, true); });
        help->setAttribute(Qt::WA_DeleteOnClose);
        help->setWindowModality(Qt::WindowModal);
        help->open(topic);
        return;
    }
    if (!m_help) {
        m_help = new HelpWindow(actions, this);
        connect(m_help, &HelpWindow::lessonChosen, this,
                [this](const QString &path) { ui::openFiles(*this, {path}, true); });
    }
    m_help->open(topic);
}

/// About the tool in the hand, else about what is under the cursor.
void MainWindow::showHelpHere()
{
    QWidget *widget = pointedAt(*this);
    const Tool *tool = m_bench->interaction().tool();
    showHelp(tool && (!widget || widget == m_view) ? topicOf(tool->command()) : topicAt(widget));
}

/// Its pages and their headings, to be found by their words.
void MainWindow::addHelpPages(QMenu *menu)
{
    for (const QString &page : helpPages()) {
        QMenu *of = menu->addMenu(helpTitle(page));
        const auto add = [this, of](const QString &text, const HelpTopic &topic) {
            //: in the search: %1 is a heading of the help
            connect(of->addAction(tr("Help: %1").arg(text)), &QAction::triggered, this,
                    [this, topic] { showHelp(topic); });
        };
        add(helpTitle(page), {page});
        int number = 0;
        for (const QString &heading : helpHeadings(page))
            add(heading, {page, number++});
    }
}

} // namespace fff::ui
