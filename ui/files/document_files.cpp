#include "ui/files/document_files.h"

#include "core/io/document_file.h"
#include "core/io/error_text.h"
#include "core/session/cutting_file.h"
#include "ui/message_bar.h"
#include "ui/properties/open_editor.h"
#include "ui/status_line.h"
#include "ui/theme.h"
#include "ui/workbench.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>

namespace fff::ui {

namespace {

const QString kSuffix = QStringLiteral("fff");

} // namespace

DocumentFiles::DocumentFiles(Workbench &bench, MessageBar &messages, StatusLine &status,
                             QWidget &window)
    : QObject(&window), m_bench(bench), m_messages(messages), m_status(status), m_window(window)
{
    connect(&bench.session(), &Session::cleanChanged, this, &DocumentFiles::refreshTitle);
    refreshTitle();
}

bool DocumentFiles::startNew()
{
    if (!mayClose())
        return false;
    m_messages.hide();
    m_bench.session().reset(newDocument());
    m_bench.showAll("front");
    setPath({}, false);
    return true;
}

bool DocumentFiles::open()
{
    if (!mayClose())
        return false;
    const QString path = QFileDialog::getOpenFileName(&m_window, tr("Open a model"), folder(),
                                                      tr("Models (*.fff *.txt);;All files (*)"));
    return !path.isEmpty() && openFile(path);
}

bool DocumentFiles::save()
{
    return m_isNative ? saveFile(m_path) : saveAs();
}

bool DocumentFiles::saveAs()
{
    const QString path =
        askForTarget(tr("Save the model"), tr("FlatFitFab models (*.fff)"), kSuffix);
    return !path.isEmpty() && saveFile(path);
}

bool DocumentFiles::exportCuttingFile()
{
    const QString path = askForTarget(tr("Export cutting files"),
                                      tr("Drawings for cutters (*.svg)"), QStringLiteral("svg"));
    return !path.isEmpty() && exportFile(path);
}

bool DocumentFiles::mayClose()
{
    commitOpenEditor();
    if (m_bench.session().isClean())
        return true;
    QMessageBox question(QMessageBox::NoIcon, tr("Unsaved changes"),
                         tr("Save the changes to %1?").arg(baseName() + u'.' + kSuffix),
                         QMessageBox::NoButton, &m_window);
    question.setObjectName(QStringLiteral("unsavedQuestion"));
    question.setPalette(theme().palette());
    question.setInformativeText(tr("Without saving, they are lost."));
    QPushButton *keep = question.addButton(tr("Save"), QMessageBox::AcceptRole);
    QPushButton *lose = question.addButton(tr("Don’t save"), QMessageBox::DestructiveRole);
    QPushButton *back = question.addButton(tr("Cancel"), QMessageBox::RejectRole);
    question.setDefaultButton(keep);
    question.setEscapeButton(back);
    question.exec();
    if (question.clickedButton() == keep)
        return save();
    return question.clickedButton() == lose;
}

bool DocumentFiles::openFile(const QString &path, bool asCopy)
{
    const QString name = QFileInfo(path).fileName();
    io::ReadOptions options;
    options.name = name.toStdString();
    const Result<io::LoadedDocument> loaded = io::readDocument(path, options);
    if (!loaded) {
        m_messages.show(MessageBar::Severity::Error,
                        {tr("%1 could not be opened. Nothing was changed.").arg(name),
                         io::errorText(loaded.error())});
        return false;
    }
    QStringList warnings;
    for (const Warning &warning : loaded->warnings)
        warnings += io::warningText(warning);
    m_messages.show(MessageBar::Severity::Warning, warnings); // hides without any
    m_bench.session().reset(loaded->document);
    m_bench.showAll("iso1");
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    setPath(asCopy ? documents + u'/' + name : path,
            !asCopy && loaded->format == io::ModelFormat::Fff);
    return true;
}

bool DocumentFiles::saveFile(const QString &path)
{
    const Result<void> written = io::writeDocument(path, m_bench.session().committed().document);
    if (!written) {
        m_messages.show(MessageBar::Severity::Error,
                        {tr("%1 could not be saved. The file on disk is as it was before.")
                             .arg(QFileInfo(path).fileName()),
                         io::errorText(written.error())});
        return false;
    }
    m_messages.hide();
    m_bench.session().setClean();
    setPath(path, true);
    m_status.say(tr("Saved to %1.").arg(QFileInfo(path).fileName()));
    return true;
}

bool DocumentFiles::exportFile(const QString &path)
{
    const QString name = QFileInfo(path).fileName();
    if (m_bench.session().hasPreview())
        m_bench.escape(); // a section that is still being drawn is not cut
    const Result<CuttingFile> file = makeCuttingFile(m_bench.session().currentAnalysis());
    const Result<void> written =
        file ? io::writeFile(path, file->svg) : Result<void>(tl::unexpected(file.error()));
    if (!written) {
        m_messages.show(MessageBar::Severity::Error,
                        {tr("%1 could not be written.").arg(name), io::errorText(written.error())});
        return false;
    }

    QStringList warnings;
    for (const std::string &section : file->oversized) {
        warnings += tr("%1 is larger than the sheet. It lies on a sheet of its own size.")
                        .arg(QString::fromStdString(section));
    }
    for (const std::string &section : file->unmarked) {
        warnings += tr("%1 is too slim to carry its number.").arg(QString::fromStdString(section));
    }
    for (const std::string &section : file->closedSlits) {
        warnings += tr("The kerf is as wide as the slits of %1: they would be closed.")
                        .arg(QString::fromStdString(section));
    }
    m_messages.show(MessageBar::Severity::Warning, warnings);

    const QLocale locale = m_window.locale();
    const QString parts = tr("%n part(s)", nullptr, file->partCount);
    const QString sheets = tr("%n sheet(s)", nullptr, file->sheetCount);
    m_status.say(file->slitWidth && *file->slitWidth > 0.0
                     ? tr("Exported %1 on %2 to %3; slits are drawn %4\u202fmm wide.")
                           .arg(parts, sheets, name, locale.toString(*file->slitWidth, 'f', 2))
                     : tr("Exported %1 on %2 to %3.").arg(parts, sheets, name));
    return true;
}

QString DocumentFiles::folder() const
{
    return m_path.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)
                            : QFileInfo(m_path).absolutePath();
}

QString DocumentFiles::baseName() const
{
    return m_path.isEmpty() ? tr("untitled") : QFileInfo(m_path).completeBaseName();
}

/// The dialog asks before overwriting, also when it has put the suffix there itself.
QString DocumentFiles::askForTarget(const QString &title, const QString &filter,
                                    const QString &suffix)
{
    QFileDialog dialog(&m_window, title, folder(), filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(suffix);
    dialog.selectFile(baseName() + u'.' + suffix);
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

void DocumentFiles::setPath(const QString &path, bool isNative)
{
    m_path = path;
    m_isNative = isNative;
    refreshTitle();
}

void DocumentFiles::refreshTitle()
{
    const QString name = m_path.isEmpty() ? tr("untitled") : QFileInfo(m_path).fileName();
    m_window.setWindowTitle(QStringLiteral("%1[*] \u2014 FlatFitFab").arg(name));
    m_window.setWindowModified(!m_bench.session().isClean());
    m_window.setWindowFilePath(m_path);
}

} // namespace fff::ui
