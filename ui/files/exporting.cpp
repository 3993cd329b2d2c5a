#include "ui/files/exporting.h"

#include "core/analysis/analysed.h"
#include "core/io/cutting_file.h"
#include "core/io/document_file.h"
#include "core/io/error_text.h"
#include "core/io/file_set.h"
#include "core/io/formats.h"
#include "core/io/listing.h"
#include "core/session/scheduler.h"
#include "core/session/sheet_nesting.h"
#include "core/skin/skin.h"
#include "ui/base/lengths.h"
#include "ui/base/message_bar.h"
#include "ui/bench/cutting_words.h"
#include "ui/bench/status_line.h"
#include "ui/bench/workbench.h"
#include "ui/dialogs/export_dialog.h"
#include "ui/files/chosen_place.h"
#include "ui/files/coupon_export.h"
#include "ui/files/failures.h"
#include "ui/files/progress.h"
#include "ui/files/replace_question.h"
#include "ui/files/workshop.h"

#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QUrl>

#include <algorithm>
#include <stop_token>

namespace fff::ui {

namespace {

/// By the file's suffix; a cutting file in the first format that there is where it says nothing.
ExportKind kindOf(const QString &path, bool isFilePerSheet)
{
    const std::vector<ExportKind> kinds = exportKinds();
    const io::Format *named = io::formatWritten(QFileInfo(path).suffix(), &io::Format::isExported);
    const io::Format *format = named ? named : kinds.front().format;
    const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const ExportKind &kind) {
        return kind.format == format && kind.isFilePerSheet == isFilePerSheet;
    });
    return found == kinds.end() ? kinds.front() : *found;
}

std::vector<ExportFile> filesToChoose()
{
    std::vector<ExportFile> files;
    for (const ExportKind &kind : exportKinds())
        files.push_back({kind.key, kind.title, kind.use, !kind.format->writesCutting(),
                         kind.isFilePerSheet, kind.isSkin, kind.isFolder,
                         kind.format->showsJointColours()});
    return files;
}

} // namespace

Exporting::Exporting(Workbench &bench, const CheckList &checks, MessageBar &messages,
                     StatusLine &status, QWidget &window)
    : QObject(&window), m_bench(bench), m_checks(checks), m_messages(messages), m_status(status),
      m_window(window)
{
    connect(&bench.session(), &Session::replaced, this, [this] {
        m_last.reset();
        m_written.forget();
    });
}

std::optional<ExportTarget> Exporting::target(const QString &model) const
{
    return m_last ? m_last : rememberedTarget(model);
}

bool Exporting::ask(const QString &suggestion, const QString &model)
{
    if (m_bench.session().hasPreview())
        m_bench.escape(); // a section that is still being drawn is not cut
    ChosenPlace place(suggestion, target(model), [this, &model](const QString &path) {
        return m_written.isOurs(model, path);
    });
    ExportDialog dialog(m_bench, m_checks, filesToChoose(), place, &m_window);
    connect(&dialog, &ExportDialog::couponWanted, this, [&] {
        if (const auto outcome = CouponExport{m_bench, dialog, dialog.choices()}.ask(suggestion))
            dialog.tellOfCoupon(outcome->sentence);
    });
    const bool goesOn = dialog.exec() == QDialog::Accepted;
    if (dialog.problem())
        Q_EMIT problemWanted(*dialog.problem());
    else if (!dialog.sections().empty())
        Q_EMIT sectionsWanted(dialog.sections());
    if (!goesOn)
        return false;
    const ExportTarget target = place.target(dialog.file());
    if (!writeTo(target, model, Replaces::Asked))
        return false;
    if (dialog.choices().opensFolder)
        QDesktopServices::openUrl(QUrl::fromLocalFile(
            dialog.file().isFolder ? target.path : QFileInfo(target.path).absolutePath()));
    return true;
}

bool Exporting::again(const QString &model)
{
    const std::optional<ExportTarget> last = target(model);
    return last && writeTo(*last, model, Replaces::Asking);
}

bool Exporting::writeTo(const ExportTarget &target, const QString &model, Replaces replaces)
{
    const ExportKind kind = exportKindNamed(target.kind);
    m_model = model;
    if (!prepare(target.path))
        return false;
    m_replaces = replaces;
    const bool isWritten = kind.isSkin                   ? writeSkin(target.path, kind)
                           : kind.format->writesSolids() ? writeSolids(target.path, kind)
                                                         : writeDrawing(target.path, kind);
    if (isWritten) {
        m_last = target;
        rememberTarget(model, target);
        Q_EMIT exported();
    }
    return isWritten;
}

