#include "ui/files/document_files.h"

#include "core/interaction/section_editing.h"
#include "core/io/document_file.h"
#include "core/io/formats.h"
#include "core/io/warning_summary.h"
#include "core/session/journal.h"
#include "ui/base/file_dialog.h"
#include "ui/base/message_bar.h"
#include "ui/base/naming.h"
#include "ui/base/theme.h"
#include "ui/bench/status_line.h"
#include "ui/bench/workbench.h"
#include "ui/files/coupon_export.h"
#include "ui/files/exporting.h"
#include "ui/files/failures.h"
#include "ui/files/format_filters.h"
#include "ui/files/mesh_import.h"
#include "ui/files/new_model.h"
#include "ui/files/progress.h"
#include "ui/properties/open_editor.h"
#include "ui/settings/settings.h"

#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

namespace fff::ui {

namespace {

//: %1 is the name of a file
constexpr Text kInsertModel = FFF_TEXT("Step", "Insert %1");

QString nativeSuffix()
{
    return io::nativeFormat().suffix();
}

} // namespace

DocumentFiles::DocumentFiles(Workbench &bench, const CheckList &checks, MessageBar &messages,
                             StatusLine &status, QWidget &window)
    : QObject(&window), m_bench(bench), m_messages(messages), m_status(status), m_window(window),
      m_exporting(new Exporting(bench, checks, messages, status, window))
{
    connect(m_exporting, &Exporting::stocksWanted, this, &DocumentFiles::stocksWanted);
    connect(m_exporting, &Exporting::problemWanted, this, &DocumentFiles::problemWanted);
    connect(m_exporting, &Exporting::sectionsWanted, this, &DocumentFiles::sectionsWanted);
    connect(m_exporting, &Exporting::exported, this, &DocumentFiles::exported);
    connect(&bench.session(), &Session::cleanChanged, this, &DocumentFiles::refreshTitle);
    refreshTitle();
}

bool DocumentFiles::startNew()
{
    if (!mayClose())
        return false;
    m_messages.dismiss();
    begin();
    return true;
}

void DocumentFiles::begin()
{
    m_new = newModel();
    m_bench.session().reset(m_new);
    m_bench.showAll(m_new.sections.empty() ? "front" : "iso1");
    setPath({}, false, false);
}

bool DocumentFiles::open()
{
    FileDialog dialog(&m_window, tr("Open a model"), folder(), modelFilter());
    dialog.setFileMode(QFileDialog::ExistingFiles);
    if (dialog.exec() != QDialog::Accepted)
        return false;
    Q_EMIT chosen(dialog.selectedFiles());
    return true;
}

bool DocumentFiles::insert()
{
    FileDialog dialog(&m_window, tr("Insert a model"), folder(), modelFilter());
    dialog.setFileMode(QFileDialog::ExistingFile);
    return dialog.exec() == QDialog::Accepted && insertFile(dialog.selectedFiles().constFirst());
}

QString DocumentFiles::askForDrawing()
{
    FileDialog dialog(&m_window, tr("Import a drawing"), folder(), drawingFilter());
    dialog.setFileMode(QFileDialog::ExistingFile);
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().constFirst() : QString();
}

QString DocumentFiles::askForMesh()
{
    FileDialog dialog(&m_window, tr("Add a template"), folder(), meshFilter());
    dialog.setFileMode(QFileDialog::ExistingFile);
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().constFirst() : QString();
}

bool DocumentFiles::insertFile(const QString &path)
{
    const std::optional<io::LoadedDocument> loaded = read(path);
    if (!loaded)
        return false;
    const QString name = QFileInfo(path).fileName();
    if (loaded->document.sections.empty()) {
        m_status.say(tr("Nothing inserted: %1 has no sections.").arg(name));
        return false;
    }
    showWarnings(*loaded);
    const Model &model = m_bench.session().committed();
    m_bench.editSections(added(model, loaded->document, wayBeside(model, loaded->document),
                               {kInsertModel, {Named{name.toStdString()}}}));
    return true;
}

bool DocumentFiles::save()
{
    return m_isNative ? saveFile(m_path) : saveAs();
}

bool DocumentFiles::saveAs()
{
    const QString path = askForTarget(tr("Save the model"), saveFilter(), nativeSuffix());
    if (path.isEmpty())
        return false;
    return saveFile(path);
}

bool DocumentFiles::exportCuttingFile()
{
    return m_exporting->ask(suggestion(), path());
}

bool DocumentFiles::exportAgain()
{
    return m_exporting->again(path());
}

bool DocumentFiles::exportCoupon()
{
    const std::optional<CouponOutcome> outcome = CouponExport{m_bench, m_window}.ask(suggestion());
    if (!outcome)
        return false;
    if (outcome->isWritten) {
        m_messages.dismiss();
        m_status.say(outcome->sentence);
    } else {
        m_messages.show(MessageBar::Severity::Error, {outcome->sentence}, {}, outcome->details);
    }
    return outcome->isWritten;
}

bool DocumentFiles::canExportAgain() const
{
    return m_exporting->canAgain(path());
}

QString DocumentFiles::suggestion() const
{
    return folder() + u'/' + baseName();
}

bool DocumentFiles::mayClose()
{
    commitOpenEditor();
    if (m_bench.session().isClean())
        return true;
    QMessageBox question(QMessageBox::NoIcon, tr("Unsaved changes"),
                         tr("Save the changes to %1?").arg(baseName() + u'.' + nativeSuffix()),
                         QMessageBox::NoButton, &m_window);
    question.setObjectName(QStringLiteral("unsavedQuestion"));
    question.setInformativeText(tr("Without saving, they are lost."));
    QPushButton *keep = question.addButton(tr("Save"), QMessageBox::AcceptRole);
    QPushButton *lose = question.addButton(tr("Don’t save"), QMessageBox::DestructiveRole);
    QPushButton *back = question.addButton(tr("Cancel"), QMessageBox::RejectRole);
    question.setDefaultButton(keep);
    question.setEscapeButton(back);
    dress(&question);
    question.exec();
    if (question.clickedButton() == keep)
        return save();
    return question.clickedButton() == lose;
}

bool DocumentFiles::canRevert() const
{
    return m_isOnDisk && !m_bench.session().isClean();
}

bool DocumentFiles::revert()
{
    if (!canRevert())
        return false;
    const std::optional<io::LoadedDocument> loaded = read(m_path);
    if (!loaded)
        return false;
    m_messages.dismiss();
    if (m_bench.interaction().hasGesture())
        m_bench.escape(); // a section that is still being drawn; else Esc would drop the selection
    m_bench.session().commit(tr("Revert to saved"), loaded->document);
    m_bench.session().setClean();
    m_stamp = FileStamp::of(m_path);
    m_status.say(tr("%1 is as it was saved. Undo brings your changes back.").arg(name()));
    return true;
}

bool DocumentFiles::openFile(const QString &path, bool asCopy)
{
    const std::optional<io::LoadedDocument> loaded = read(path);
    if (loaded)
        show(*loaded, path, asCopy);
    return loaded.has_value();
}

std::optional<io::LoadedDocument> DocumentFiles::read(const QString &path)
{
    const QString name = QFileInfo(path).fileName();
    io::ReadOptions options;
    options.name = name.toStdString();
    options.naming = naming();
    const auto loaded = inBackground<Result<io::LoadedDocument>>(
        m_window, tr("Opening %1…").arg(name), MayCancel::Yes,
        [path, options] { return io::readDocument(path, options); });
    if (!loaded)
        return std::nullopt;
    if (!*loaded) {
        const Error &error = loaded->error();
        std::vector<MessageBar::Verb> verbs = {{tr("Choose another file"), [this] { open(); }}};
        if (!QFileInfo::exists(path) && settings().recentFiles().contains(path)) {
            verbs.push_back(
                {tr("Remove from the list"), [path] { settings().removeRecentFile(path); }});
        }
        m_messages.show(MessageBar::Severity::Error, {openFailure(path, error)}, std::move(verbs),
                        failureDetails(path, error));
        return std::nullopt;
    }
    return std::move(**loaded);
}

void DocumentFiles::showWarnings(const io::LoadedDocument &loaded)
{
    m_messages.show(MessageBar::Severity::Warning, io::warningSummary(loaded.warnings), {},
                    io::warningLines(loaded.warnings).join(u'\n')); // hides without any
}

void DocumentFiles::show(const io::LoadedDocument &loaded, const QString &path, bool asCopy)
{
    showWarnings(loaded);
    m_bench.session().reset(loaded.document);
    m_bench.showAll("iso1");
    if (asCopy) {
        setPath(documentsFolder() + u'/' + QFileInfo(path).fileName(), false, false);
        return;
    }
    setPath(path, loaded.format == &io::nativeFormat(), true);
    settings().addRecentFile(path);
}

bool DocumentFiles::saveFile(const QString &path)
{
    bool asksForName = false;
    if (path == m_path && !maySaveOver(path, &asksForName))
        return asksForName && saveAs();
    const QString file = QFileInfo(path).fileName();
    const Document document = m_bench.session().committed().document;
    io::WriteOptions options;
    options.keepsBackup = settings().keepsBackup();
    qCDebug(journal, "saving %s", digestOf(document).constData());
    const auto written = inBackground<Result<void>>(
        m_window, tr("Saving %1…").arg(file), MayCancel::No,
        [path, document, options] { return io::writeDocument(path, document, options); });
    if (!*written) {
        m_messages.show(MessageBar::Severity::Error, {saveFailure(path, written->error())},
                        {{tr("Save somewhere else…"), [this] { saveAs(); }}},
                        failureDetails(path, written->error()));
        return false;
    }
    qCDebug(journal, "saved %s", digestOf(document).constData());
    m_messages.dismiss();
    m_bench.session().setSaved(document); // not what it may have become meanwhile
    setPath(path, true, true);
    settings().addRecentFile(path);
    m_status.say(tr("Saved to %1.").arg(file));
    return true;
}

/// Another program may have written to the file since it was read.
bool DocumentFiles::maySaveOver(const QString &path, bool *asksForName)
{
    if (m_stamp.isCurrent())
        return true;
    QMessageBox question(QMessageBox::NoIcon, tr("Changed on disk"),
                         tr("%1 was changed by another program.").arg(QFileInfo(path).fileName()),
                         QMessageBox::NoButton, &m_window);
    question.setObjectName(QStringLiteral("changedOnDiskQuestion"));
    question.setInformativeText(tr("Overwriting it would lose those changes."));
    QPushButton *another = question.addButton(tr("Save as…"), QMessageBox::AcceptRole);
    QPushButton *over = question.addButton(tr("Overwrite"), QMessageBox::DestructiveRole);
    QPushButton *back = question.addButton(tr("Cancel"), QMessageBox::RejectRole);
    question.setDefaultButton(another);
    question.setEscapeButton(back);
    dress(&question);
    question.exec();
    *asksForName = question.clickedButton() == another;
    return question.clickedButton() == over;
}

bool DocumentFiles::exportFile(const QString &path)
{
    return m_exporting->write(path);
}

bool DocumentFiles::exportSheets(const QString &path)
{
    return m_exporting->writeSheets(path);
}

QString DocumentFiles::folder() const
{
    return m_path.isEmpty() ? documentsFolder() : QFileInfo(m_path).absolutePath();
}

QString DocumentFiles::baseName() const
{
    return m_path.isEmpty() ? tr("untitled") : QFileInfo(m_path).completeBaseName();
}

QString DocumentFiles::askForTarget(const QString &title, const QString &filter,
                                    const QString &suffix)
{
    FileDialog dialog(&m_window, title, folder(), filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(suffix);
    dialog.selectFile(baseName() + u'.' + suffix);
    return dialog.target();
}

void DocumentFiles::showRecovered(const QString &path, const QString &name, const QDateTime &kept)
{
    m_messages.dismiss();
    const QFileInfo info(path);
    // A copy or an import has a name without being that file.
    const bool isOnDisk = !path.isEmpty() && info.exists();
    const bool hasName = !path.isEmpty() || QFileInfo(name).suffix() == nativeSuffix();
    setPath(isOnDisk  ? path
            : hasName ? documentsFolder() + u'/' + name
                      : QString(),
            isOnDisk && info.suffix() == nativeSuffix(), isOnDisk);
    if (isOnDisk && info.lastModified() > kept)
        m_stamp = FileStamp::outdated(path);
    m_bench.showAll("iso1");
}

bool DocumentFiles::isSaved() const
{
    return m_bench.session().isClean();
}

QString DocumentFiles::name() const
{
    return m_path.isEmpty() ? tr("untitled") : QFileInfo(m_path).fileName();
}

bool DocumentFiles::isUntouched() const
{
    const Session &session = m_bench.session();
    return m_path.isEmpty() && session.history()->count() == 0 &&
           session.committed().document == m_new;
}

bool DocumentFiles::isEmpty() const
{
    return m_path.isEmpty() && m_bench.session().model().sectionCount() == 0;
}

void DocumentFiles::setPath(const QString &path, bool isNative, bool isOnDisk)
{
    m_path = path;
    m_isNative = isNative;
    m_isOnDisk = isOnDisk;
    m_stamp = isOnDisk ? FileStamp::of(path) : FileStamp();
    refreshTitle();
    Q_EMIT pathChanged();
}

void DocumentFiles::refreshTitle()
{
    m_window.setWindowTitle(QStringLiteral("%1[*] \u2014 FlatFitFab").arg(name()));
    m_window.setWindowModified(!m_bench.session().isClean());
    m_window.setWindowFilePath(path());
}

} // namespace fff::ui
