#include "app/cli/output.h"

#include "core/io/cutting_file.h"
#include "core/io/fff_format.h"
#include "core/io/file_set.h"
#include "core/io/obj_writer.h"
#include "core/operations/evaluate.h"

#include <QFileInfo>
#include <QTextStream>

#include <cmath>
#include <optional>

namespace fff::cli {

namespace {

QString tr(const char *text)
{
    return QCoreApplication::translate("CommandLine", text);
}

QString joined(const std::vector<std::string> &names)
{
    QStringList list;
    for (const std::string &name : names)
        list += QString::fromStdString(name);
    return list.join(QStringLiteral(", "));
}

/// What the options say of a cutting file; nothing, and `why`, when one makes no sense.
std::optional<io::CuttingFileOptions> cuttingOptions(const QCommandLineParser &parser, QString &why)
{
    io::CuttingFileOptions options;
    options.hasReference = !parser.isSet(QStringLiteral("no-reference"));
    options.layout.turnsFreely = !parser.isSet(QStringLiteral("no-turning"));
    const auto length = [&](const char *name, double &value) {
        const QString text = parser.value(QLatin1String(name));
        if (text.isEmpty())
            return;
        bool isNumber = false;
        const double mm = text.toDouble(&isNumber);
        if (isNumber && mm >= 0.0 && mm <= kMaxCoordinate)
            value = mm;
        else
            why = tr("--%1: found \"%2\", expected a number from 0 to %3.")
                      .arg(QLatin1String(name), text, QString::number(kMaxCoordinate, 'f', 0));
    };
    length("margin", options.layout.margin);
    length("spacing", options.layout.spacing);
    const QString sheets = parser.value(QStringLiteral("sheets"));
    options.isFilePerSheet = sheets == QStringLiteral("files");
    if (!sheets.isEmpty() && sheets != QStringLiteral("files") &&
        sheets != QStringLiteral("groups"))
        why = tr("--sheets: found \"%1\", expected groups or files.").arg(sheets);
    if (options.isFilePerSheet && parser.value(QStringLiteral("output")) == QStringLiteral("-"))
        why = tr("--sheets files needs a name: standard output is one file only.");
    return why.isEmpty() ? std::optional(options) : std::nullopt;
}

Result<Analysis> analysed(const Document &document, const QString &input)
{
    AnalysisCaches caches;
    Analysis analysis = analyse(evaluate(document), caches);
    if (analysis.model.sectionCount() == 0)
        return failure(ErrorCode::NothingToExport, input.toStdString());
    return analysis;
}

int writeSolids(const QCommandLineParser &parser, const Document &document, const QString &input)
{
    const Result<Analysis> analysis = analysed(document, input);
    if (!analysis)
        return report(analysis.error());
    const Result<std::string> solids = io::writeObj(analysis->model, analysis->bodies);
    if (!solids)
        return report(solids.error(), input);
    const Result<void> written = io::writeFile(parser.value(QStringLiteral("output")), *solids);
    return written ? Done : report(written.error());
}

int writeCuttingFile(const QCommandLineParser &parser, const Document &document,
                     const QString &input)
{
    const Result<Analysis> analysis = analysed(document, input);
    if (!analysis)
        return report(analysis.error());
    QString why; // nothing: whyNoOutput has looked
    const io::CuttingFileOptions options =
        cuttingOptions(parser, why).value_or(io::CuttingFileOptions());
    const Result<io::CuttingFile> file = io::makeCuttingFile(*analysis, options);
    if (!file)
        return report(file.error(), input);
    const QString path = parser.value(QStringLiteral("output"));
    const Result<void> written = options.isFilePerSheet
                                     ? io::writeFiles(io::numberedFiles(path, file->sheets))
                                     : io::writeFile(path, file->svg);
    if (!written)
        return report(written.error());
    QTextStream err(stderr);
    err << tr("Parts: %1, sheets: %2, %3 % used.")
               .arg(file->partCount)
               .arg(file->sheetCount())
               .arg(std::lround(100.0 * file->usedShare));
    if (file->slitWidth)
        err << ' '
            << tr("Narrowest slit as drawn: %1 mm.").arg(QString::number(*file->slitWidth, 'f', 2));
    err << Qt::endl;
    if (!file->oversized.empty())
        err << tr("Too large for the sheet, on sheets of their own: %1")
                   .arg(joined(file->oversized))
            << Qt::endl;
    if (!file->unmarked.empty())
        err << tr("Too slim to carry a number: %1").arg(joined(file->unmarked)) << Qt::endl;
    if (!file->uncut.empty())
        err << tr("A hole or a notch narrower than the kerf is not cut: %1")
                   .arg(joined(file->uncut))
            << Qt::endl;
    if (!file->unmarkedJoints.empty())
        err << tr("No room for the numbers of all joints: %1").arg(joined(file->unmarkedJoints))
            << Qt::endl;
    return Done;
}

} // namespace

void addOutputOptions(QCommandLineParser &parser)
{
    parser.addOption({{QStringLiteral("o"), QStringLiteral("output")},
                      tr("The file to write; - is standard output."),
                      QStringLiteral("OUT")});
    parser.addOption({QStringLiteral("format"),
                      tr("svg, obj or fff, where the file's name does not tell."),
                      QStringLiteral("KIND")});
    parser.addOption(
        {QStringLiteral("no-reference"), tr("Leaves out the 100 mm bar beside the sheets.")});
    parser.addOption({QStringLiteral("margin"), tr("From the sheet's edge to the nearest cut (5)."),
                      QStringLiteral("MM")});
    parser.addOption(
        {QStringLiteral("spacing"), tr("Between neighbouring cuts (2)."), QStringLiteral("MM")});
    parser.addOption(
        {QStringLiteral("no-turning"), tr("Quarter turns only, for sheets that have a grain.")});
    parser.addOption({QStringLiteral("sheets"),
                      tr("groups: one SVG with a group a sheet; files: OUT-1.svg, OUT-2.svg and so "
                         "on (groups)."),
                      QStringLiteral("HOW")});
}

static QString formatOf(const QCommandLineParser &parser)
{
    return parser.isSet(QStringLiteral("format"))
               ? parser.value(QStringLiteral("format")).toLower()
               : QFileInfo(parser.value(QStringLiteral("output"))).suffix().toLower();
}

QString whyNoOutput(const QCommandLineParser &parser)
{
    if (!parser.isSet(QStringLiteral("output")))
        return tr("-o is missing: the file to write.");
    const QString output = parser.value(QStringLiteral("output"));
    if (output.isEmpty())
        return tr("-o: a file needs a name.");
    if (output == QStringLiteral("-") && !parser.isSet(QStringLiteral("format")))
        return tr("With -o - the kind is missing: --format svg, obj or fff.");
    const QString format = formatOf(parser);
    if (format != QStringLiteral("svg") && format != QStringLiteral("obj") &&
        format != QStringLiteral("fff"))
        return tr("%1 is of no kind that can be written; expected .svg, .obj or .fff.").arg(output);
    QString why;
    cuttingOptions(parser, why);
    return why;
}

int writeOutput(const QCommandLineParser &parser, const Document &document, const QString &input)
{
    if (formatOf(parser) == QStringLiteral("svg"))
        return writeCuttingFile(parser, document, input);
    if (formatOf(parser) == QStringLiteral("obj"))
        return writeSolids(parser, document, input);
    const QString output = parser.value(QStringLiteral("output"));
    const Result<void> written =
        output == QStringLiteral("-")
            ? io::writeFff(document).and_then(
                  [&](const std::string &bytes) { return io::writeFile(output, bytes); })
            : io::writeDocument(output, document);
    return written ? Done : report(written.error());
}

} // namespace fff::cli