bool Exporting::write(const QString &path)
{
    return writeTo({path, kindOf(path, false).key}, m_model, Replaces::Asked);
}

bool Exporting::writeSheets(const QString &path)
{
    return writeTo({path, kindOf(path, true).key}, m_model, Replaces::Asking);
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
    return !why || tellFailure(path, kindOf(path, false), *why);
}

/// A single file was asked about where it was chosen; what is in several is known only now.
bool Exporting::mayReplaceThose(const ExportKind &kind, const std::vector<io::NamedBytes> &files)
{
    std::vector<io::NamedBytes> others;
    for (const io::NamedBytes &file : files)
        if (!m_written.isOurs(m_model, file.path))
            others.push_back({file.path, {}});
    const bool isSingle = !kind.isFilePerSheet && !kind.isFolder;
    return (m_replaces == Replaces::Asked && isSingle) || mayReplace(m_window, others);
}

bool Exporting::put(const QString &path, const ExportKind &kind, const QString &doing,
                    const std::vector<io::NamedBytes> &files)
{
    if (!mayReplaceThose(kind, files)) {
        m_status.say(tr("Not exported: the files that are there stay.")); // not what was done last
        return false;
    }
    const auto written = inBackground<Result<void>>(m_window, doing, MayCancel::No, [files] {
        return files.size() == 1 ? io::writeFile(files[0].path, files[0].bytes)
                                 : io::writeFiles(files);
    });
    if (!*written)
        return tellFailure(path, kind, written->error());
    m_written.remember(m_model, files);
    return true;
}

bool Exporting::writeDrawing(const QString &path, const ExportKind &kind)
{
    const QString name = QFileInfo(path).fileName();
    io::CuttingFileOptions options;
    static_cast<CuttingOptions &>(options) = rememberedChoices().cutting();
    // As they lie in sight, where they do.
    options.lying =
        m_bench.nesting().layoutOf(m_bench.session().analysisPointer(), *options.nesting);
    options.isFilePerSheet = kind.isFilePerSheet;
    options.format = kind.format;
    options.values = kind.values;
    options.isUnpacked = kind.isFolder;
    const QString doing = tr("Exporting %1…").arg(name);
    WorkshopSteps steps;
    if (kind.format->writeUnpacked) {
        const QFileInfo named(m_model.isEmpty() ? path : m_model);
        if (!options.lying) // the steps tell of the sheets that are cut
            options.lying = *inBackground<std::shared_ptr<const Layout>>(
                m_window, doing, MayCancel::No,
                [analysis = m_bench.session().analysisPointer(), options] {
                    return layoutFor(*analysis, options);
                });
        steps = workshopSteps(m_window, m_bench.session(), doing, named.completeBaseName(),
                              options.lying);
        if (steps.isGivenUp)
            return false;
        options.enclosed = steps.files;
    }
    const auto made = inBackground<Result<io::CuttingFile>>(
        m_window, doing, MayCancel::No, [analysis = m_bench.session().analysisPointer(), options] {
            return io::makeCuttingFile(*analysis, options);
        });
    if (!*made)
        return tellFailure(path, kind, made->error());
    const io::CuttingFile &file = **made;
    std::vector<io::NamedBytes> files{{path, file.whole}};
    if (kind.isFilePerSheet) {
        files = io::numberedFiles(path, file.sheets, options.format->suffix());
    } else if (kind.isFolder) {
        files = inWorkshopFolder(path, file.several);
    }
    if (!put(path, kind, doing, files))
        return false;
    QStringList warnings = warningsOf(file);
    if (!steps.whyNone.isEmpty())
        warnings += steps.whyNone;
    if (kind.isFilePerSheet)
        warnings += olderSheets(path, files.size(), options.format->suffix());
    m_messages.show(MessageBar::Severity::Warning, warnings); // hides without any
    const auto nameOf = [](const io::NamedBytes &one) { return QFileInfo(one.path).fileName(); };
    tellDone(file, kind.isFolder ? name
                   : files.size() == 1
                       ? nameOf(files.front())
                       //: %1 and %2 are the first and the last of several files
                       : tr("%1 to %2").arg(nameOf(files.front()), nameOf(files.back())));
    return true;
}

