#include "ui/files/exporting.h"

#include "core/analysis/analysed.h"
#include "core/io/cutting_file.h"
#include "core/io/document_file.h"
#include "core/io/error_text.h"
#include "core/io/file_set.h"
#include "core/io/formats.h"
#include "core/session/scheduler.h"
#include "ui/base/file_dialog.h"
#include "ui/base/lengths.h"
#include "ui/base/message_bar.h"
#include "ui/bench/status_line.h"
#include "ui/bench/workbench.h"
#include "ui/files/failures.h"
#include "ui/files/format_filters.h"
#include "ui/files/progress.h"
#include "ui/files/replace_question.h"

#include <QFileInfo>

namespace fff::ui {

namespace {

/// By the file's suffix; a cutting file in the first format that there is where it says nothing.
const io::Format &formatFor(const QString &path)
{
    const io::Format *named = io::formatWritten(QFileInfo(path).suffix(), &io::Format::isExported);
    return named ? *named : *exportKinds().front().format;
}

} // namespace

Exporting::Exporting(Workbench &bench, MessageBar &messages, StatusLine &status, QWidget &window)
    : QObject(&window), m_bench(bench), m_messages(messages), m_status(status), m_window(window)
{
}

bool Exporting::ask(const QString &suggestion)
{
    const std::vector<ExportKind> kinds = exportKinds();
    QStringList filters;
    for (const ExportKind &kind : kinds)
        filters += kind.filter;
    const auto kindOf = [&kinds](const QString &filter) {
        const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const ExportKind &kind) {
            return kind.filter == filter;
        });
        return found == kinds.end() ? kinds.front() : *found;
    };
    FileDialog dialog(&m_window, tr("Export cutting files"), QFileInfo(suggestion).absolutePath(),
                      filters.join(QStringLiteral(";;")));
    const QString usual = kinds.front().format->suffix();
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(usual);
    dialog.selectFile(QFileInfo(suggestion).fileName() + u'.' + usual);
    connect(&dialog, &QFileDialog::filterSelected, &dialog, [&](const QString &filter) {
        const ExportKind kind = kindOf(filter);
        const QString suffix = kind.format->suffix();
        dialog.setDefaultSuffix(suffix);
        // The name is then none of a file.
        dialog.setOption(QFileDialog::DontConfirmOverwrite, kind.isFilePerSheet);
        const QFileInfo chosen(dialog.selectedFiles().value(0));
        if (!chosen.isDir())
            dialog.selectFile(chosen.completeBaseName() + u'.' + suffix);
    });
    const QString path = dialog.target();
    if (path.isEmpty())
        return false;
    return kindOf(dialog.selectedNameFilter()).isFilePerSheet ? writeSheets(path) : write(path);
}

bool Exporting::write(const QString &path)
{
    if (!prepare(path))
        return false;
    return formatFor(path).writesSolids() ? writeSolids(path) : writeDrawing(path, false);
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
    if (const io::Format &format = formatFor(path); format.writesCutting())
        options.format = &format;
    const QString doing = tr("Exporting %1…").arg(name);
    const auto made = inBackground<Result<io::CuttingFile>>(
        m_window, doing, MayCancel::No, [analysis = m_bench.session().analysisPointer(), options] {
            return io::makeCuttingFile(*analysis, options);
        });
    if (!*made)
        return tellFailure(path, made->error());
    const io::CuttingFile &file = **made;
    std::vector<io::NamedBytes> files{{path, file.whole}};
    if (isFilePerSheet) {
        files = io::numberedFiles(path, file.sheets, options.format->suffix());
        if (!mayReplace(m_window, files))
            return false;
    }
    const auto written = inBackground<Result<void>>(m_window, doing, MayCancel::No, [files] {
        return files.size() == 1 ? io::writeFile(files[0].path, files[0].bytes)
                                 : io::writeFiles(files);
    });
    if (!*written)
        return tellFailure(path, written->error());
    QStringList warnings = warningsOf(file);
    if (isFilePerSheet)
        warnings += olderSheets(path, files.size(), options.format->suffix());
    m_messages.show(MessageBar::Severity::Warning, warnings); // hides without any
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
                                           lengthText(*file.slitWidth, 2, 3, m_window.locale()))
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
            return formatFor(path)
                .writeSolids(analysis->model, analysis->bodies, {})
                .and_then(
                    [&path](const std::string &solids) { return io::writeFile(path, solids); });
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

QStringList Exporting::olderSheets(const QString &path, std::size_t count, const QString &suffix)
{
    QStringList names;
    for (const QString &file : io::olderFiles(path, count, suffix))
        names += QFileInfo(file).fileName();
    return names.isEmpty()
               ? QStringList()
               : QStringList{
                     tr("Older sheets are still there: %1.").arg(names.join(QStringLiteral(", ")))};
}

QStringList Exporting::warningsOf(const io::CuttingFile &file)
{
    QStringList warnings;
    for (const std::string &section : file.withoutPart)
        warnings += tr("The slits of %1 leave nothing of it. It is not cut.")
                        .arg(QString::fromStdString(section));
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
