// Where one begins in this window: the start page in the place of the view, and what a crash left.
#include "ui/base/message_bar.h"
#include "ui/bench/status_line.h"
#include "ui/files/document_files.h"
#include "ui/files/unsaved_work.h"
#include "ui/start/start_page.h"
#include "ui/window/main_window.h"
#include "ui/window/window_layout.h"
#include "ui/window/windows.h"

#include <QStackedWidget>

namespace fff::ui {

void MainWindow::showStartPage()
{
    if (!m_files->isUntouched()) {
        openWindow(this)->showStartPage();
        return;
    }
    if (m_middle->count() == 1) {
        auto *page = new StartPage(m_middle);
        connect(page, &StartPage::newWanted, this, [this] { startNewDocument(*this); });
        connect(page, &StartPage::tourWanted, this, &MainWindow::startTour);
        connect(page, &StartPage::openWanted, this, [this] { m_files->open(); });
        connect(page, &StartPage::fileChosen, this,
                [this](const QString &path) { openFiles({path}); });
        connect(page, &StartPage::sampleChosen, this,
                [this](const QString &path) { ui::openFiles(*this, {path}, true); });
        connect(page, &StartPage::recoverWanted, this, &MainWindow::recover);
        connect(page, &StartPage::discardWanted, page, [page](const QString &id) {
            UnsavedWork::forget(id);
            page->setRecovered(UnsavedWork::recoverable());
        });
        connect(page, &StartPage::folderWanted, page, &UnsavedWork::showInFolder);
        connect(page, &StartPage::noteTaken, page, [page](const QString &path) {
            UnsavedWork::takeNote(path);
            page->setUnreadable(UnsavedWork::unreadable());
        });
        m_middle->addWidget(page);
    }
    m_middle->setCurrentIndex(1);
    m_layout->setAway(true);
    m_status->setStanding(tr("Start a new model, continue one, or look at a sample."));
    m_middle->currentWidget()->setFocus();
    auto *page = static_cast<StartPage *>(m_middle->currentWidget());
    page->setUnreadable(UnsavedWork::unreadable());
    page->setRecovered(UnsavedWork::recoverable());
}

void MainWindow::offerRecovered()
{
    if (m_middle->currentIndex() != 1)
        tellUnreadable();
    const std::vector<RecoveredWork> works = UnsavedWork::recoverable();
    if (works.empty() || m_middle->currentIndex() == 1)
        return;
    if (works.size() > 1) {
        m_messages->showNext(MessageBar::Severity::Info,
                             {tr("Recovered: %n model(s) that were not saved", nullptr,
                                 static_cast<int>(works.size()))},
                             {{tr("Show them"), [this] { showStartPage(); }}});
        return;
    }
    const QString id = works.front().id;
    //: %1 is a model's name, how much was done, and when
    m_messages->showNext(MessageBar::Severity::Info, {tr("Recovered: %1").arg(works.front().text)},
                         {{tr("Open it"), [this, id] { recover(id); }},
                          {tr("Discard"), [id] { UnsavedWork::forget(id); }}});
}

void MainWindow::tellUnreadable()
{
    QStringList lines;
    QString last;
    for (const UnreadableCopy &copy : UnsavedWork::unreadable()) {
        lines += copy.text;
        last = copy.path;
        UnsavedWork::takeNote(copy.path);
    }
    if (!lines.isEmpty())
        m_messages->showNext(
            MessageBar::Severity::Warning, lines,
            {{tr("Show the folder"), [last] { UnsavedWork::showInFolder(last); }}});
}

void MainWindow::recover(const QString &id)
{
    MainWindow *window = m_files->isUntouched() ? this : openWindow(this);
    if (window->m_unsaved->adopt(id))
        window->showDocument();
    else if (window == this && m_middle->currentIndex() == 1)
        showStartPage(); // its rows as they are now
}

} // namespace fff::ui