void Exporting::tellDone(const io::CuttingFile &file, const QString &name)
{
    const QString parts = partCountText(file.partCount);
    const QString sheets = sheetCountText(file.sheetCount());
    if (!file.slit) {
        m_status.say(tr("Exported %1 on %2 to %3.").arg(parts, sheets, name));
        return;
    }
    const auto number = [this](double mm) { return lengthNumber(mm, 2, 3, m_window.locale()); };
    const auto [width, kerf] = *file.slit;
    const QString drawn = lengthText(width, 2, 3, m_window.locale());
    m_status.say(kerf == 0.0
                     ? tr("Exported %1 on %2 to %3; slits are drawn %4 wide.")
                           .arg(parts, sheets, name, drawn)
                     //: %4 is a length, %5 the width that is wanted, which is larger by the kerf %6
                     : tr("Exported %1 on %2 to %3; slits are drawn %4 wide (%5 − %6 kerf).")
                           .arg(parts, sheets, name, drawn, number(width + kerf), number(kerf)));
}

bool Exporting::writeSolids(const QString &path, const ExportKind &kind)
{
    const QString name = QFileInfo(path).fileName();
    const AnalysisPointer analysis = m_bench.session().analysisPointer();
    if (analysis->model.sectionCount() == 0)
        return tellFailure(path, kind, Error{ErrorCode::NothingToExport, {}, {}});
    const QString doing = tr("Exporting %1…").arg(name);
    const auto made =
        inBackground<Result<std::string>>(m_window, doing, MayCancel::No, [analysis, kind] {
            return kind.format->writeSolids(analysis->model, analysis->bodies, kind.values);
        });
    if (!*made)
        return tellFailure(path, kind, made->error());
    if (!put(path, kind, doing, {{path, **made}}))
        return false;
    m_messages.dismiss();
    m_status.say(
        tr("Exported %1 as solids to %2.")
            .arg(sectionCountText(static_cast<int>(analysis->model.sectionCount())), name));
    return true;
}

bool Exporting::writeSkin(const QString &path, const ExportKind &kind)
{
    const QString name = QFileInfo(path).fileName(), doing = tr("Exporting %1…").arg(name);
    std::stop_source stop;
    const auto skin = inBackground<Result<Skin>>(
        m_window, doing, MayCancel::Yes,
        [sections = m_bench.session().committed().sections(), given = stop.get_token()] {
            return skinOf(sections, {given, {}});
        });
    stop.request_stop();
    if (!skin)
        return false;
    if (!*skin || !(*skin)->mesh)
        return tellFailure(path, kind, *skin ? noSkin(**skin) : skin->error());
    const auto made = inBackground<std::string>(
        m_window, doing, MayCancel::No,
        [mesh = (*skin)->mesh, format = kind.format] { return format->writeSkin(*mesh); });
    if (!put(path, kind, doing, {{path, *made}}))
        return false;
    m_messages.dismiss();
    m_status.say(
        (*skin)->open > 0
            ? tr("Exported the skin to %1; %n places stay open.", "", (*skin)->open).arg(name)
            : tr("Exported the skin to %1.").arg(name));
    return true;
}

bool Exporting::tellFailure(const QString &path, const ExportKind &kind, const Error &error)
{
    const bool isOfStock =
        error.code == ErrorCode::ClosedSlit || error.code == ErrorCode::CannotOffset;
    const MessageBar::Verb mend =
        isOfStock ? MessageBar::Verb{tr("Stocks…"), [this] { Q_EMIT stocksWanted(); }}
                  : MessageBar::Verb{tr("Export somewhere else…"), [this, path, kind] {
                                         const QString other = askForExport(
                                             &m_window, kind, baseOf({path, kind.key}, path));
                                         if (!other.isEmpty())
                                             writeTo({other, kind.key}, m_model, Replaces::Asking);
                                     }};
    const QString failure = saveFailure(path, error);
    m_messages.show(MessageBar::Severity::Error, {failure}, {mend}, failureDetails(path, error));
    // What is changed then may have mended it.
    if (isOfStock)
        connect(
            &m_bench.session(), &Session::committedChanged, this,
            [this] {
                if (m_messages.text() == m_refusal)
                    m_messages.dismiss();
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
                     tr("Sheets of an earlier export are still there: %1.").arg(separated(names))};
}

QStringList Exporting::warningsOf(const io::CuttingFile &file)
{
    QStringList warnings;
    for (const CuttingRemark &remark : cuttingRemarks(file))
        warnings += remark.text;
    return warnings;
}

} // namespace fff::ui
