#include "app/cli/command_line.h"
#include "app/cli/info.h"
#include "app/cli/picture_options.h"
#include "core/analysis/plan_checks.h"
#include "core/io/error_text.h"
#include "core/io/file_set.h"
#include "core/operations/evaluate.h"
#include "core/session/assembly_steps.h"
#include "ui/view/steps_files.h"

#include <QFileInfo>
#include <QTextStream>

#include <cstdio>
#ifdef Q_OS_UNIX
#include <unistd.h>
#endif

namespace fff::cli {

namespace {

using ui::StepsFiles;

QString tr(const char *text)
{
    return QCoreApplication::translate("CommandLine", text);
}

const QString kPaper = QStringLiteral("pdf"), kPage = QStringLiteral("html"),
              kPictures = QStringLiteral("png");

struct Wish
{
    StepsFiles::Options files;
    PictureOptions picture;
};

/// What was asked for, or why not.
QString read(const QCommandLineParser &parser, Wish &wish)
{
    if (!parser.isSet(QStringLiteral("output")))
        return tr("-o is missing: give the file to write.");
    const QString output = parser.value(QStringLiteral("output"));
    if (output.isEmpty())
        return tr("-o: a file needs a name.");
    const QString suffix =
        output == QStringLiteral("-") ? kPaper : QFileInfo(output).suffix().toLower();
    if (suffix != kPaper && suffix != kPage && suffix != kPictures)
        return tr("%1: this kind of file cannot be written; expected .pdf, .html or .png.")
            .arg(output);
    wish.files.kind = suffix == kPaper  ? StepsFiles::Kind::Paper
                      : suffix == kPage ? StepsFiles::Kind::Page
                                        : StepsFiles::Kind::Pictures;
    if (suffix == kPaper && parser.isSet(QStringLiteral("size")))
        return tr("--size is for .png; a PDF has the size of its paper.");
    if (suffix == kPage && parser.isSet(QStringLiteral("size")))
        return tr("--size is for .png; a web page fits its screen.");
    const QString paper = parser.value(QStringLiteral("paper")).toLower();
    if (suffix != kPaper && !paper.isEmpty())
        return tr("--paper is for .pdf.");
    if (!paper.isEmpty() && paper != QStringLiteral("a4") && paper != QStringLiteral("letter"))
        return tr("--paper: found \"%1\", expected a4 or letter.").arg(paper);
    wish.files.paper.size = paper.isEmpty() ? ui::StepsPaper::usualSize(QLocale::system())
                            : paper == QStringLiteral("a4") ? QPageSize::A4
                                                            : QPageSize::Letter;
    const QString reason = readPictureOptions(parser, wish.picture);
    wish.files.size = wish.picture.size;
    orientationOfView(wish.picture.view.toStdString(), wish.files.looking.orientation);
    return reason;
}

/// Where someone watches.
void showProgress(int done, int count)
{
#ifdef Q_OS_UNIX
    if (isatty(STDERR_FILENO)) {
        QTextStream(stderr) << '\r' << tr("Step %1 of %2").arg(done).arg(count)
                            << (done == count ? "\n" : "") << Qt::flush;
    }
#else
    Q_UNUSED(done)
    Q_UNUSED(count)
#endif
}

int write(const QString &output, StepsFiles::Kind kind, StepsFiles &files)
{
    if (!files.isUsable()) {
        printError(tr("A picture needs a display with OpenGL 3.3; there is none."));
        return CannotWrite;
    }
    const int count = files.pieceCount();
    for (int i = 0; i < count; ++i) {
        if (!files.makePiece(i)) {
            printError(kind == StepsFiles::Kind::Page
                           ? tr("A picture of the steps could not be made.")
                           : tr("The picture could not be written as a PNG file."));
            return CannotWrite;
        }
        showProgress(i + 1, count);
    }
    const std::vector<std::string> contents = files.take();
    const Result<void> written =
        kind != StepsFiles::Kind::Pictures
            ? io::writeFile(output, contents.front())
            : io::writeFiles(
                  io::numberedFiles(output, contents, kPictures, io::digitsFor(contents.size())));
    return written ? Done : report(written.error());
}

} // namespace

int runSteps(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.addOption(
        {{QStringLiteral("o"), QStringLiteral("output")},
         tr("A PDF file with all steps (- is standard output), OUT.html for a web page "
            "where the model can be turned, also on a phone, or OUT.png for "
            "OUT-01.png, OUT-02.png and so on."),
         QStringLiteral("OUT")});
    parser.addOption({QStringLiteral("paper"),
                      tr("a4 or letter (by default as is usual in your country)."),
                      QStringLiteral("SIZE")});
    addPictureOptions(parser);
    addDocumentOptions(parser);
    const Verb &verb = verbNamed("steps");
    const Arguments parsed = parse(parser, verb, arguments, 1);
    if (parsed.status)
        return *parsed.status;
    Wish wish;
    if (const QString reason = read(parser, wish); !reason.isEmpty())
        return wrongUse(verb, reason);
    std::optional<int> status;
    const auto options = documentOptions(parser, verb, status);
    if (!options)
        return *status;
    const QString input = parsed.files.first();
    Loaded loaded = load(input, *options, verb);
    if (loaded.status)
        return *loaded.status;

    AnalysisCaches caches;
    const AnalysisPointer analysis = analyseNext(evaluate(std::move(loaded.document)), caches);
    const ModelPlan plan = planOf(*analysis, timeLimit(kPlanningTime));
    const AssemblyStepsPointer steps = assemblySteps(analysis, plan);
    if (!steps && plan.failure)
        return report(*plan.failure, input);
    if (!steps) {
        printError(whyNoSteps(*analysis, plan));
        return analysis->model.sectionCount() == 0 ? BadInput : ProblemsFound;
    }
    wish.files.paper.title = QFileInfo(input).completeBaseName();
    StepsFiles files(steps, wish.files);
    return write(parser.value(QStringLiteral("output")), wish.files.kind, files);
}

} // namespace fff::cli
