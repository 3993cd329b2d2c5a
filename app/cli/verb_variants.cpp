#include "app/cli/all_found.h"
#include "app/cli/command_line.h"
#include "app/cli/cut_options.h"
#include "app/cli/info.h"
#include "app/cli/table.h"
#include "app/cli/value_options.h"
#include "app/cli/value_trial_text.h"
#include "core/analysis/plan_checks.h"
#include "core/io/cutting_file.h"
#include "core/io/error_text.h"
#include "core/operations/evaluate.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <iterator>
#include <string>

namespace fff::cli {

namespace {

QString tr(const char *text)
{
    return QCoreApplication::translate("CommandLine", text);
}

QString csvCell(const QString &text)
{
    if (!text.contains(u',') && !text.contains(u'"') && !text.contains(u'\n'))
        return text;
    QString quoted = text;
    return u'"' + quoted.replace(u'"', QStringLiteral("\"\"")) + u'"';
}

QString csvRow(const QStringList &cells)
{
    QStringList written;
    for (const QString &cell : cells)
        written += csvCell(cell);
    return written.join(u',') + QStringLiteral("\r\n");
}

/// The model of one line of the table, or why there is none.
struct Variant
{
    QStringList cells;         // of its row, behind its line's number and values
    QString wrong;             // not empty: it was not made
    std::optional<int> status; // the folder cannot be written to
};

QStringList verdictsOf(const Analysis &analysis)
{
    const std::vector<Finding> found =
        allFound(analysis, planOf(analysis, timeLimit(kPlanningTime)));
    QStringList cells;
    for (const auto &[column, subject] : kVerdictColumns) {
        Severity worst = Severity::Good;
        for (const Finding &finding : found)
            if (finding.subject() == subject)
                worst = std::max(worst, finding.severity);
        cells += QLatin1String(nameOf(worst));
    }
    return cells;
}

Variant wrongVariant(const QString &why)
{
    Variant variant;
    variant.cells = QStringList(static_cast<qsizetype>(std::size(kVerdictColumns)) + 1);
    variant.wrong = why;
    return variant;
}

Variant made(const Document &document, const QStringList &settings, const io::Format &format,
             const QString &path)
{
    const tl::expected<Document, QString> wanted = withValues(document, settings);
    if (!wanted)
        return wrongVariant(wanted.error());
    AnalysisCaches caches;
    const Analysis analysis = analyse(evaluate(*wanted), caches);
    io::CuttingFileOptions options;
    options.format = &format;
    const Result<io::CuttingFile> file = io::makeCuttingFile(analysis, options);
    if (!file)
        return wrongVariant(io::errorText(file.error()));
    if (const QString why = whyNoRoom(file->drawing.stocks, options.layout); !why.isEmpty())
        return wrongVariant(why);
    if (const Result<void> written = io::writeFile(path, file->whole); !written) {
        Variant variant = wrongVariant(io::errorText(written.error()));
        variant.status = CannotWrite;
        return variant;
    }
    Variant variant;
    variant.cells = QStringList(QFileInfo(path).fileName()) + verdictsOf(analysis);
    return variant;
}

/// Cells by their columns' names; empty ones leave the value as the model has it.
QStringList settingsOf(const TableRow &names, const TableRow &row)
{
    QStringList settings;
    for (qsizetype i = 0; i < std::min(names.cells.size(), row.cells.size()); ++i)
        if (!row.cells[i].isEmpty())
            settings += names.cells[i] + u'=' + row.cells[i];
    return settings;
}

/// The name that two columns have, whatever its capitals; empty: none.
QString namedTwice(const QStringList &names)
{
    for (qsizetype i = 0; i < names.size(); ++i)
        for (qsizetype k = 0; k < i; ++k)
            if (!names[i].isEmpty() && names[i].compare(names[k], Qt::CaseInsensitive) == 0)
                return names[i];
    return {};
}

/// The name of a column of our own, which no value's is, whatever its capitals.
QString ownColumn(const QStringList &values, QString name)
{
    while (values.contains(name, Qt::CaseInsensitive))
        name += QStringLiteral("_");
    return name;
}

/// The names of values between the line's number and what became of it.
QStringList headOf(const QStringList &values)
{
    QStringList head{ownColumn(values, QStringLiteral("line"))};
    head += values;
    head += ownColumn(values, QStringLiteral("file"));
    for (const auto &[column, subject] : kVerdictColumns)
        head += ownColumn(values, QLatin1String(column));
    head += ownColumn(values, QStringLiteral("problem"));
    return head;
}

/// A file for each line, and the table of what became of them. The status to return.
int makeAll(const Document &document, const std::vector<TableRow> &rows, const io::Format &format,
            const QDir &folder, const QString &table)
{
    QString verdicts = csvRow(headOf(rows.front().cells));
    const auto digits = static_cast<int>(std::to_string(rows.back().line).size());
    int status = Done;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const TableRow &row = rows[i];
        const QString number = QString::number(row.line).rightJustified(digits, u'0');
        const QString path =
            folder.filePath(QStringLiteral("variant-%1.%2").arg(number, format.suffix()));
        const bool isTooLong = row.cells.size() > rows.front().cells.size();
        const Variant variant = isTooLong
                                    ? wrongVariant(tr("there are more cells than names."))
                                    : made(document, settingsOf(rows.front(), row), format, path);
        if (variant.status) {
            printError(variant.wrong);
            return *variant.status;
        }
        if (!variant.wrong.isEmpty()) {
            QFile::remove(path); // of an earlier run: it would pass for what this line makes
            //: %1 is a file's name, %2 the number of a line, %3 a sentence
            printError(tr("%1:%2: %3").arg(table, QString::number(row.line), variant.wrong));
            status = BadInput;
        }
        QStringList cells = row.cells.first(std::min(row.cells.size(), rows.front().cells.size()));
        cells.resize(rows.front().cells.size());
        verdicts += csvRow(QStringList(QString::number(row.line)) + cells + variant.cells +
                           QStringList(variant.wrong));
    }
    const Result<void> written =
        io::writeFile(folder.filePath(QStringLiteral("verdicts.csv")), verdicts.toStdString());
    return written ? status : report(written.error());
}

} // namespace

