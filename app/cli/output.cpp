#include "app/cli/output.h"

#include "core/io/fff_format.h"
#include "core/operations/evaluate.h"
#include "core/session/cutting_file.h"

#include <QFileInfo>
#include <QTextStream>

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

int writeCuttingFile(const QCommandLineParser &parser, const Document &document,
                     const QString &input)
{
    AnalysisCaches caches;
    CuttingFileOptions options;
    options.hasReference = !parser.isSet(QStringLiteral("no-reference"));
    const Result<CuttingFile> file = makeCuttingFile(analyse(evaluate(document), caches), options);
    if (!file) {
        Error error = file.error();
        error.place = input.toStdString();
        return report(error);
    }
    const QString path = parser.value(QStringLiteral("output"));
    if (const Result<void> written = io::writeFile(path, file->svg); !written)
        return report(written.error());
    QTextStream err(stderr);
    err << tr("Parts: %1, sheets: %2.").arg(file->partCount).arg(file->sheetCount);
    if (file->slitWidth)
        err << ' '
            << tr("Narrowest slit as drawn: %1 mm.").arg(QString::number(*file->slitWidth, 'f', 2));
    err << Qt::endl;
    if (!file->oversized.empty())
        err << tr("Too large for the sheet, on sheets of their own: %1")
                   .arg(joined(file->oversized))
            << Qt::endl;
    if (!file->closedSlits.empty())
        err << tr("The kerf is as wide as the slits and closes them: %1")
                   .arg(joined(file->closedSlits))
            << Qt::endl;
    if (!file->unmarked.empty())
        err << tr("Too slim to carry a number: %1").arg(joined(file->unmarked)) << Qt::endl;
    return Done;
}

} // namespace

void addOutputOptions(QCommandLineParser &parser)
{
    parser.addOption({{QStringLiteral("o"), QStringLiteral("output")},
                      tr("The file to write; - is standard output."),
                      QStringLiteral("OUT")});
    parser.addOption({QStringLiteral("format"),
                      tr("svg or fff, where the file's name does not tell."),
                      QStringLiteral("KIND")});
    parser.addOption(
        {QStringLiteral("no-reference"), tr("Leaves out the 100 mm bar beside the sheets.")});
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
    if (output == QStringLiteral("-") && !parser.isSet(QStringLiteral("format")))
        return tr("With -o - the kind is missing: --format svg or --format fff.");
    const QString format = formatOf(parser);
    if (format != QStringLiteral("svg") && format != QStringLiteral("fff"))
        return tr("%1 is of no kind that can be written; expected .svg or .fff.").arg(output);
    return {};
}

int writeOutput(const QCommandLineParser &parser, const Document &document, const QString &input)
{
    if (formatOf(parser) == QStringLiteral("svg"))
        return writeCuttingFile(parser, document, input);
    const QString output = parser.value(QStringLiteral("output"));
    const Result<void> written =
        output == QStringLiteral("-")
            ? io::writeFff(document).and_then(
                  [&](const std::string &bytes) { return io::writeFile(output, bytes); })
            : io::writeDocument(output, document);
    return written ? Done : report(written.error());
}

} // namespace fff::cli
