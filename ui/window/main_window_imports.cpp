// What comes into the model that is shown from files of other programs.
#include "ui/base/message_bar.h"
#include "ui/bench/status_line.h"
#include "ui/bench/workbench.h"
#include "ui/docks/templates_dock.h"
#include "ui/files/clipboard_picture.h"
#include "ui/files/document_files.h"
#include "ui/files/given_files.h"
#include "ui/files/mesh_import.h"
#include "ui/files/template_maker.h"
#include "ui/window/main_window.h"
#include "ui/window/window_layout.h"
#include "ui/window/windows.h"

#include <QClipboard>
#include <QGuiApplication>

#include <algorithm>
#include <optional>

namespace fff::ui {

void MainWindow::take(const QStringList &paths, bool asCopy)
{
    const GivenFiles given = givenFiles(paths);
    ui::openFiles(*this, given.models, asCopy);
    if (isOnlyAdjusted())
        return;
    for (const QString &path : given.drawings)
        readDrawing(QStringLiteral("section.importSections"), path);
    for (const QString &path : given.meshes)
        readMesh(path);
}

/// Asks which one.
void MainWindow::importDrawing(const QString &command)
{
    if (const QString path = m_files->askForDrawing(); !path.isEmpty())
        readDrawing(command, path);
}

void MainWindow::readDrawing(const QString &command, const QString &path)
{
    showDocument();
    m_messages->dismiss(); // of the drawing before
    m_bench->run(command, {{"path", path.toStdString()}});
}

/// Asks which one.
void MainWindow::addMesh()
{
    if (const QString path = m_files->askForMesh(); !path.isEmpty())
        readMesh(path);
}

void MainWindow::connectTemplates()
{
    connect(m_templates, &TemplatesDock::addWanted, this,
            [this] { run(QStringLiteral("template.addMesh")); });
    auto *maker = new TemplateMaker(*this, *m_bench);
    connect(m_templates, &TemplatesDock::suggestionWanted, maker,
            qOverload<TemplateId, int>(&TemplateMaker::suggest));
    connect(m_templates, &TemplatesDock::slicesWanted, maker, &TemplateMaker::slice);
    connect(m_templates, &TemplatesDock::oneMoreWanted, maker, &TemplateMaker::suggestOneMore);
    connect(m_templates, &TemplatesDock::anotherWanted, maker, &TemplateMaker::suggestAnother);
    connect(m_templates, &TemplatesDock::facetsWanted, maker, &TemplateMaker::makeFacets);
    connect(m_templates, &TemplatesDock::netWanted, maker, &TemplateMaker::makeNet);
    connect(m_templates, &TemplatesDock::traceWanted, maker, &TemplateMaker::trace);
    connect(m_templates, &TemplatesDock::fileWanted, this, [this](TemplateId id, bool isLinked) {
        if (const QString path = m_files->askForMesh(); !path.isEmpty())
            refill(id, path, isLinked);
    });
    connect(m_templates, &TemplatesDock::keepWanted, this, [this](TemplateId id) {
        if (const Template *one = m_bench->session().committed().document.find(id))
            refill(id, QString::fromStdString(one->file), false);
    });
    // Once it is here: where a file that is not found can be found again is shown at once, and what
    // is drawn over can be hidden and moved.
    connect(
        &m_bench->session(), &Session::replaced, this,
        [this] {
            const auto &all = m_bench->session().committed().document.templates;
            if (isOnlyAdjusted() || all.empty())
                return;
            if (std::any_of(all.begin(), all.end(), [](const auto &one) { return !one->isRead(); }))
                m_layout->show(m_templates);
            else
                m_layout->offer(m_templates);
        },
        Qt::QueuedConnection);
    connect(m_templates, &TemplatesDock::viewWanted, m_view, qOverload<>(&QWidget::setFocus));
    connect(&m_bench->session(), &Session::committedChanged, m_templates,
            [this, maker] { m_templates->setHasSuggestion(maker->hasSuggestion()); });
    connect(maker, &TemplateMaker::said, m_status, &StatusLine::say);
    const auto failed = std::make_shared<QString>();
    connect(maker, &TemplateMaker::failed, m_messages, [this, failed](const QString &text) {
        m_messages->show(MessageBar::Severity::Error, {text});
        *failed = m_messages->text();
    });
    // What failed is no news any more once something has come of it.
    connect(&m_bench->session(), &Session::committedChanged, m_messages, [this, failed] {
        if (!failed->isEmpty() && m_messages->text() == *failed)
            m_messages->dismiss();
        failed->clear();
    });
}

void MainWindow::readMesh(const QString &path)
{
    showDocument();
    m_messages->dismiss(); // of the file before
    tellImported(importMesh(*this, *m_bench, path));
}

void MainWindow::refill(TemplateId id, const QString &path, bool isLinked)
{
    m_messages->dismiss();
    const MeshImported read = refillTemplate(*this, *m_bench, id, path, isLinked);
    if (!read.error.isEmpty())
        m_messages->show(MessageBar::Severity::Error, {read.error});
    else if (!read.remarks.isEmpty())
        m_messages->show(MessageBar::Severity::Warning, {read.remarks});
}

/// False: there is none in the clipboard.
bool MainWindow::pastePicture()
{
    const std::optional<ClipboardPicture> picture =
        pictureIn(QGuiApplication::clipboard()->mimeData());
    if (!picture)
        return false;
    showDocument();
    m_messages->dismiss();
    tellImported(importPicture(*this, *m_bench, *picture));
    return true;
}

void MainWindow::tellImported(const MeshImported &imported)
{
    if (!imported.error.isEmpty())
        m_messages->show(MessageBar::Severity::Error, {imported.error});
    if (!imported.isAdded)
        return;
    if (!imported.remarks.isEmpty())
        m_messages->show(MessageBar::Severity::Warning, {imported.remarks});
    if (imported.takeScale && imported.remarks.isEmpty())
        m_messages->show(MessageBar::Severity::Info, {imported.sized},
                         {{imported.likeOther, imported.takeScale}});
    else if (!imported.sized.isEmpty())
        m_status->say(imported.sized);
    m_layout->show(m_templates);
    m_bench->run(QStringLiteral("view.fitAll"));
}

} // namespace fff::ui
