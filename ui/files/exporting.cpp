#include "ui/files/exporting.h"

#include "core/analysis/analysed.h"
#include "core/io/cutting_file.h"
#include "core/io/document_file.h"
#include "core/io/error_text.h"
#include "core/io/file_set.h"
#include "core/io/obj_writer.h"
#include "core/session/scheduler.h"
#include "ui/base/file_dialog.h"
#include "ui/base/lengths.h"
#include "ui/base/message_bar.h"
#include "ui/bench/status_line.h"
#include "ui/bench/workbench.h"
#include "ui/files/failures.h"
#include "ui/files/progress.h"
#include "ui/files/replace_question.h"

#include <QFileInfo>

namespace fff::ui {

namespace {

const QString kDrawing = QStringLiteral("svg"), kSolids = QStringLiteral("obj");

} // namespace

Exporting::Exporting(Workbench &bench, MessageBar &messages, StatusLine &status, QWidget &window)
    : QObject(&window), m_bench(bench), m_messages(messages), m_status(status), m_window(window)
{
}

bool Exporting::ask(const QString &suggestion)
{
    const QString drawings = tr("Drawings for cutters (*.svg)"),
                  sheets = tr("Drawings for cutters, one for each sheet (*.svg)"),
                  solids = tr("Solids for other programs (*.obj)");
    FileDialog dialog(&m_window, tr("Export cutting files"), QFileInfo(suggestion).absolutePath(),
                      QStringList{drawings, sheets, solids}.join(QStringLiteral(";;")));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(kDrawing);
    dialog.selectFile(QFileInfo(suggestion).fileName() + u'.' + kDrawing);
    connect(&dialog, &QFileDialog::filterSelected, &dialog, [&](const QString &filter) {
        const QString suffix = filter == solids ? kSolids : kDrawing;
        dialog.setDefaultSuffix(suffix);
        // The name is then none of a file.
        dialog.setOption(QFileDialog::DontConfirmOverwrite, filter == sheets);
        const QFileInfo chosen(dialog.selectedFiles().value(0));
        if (!chosen.isDir())
            dialog.selectFile(chosen.completeBaseName() + u'.' + suffix);
    });
    // The dialog asks before overwriting, also when it has put the suffix there itself.
    if (dialog.exec() != QDialog::Accepted)
        return false;
    const QString path = dialog.selectedFiles().value(0);
    return dialog.selectedNameFilter() == sheets ? writeSheets(path) : write(path);
}

bool Exporting::write(const QString &path)
{
    if (!prepare(path))
        return false;
    const bool isSolids = QFileInfo(path).suffix().compare(kSolids, Qt::CaseInsensitive) == 0;
    return isSolids ? writeSolids(path) : writeDrawing(path, false);
}

bool Exporting::writeSheets(const QString &path)
{
    return prepare(path) && writeDrawing(path, true);
}

bool Exporting::prepare(const QString &path)
{
    if (m_bench.session().hasPreview())
        m_bench.escape(); // a section that is still being drawn is not cut
    return finishAnalysis(path);
}

/// The slits of the model that is shown are cut on another thread already.
bool Exporting::finishAnalysis(const QString &path)
{
    const Scheduler &scheduler = m_bench.session().scheduler();
    const QString name = QFileInfo(path).fileName();
    if (!waitWithProgress(m_window, tr("Exporting %1…").arg(name), MayCancel::Yes,
                          [&scheduler] { return scheduler.isSettled(kAnalysed.name); }))
        return false;
    const std::optional<Error> why = scheduler.whyNot(kAnalysed.name);
    return !why || tellFailure(path, *why);
}

bool Exporting::writeDrawing(const QString &path, bool isFilePerSheet)
{
    const QString name = QFileInfo(path).fileName();
    io::CuttingFileOptions options;
    options.isFilePerSheet = isFilePerSheet;
    const QString doing = tr("Exporting %1…").arg(name);
    const auto made = inBackground<Result<io::CuttingFile>>(
        m_window, doing, MayCancel::No, [analysis = m_bench.session().analysisPointer(), options] {
            return io::makeCuttingFile(*analysis, options);
        });
    if (!*made)
        return tellFailure(path, made->error());
    const io::CuttingFile &file = **made;
    std::vector<io::NamedBytes> files{{path, file.svg}};
    if (isFilePerSheet) {
        files = io::numberedFiles(path, file.sheets);
        if (!mayReplace(m_window, files))
            return false;
    }
    const auto written = inBackground<Result<void>>(m_window, doing, MayCancel::No, [files] {
        return files.size() == 1 ? io::writeFile(files[0].path, files[0].bytes)
                                 : io::writeFiles(files);
    });
    if (!*written)
        return tellFailure(path, written->error());
    m_messages.show(MessageBar::Severity::Warning, warningsOf(file)); // hides without any
    const auto nameOf = [](const io::NamedBytes &one) { return QFileInfo(one.path).fileName(); };
    tellDone(file, files.size() == 1
                       ? nameOf(files.front())
                       //: %1 and %2 are the first and the last of several files
                       : tr("%1 to %2").arg(nameOf(files.front()), nameOf(files.back())));
    return true;
}

void Exporting::tellDone(const io::CuttingFile &file, const QString &name)
{
    const QString parts = tr("%n part(s)", nullptr, file.partCount);
    const QString sheets = tr("%n sheet(s)", nullptr, file.sheetCount());
    m_status.say(file.slitWidth ? tr("Exported %1 on %2 to %3; slits are drawn %4 wide.")
                                      .arg(parts, sheets, name,
                                           lengthText(*file.slitWidth, 2, 2, m_window.locale()))
                                : tr("Exported %1 on %2 to %3.").arg(parts, sheets, name));
}

bool Exporting::writeSolids(const QString &path)
{
    const QString name = QFileInfo(path).fileName();
    const AnalysisPointer analysis = m_bench.session().analysisPointer();
    if (analysis->model.sectionCount() == 0)
        return tellFailure(path, Error{ErrorCode::NothingToExport, {}, {}});
    const auto written = inBackground<Result<void>>(
        m_window, tr("Exporting %1…").arg(name), MayCancel::No, [analysis, path] {
            return io::writeObj(analysis->model, analysis->bodies)
                .and_then([&path](const std::string &obj) { return io::writeFile(path, obj); });
        });
    if (!*written)
        return tellFailure(path, written->error());
    m_messages.hide();
    m_status.say(
        tr("Exported %1 as solids to %2.")
            .arg(tr("%n section(s)", nullptr, static_cast<int>(analysis->model.sectionCount())),
                 name));
    return true;
}

bool Exporting::tellFailure(const QString &path, const Error &error)
{
    const QString base = QFileInfo(path).absolutePath() + u'/' + QFileInfo(path).completeBaseName();
    const bool isOfStock =
        error.code == ErrorCode::ClosedSlit || error.code == ErrorCode::CannotOffset;
    const MessageBar::Verb mend =
        isOfStock ? MessageBar::Verb{tr("Stocks…"), [this] { Q_EMIT stocksWanted(); }}
                  : MessageBar::Verb{tr("Export somewhere else…"), [this, base] { ask(base); }};
    const QString failure = saveFailure(path, error);
    m_messages.show(MessageBar::Severity::Error, {failure}, {mend}, failureDetails(path, error));
    // What is changed then may have mended it.
    if (isOfStock)
        connect(
            &m_bench.session(), &Session::committedChanged, this,
            [this] {
                if (m_messages.text() == m_refusal)
                    m_messages.hide();
            },
            Qt::SingleShotConnection);
    m_refusal = failure;
    return false;
}

QStringList Exporting::warningsOf(const io::CuttingFile &file)
{
    QStringList warnings;
    for (const std::string &section : file.oversized) {
        warnings += tr("%1 is larger than the sheet. It lies on a sheet of its own size.")
                        .arg(QString::fromStdString(section));
    }
    for (const std::string &section : file.unmarked)
        warnings += tr("%1 is too slim to carry its number.").arg(QString::fromStdString(section));
    for (const std::string &section : file.uncut)
        warnings += tr("%1 has a hole or a notch that is narrower than the kerf and is not cut.")
                        .arg(QString::fromStdString(section));
    for (const std::string &section : file.unmarkedJoints)
        warnings += tr("%1 has no room for the numbers of all its joints.")
                        .arg(QString::fromStdString(section));
    return warnings;
}

} // namespace fff::ui