int runVariants(const QStringList &arguments)
{
    const Verb &verb = verbNamed("variants");
    QCommandLineParser parser;
    parser.addOption({QStringLiteral("table"),
                      tr("A CSV file: names of values, and a line of numbers for each variant."),
                      QStringLiteral("T.csv")});
    parser.addOption({{QStringLiteral("o"), QStringLiteral("output")},
                      tr("The folder to write to; it is made where there is none."),
                      QStringLiteral("DIR")});
    parser.addOption({QStringLiteral("format"), tr("What is written of each (svg)."),
                      QStringLiteral("KIND"), QStringLiteral("svg")});
    addDocumentOptions(parser);
    const Arguments found = parse(parser, verb, arguments, 1);
    if (found.status)
        return *found.status;
    const QString table = parser.value(QStringLiteral("table"));
    const QString folder = parser.value(QStringLiteral("output"));
    if (table.isEmpty() || folder.isEmpty())
        return wrongUse(verb, tr("--table and -o are both needed."));
    const io::Format *format =
        io::formatWritten(parser.value(QStringLiteral("format")), &io::Format::writesCutting);
    if (!format)
        return wrongUse(verb, tr("--format: found \"%1\", expected a kind of cutting file.")
                                  .arg(parser.value(QStringLiteral("format"))));
    std::optional<int> status;
    const std::optional<DocumentOptions> options = documentOptions(parser, verb, status);
    if (!options)
        return *status;
    const Loaded loaded = load(found.files.front(), *options, verb);
    if (loaded.status)
        return *loaded.status;
    const Result<std::string> bytes = io::readFile(table);
    if (!bytes)
        return report(bytes.error());
    const auto rows = readTable(QString::fromStdString(*bytes));
    const QString name = QFileInfo(table).fileName();
    if (!rows || rows->size() < 2) {
        printError(rows
                       ? tr("%1: found no line of numbers, expected one below the names.").arg(name)
                       : tr("%1: a quote is not closed.").arg(name));
        return BadInput;
    }
    if (const QString twice = namedTwice(rows->front().cells); !twice.isEmpty()) {
        printError(tr("%1: two columns are named \"%2\".").arg(name, twice));
        return BadInput;
    }
    if (!QDir().mkpath(folder)) {
        printError(tr("%1: the folder cannot be made.").arg(folder));
        return CannotWrite;
    }
    return makeAll(loaded.document, *rows, *format, QDir(folder), name);
}

} // namespace fff::cli
