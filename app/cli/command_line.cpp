#include "app/cli/command_line.h"

#include "app/cli/sheet_options.h"
#include "app/cli/value_options.h"
#include "core/io/error_text.h"
#include "core/io/listing.h"
#include "core/io/material_library.h"
#include "core/io/stock_file.h"
#include "core/io/warning_summary.h"
#include "core/model/edits.h"
#include "core/model/operation_edits.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QSet>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace fff::cli {

namespace {

constexpr std::array kVerbs = {
    Verb{"info", "FILE [--json] [options]",
         QT_TRANSLATE_NOOP("CommandLine", "Sections, joints, size and mass of a model"), runInfo},
    Verb{
        "check", "FILE [--json] [options]",
        QT_TRANSLATE_NOOP("CommandLine",
                          "Whether it holds together, stands, can be assembled and fits the sheet"),
        runCheck},
    Verb{"simulate", "FILE [--json] [--accurate] [--weight NAME[@X,Y]=MASS] [options]",
         QT_TRANSLATE_NOOP("CommandLine",
                           "Whether it is strong enough: forces, stress and what it can hold"),
         runSimulate},
    Verb{"parts", "FILE [--json] [--tolerance MM] [options]",
         QT_TRANSLATE_NOOP("CommandLine", "The parts to cut, in each section's own coordinates"),
         runParts},
    Verb{"export", "FILE -o OUT.{%1} [options]", nullptr, runExport},
#ifdef FFF_HAS_VIEW
    Verb{"render",
         "FILE -o OUT.png [--size WxH] [--view VIEW] [--show WHAT] [--template TEMPLATE[@SIZE]] "
         "[options]",
         QT_TRANSLATE_NOOP("CommandLine", "A picture of the model; needs a display"), runRender},
    Verb{"steps", "FILE -o OUT.{pdf,html,png} [--paper SIZE] [--size WxH] [--view VIEW] [options]",
         QT_TRANSLATE_NOOP("CommandLine", "How it goes together, step by step; needs a display"),
         runSteps},
#endif
    Verb{"values", "FILE [--json] [--try [--seed N]] [options]",
         QT_TRANSLATE_NOOP("CommandLine", "The named values of a model, and what is made of them"),
         runValues},
    Verb{"variants", "FILE --table T.csv -o DIR [--format KIND] [options]",
         QT_TRANSLATE_NOOP("CommandLine",
                           "A cutting file and a verdict for each line of a table of values"),
         runVariants},
    Verb{"operations", "[FILE] [--json] [options]",
         QT_TRANSLATE_NOOP("CommandLine", "All kinds of operations, or the operations of a model"),
         runOperations},
    Verb{"cut", "MESH --plane OX,OY,OZ,NX,NY,NZ [--size MM] [--json]",
         QT_TRANSLATE_NOOP("CommandLine", "The loops in which a plane cuts a mesh"), runCut},
    Verb{"suggest", "MESH -o OUT.fff [--count N] [--seed N] [--size MM] [options]",
         QT_TRANSLATE_NOOP("CommandLine", "Sections that show a mesh, stand and can be assembled"),
         runSuggest},
    Verb{"slices",
         "MESH -o OUT.fff [--along X|Y|Z|XY|XZ|YZ|radial] [--count N | --spacing MM] [--size MM] "
         "[--stock NAME] [options]",
         QT_TRANSLATE_NOOP("CommandLine", "A model of a mesh in slices"), runSlices},
    Verb{"facets", "MESH -o OUT.fff [--faces N] [--unfold] [--size MM] [--stock NAME] [options]",
         QT_TRANSLATE_NOOP("CommandLine", "A model of flat sheets with fingers along their edges"),
         runFacets},
    Verb{"nest",
         "FILE [--json] [--seconds S] [--seed N] [--rotations none|180|90|free] [--margin MM] "
         "[--spacing MM] [options]",
         QT_TRANSLATE_NOOP("CommandLine",
                           "Parts close together on sheets, or the items of a strip (.json)"),
         runNest},
    Verb{"replay", "SCRIPT.json [--from FILE] [--template TEMPLATE[@SIZE]] -o OUT.{%1} [options]",
         QT_TRANSLATE_NOOP("CommandLine", "Plays a script of what a person does in the window"),
         runReplay, true},
};

QString tr(const char *text)
{
    return QCoreApplication::translate("CommandLine", text);
}

QString usageLine(const Verb &verb)
{
    return QStringLiteral("flatfitfab-cli ") + usageOf(verb);
}

/// That one in which it is sold by this thickness, mm; else its usual one.
const Stock &ofThickness(const Material &material, std::optional<double> thickness)
{
    for (const Stock &stock : material.stocks)
        if (thickness == stock.nominalThickness.value_or(stock.thickness))
            return stock;
    return material.stocks.front();
}

/// A stock of the document or a built-in one, by name, whatever the case.
std::optional<Stock> stockNamed(const Document &document, const QString &name,
                                std::optional<double> thickness)
{
    const auto matches = [&](const Stock &stock) {
        return QString::fromStdString(stock.name).compare(name, Qt::CaseInsensitive) == 0;
    };
    for (const auto &stock : document.stocks)
        if (matches(*stock))
            return *stock;
    for (const Stock &stock : {birchPlywood(), flatfabAcrylic()})
        if (matches(stock))
            return stock;
    for (const Material &material : io::materialLibrary())
        if (matches(material.stocks.front()))
            return ofThickness(material, thickness);
    return std::nullopt;
}

/// Every section onto one stock: `--stock`.
std::optional<int> applyStock(Document &document, const QString &name,
                              std::optional<double> thickness, const Verb &verb)
{
    std::optional<Stock> stock;
    if (name.endsWith(QStringLiteral(".fff"), Qt::CaseInsensitive)) {
        const Result<Stock> read = io::readStock(name);
        if (!read)
            return report(read.error());
        stock = *read;
    } else {
        stock = stockNamed(document, name, thickness);
    }
    if (!stock)
        return wrongUse(verb, tr("There is no stock \"%1\". Choose one of the file, or of the list "
                                 "of materials, such as Birch plywood, Acrylic or Card.")
                                  .arg(name));
    StockId id = stock->id;
    if (!document.find(id) || !(*document.find(id) == *stock)) {
        document = *addStock(std::move(document), *stock);
        id = document.currentStock;
    }
    for (const SectionPointer &section : std::vector(document.sections))
        document = *setSectionStock(std::move(document), section->id, id);
    for (const OperationPointer &pointer : std::vector(document.operations)) {
        Operation next = *pointer;
        for (auto &[key, exception] : next.exceptions)
            exception.stock = {};
        std::erase_if(next.exceptions, [](const auto &item) { return item.second.isEmpty(); });
        document = *setOperation(std::move(document), std::move(next));
    }
    document = *setCurrentStock(std::move(document), id);
    return std::nullopt;
}

/// Of an option that was given: what stands in a file has been looked at when it was read.
QString whyNotStock(const std::string &field, const Stock &stock, const DocumentOptions &options)
{
    const QString name = QString::fromStdString(stock.name);
    if (field == "clearance" && !options.clearance)
        return tr("--thickness %1 leaves no room for slits in the stock %2: its clearance is %3 "
                  "mm.")
            .arg(QString::number(stock.thickness), name, QString::number(stock.clearance));
    return tr("--%1 does not fit the stock %2, which is %3 mm thick.")
        .arg(QString::fromStdString(field), name, QString::number(stock.thickness));
}

} // namespace

std::optional<Vec2> sizeOf(const QString &text)
{
    const QStringList sides = text.toLower().split(u'x');
    bool isWidth = false, isHeight = false;
    if (sides.size() != 2)
        return std::nullopt;
    const Vec2 size(sides[0].toDouble(&isWidth), sides[1].toDouble(&isHeight));
    if (!isWidth || !isHeight || !size.allFinite() || size.minCoeff() <= 0.0 ||
        size.maxCoeff() > kMaxCoordinate)
        return std::nullopt;
    return size;
}

std::span<const Verb> verbs()
{
    return kVerbs;
}

const Verb &verbNamed(const char *name)
{
    for (const Verb &verb : kVerbs)
        if (std::strcmp(verb.name, name) == 0)
            return verb;
    qFatal("no such verb");
}

QString modelFiles()
{
    QStringList files;
    for (const io::Format *format : io::formatsThat(&io::Format::readsModels)) {
        const QString suffix = u'.' + format->suffix(), program = QLatin1String(format->program);
        files += program.isEmpty() ? tr("a %1 file").arg(suffix)
                                   : tr("a %2 %1 file").arg(suffix, program);
    }
    return io::enumerated(files, tr("%1 or %2"));
}

QString usageOf(const Verb &verb)
{
    QStringList suffixes;
    std::vector<const io::Format *> written = io::formatsThat(&io::Format::isWritten);
    if (verb.isOfModels)
        std::stable_partition(written.begin(), written.end(),
                              [](const io::Format *format) { return format->writesModels(); });
    for (const io::Format *format : written)
        suffixes += format->suffix();
    QString usage = QLatin1String(verb.usage);
    usage.replace(QStringLiteral("%1"), suffixes.join(u','));
    return QLatin1String(verb.name) + u' ' + usage;
}

QString purposeOf(const Verb &verb)
{
    if (verb.purpose)
        return tr(verb.purpose);
    QStringList written; // formats that write the same say the same
    for (const io::Format *format : io::formatsThat(&io::Format::isWritten))
        written += tr(format->help);
    written.removeDuplicates();
    QString purpose = io::enumerated(written, tr("%1; or %2"), tr("; "));
    purpose.front() = purpose.front().toUpper();
    return purpose;
}

int wrongUse(const Verb &verb, const QString &reason)
{
    printError(reason);
    printError(tr("Usage: %1").arg(usageLine(verb)));
    return WrongUse;
}

Arguments parse(QCommandLineParser &parser, const Verb &verb, const QStringList &arguments,
                int files)
{
    const QCommandLineOption help({QStringLiteral("h"), QStringLiteral("help")},
                                  tr("Shows this help."));
    parser.addOption(help);
    if (!parser.parse(QStringList(QStringLiteral("flatfitfab-cli")) + arguments))
        return {wrongUse(verb, parser.errorText()), {}};
    if (parser.isSet(help)) {
        QString text = QStringLiteral("%1\n\n%2\n\n")
                           .arg(purposeOf(verb), tr("Usage: %1").arg(usageLine(verb)));
        const QString full = parser.helpText();
        text += full.mid(std::max<qsizetype>(0, full.indexOf(QStringLiteral("Options:"))));
        return {print(text.toStdString()), {}};
    }
    const QStringList found = parser.positionalArguments();
    if (found.size() != files)
        return {wrongUse(verb, found.size() < files ? tr("No file was given.")
                                                    : tr("Too many files: %1").arg(found.last())),
                {}};
    return {std::nullopt, found};
}

void addDocumentOptions(QCommandLineParser &parser)
{
    const auto add = [&](const char *name, const QString &text, const char *value) {
        parser.addOption({QLatin1String(name), text, QLatin1String(value)});
    };
    add("set",
        tr("Gives a named value of the model another number, or all that a preset sets; may be "
           "repeated."),
        "NAME=VALUE");
    add("thickness", tr("Thickness of every stock."), "MM");
    add("stock", tr("Cuts every section from this stock, or from that of a .fff file."), "NAME");
    add("kerf", tr("Full width that the machine removes."), "MM");
    add("clearance", tr("Play added to slits; less than 0 for a press fit."), "MM");
    addSheetOptions(parser);
    addFormatOptions(parser, io::FormatOption::Of::Reading);
    parser.addOption({QStringLiteral("verbose"),
                      tr("Says of each thing in the file that was corrected where.")});
}

void addFormatOptions(QCommandLineParser &parser, io::FormatOption::Of of)
{
    QSet<QString> known; // several formats may have one
    for (const io::Format *format : io::formats())
        for (const io::FormatOption &option : format->options)
            if (const QString name = QLatin1String(option.name);
                option.of == of && !known.contains(name)) {
                known += name;
                parser.addOption({name, tr(option.help), QLatin1String(option.value)});
            }
}

namespace {

/// The place of the word that was given.
std::optional<double> choice(const QCommandLineParser &parser, const Verb &verb,
                             const io::FormatOption &option, std::optional<int> &status)
{
    const QString name = QLatin1String(option.name);
    if (!parser.isSet(name))
        return std::nullopt;
    const QString given = parser.value(name);
    QStringList words;
    for (const io::FormatOption::Choice &one : option.choices) {
        if (given.compare(QLatin1String(one.name), Qt::CaseInsensitive) == 0)
            return static_cast<double>(words.size());
        words += QLatin1String(one.name);
    }
    status = wrongUse(verb, tr("--%1: found \"%2\", expected %3.")
                                .arg(name, given, io::enumerated(words, tr("%1 or %2"))));
    return std::nullopt;
}

} // namespace

io::FormatValues formatValues(const QCommandLineParser &parser, const Verb &verb,
                              io::FormatOption::Of of, std::optional<int> &status)
{
    io::FormatValues values;
    for (const io::Format *format : io::formats()) {
        for (const io::FormatOption &option : format->options) {
            if (status || option.of != of)
                continue;
            if (const std::optional<double> value =
                    option.choices.empty()
                        ? number(parser, verb, option.name, option.least, status, option.most)
                        : choice(parser, verb, option, status))
                values[option.name] = *value;
        }
    }
    return values;
}

std::optional<double> number(const QCommandLineParser &parser, const Verb &verb, const char *option,
                             double minimum, std::optional<int> &status, double maximum)
{
    const QString name = QLatin1String(option);
    if (!parser.isSet(name))
        return std::nullopt;
    bool isNumber = false;
    const double value = parser.value(name).toDouble(&isNumber);
    if (isNumber && value >= minimum && value <= maximum)
        return value;
    status = wrongUse(verb, tr("--%1: found \"%2\", expected a number from %3 to %4.")
                                .arg(name, parser.value(name), QString::number(minimum),
                                     QString::number(maximum, 'f', 0)));
    return std::nullopt;
}

std::optional<DocumentOptions> documentOptions(const QCommandLineParser &parser, const Verb &verb,
                                               std::optional<int> &status)
{
    constexpr double kThinnest = 0.01; // mm: thinner than any foil
    DocumentOptions options;
    options.thickness = number(parser, verb, "thickness", kThinnest, status);
    if (!status)
        options.kerf = number(parser, verb, "kerf", 0.0, status);
    if (!status)
        options.clearance = number(parser, verb, "clearance", -kMaxCoordinate, status);
    if (!status)
        options.reading = formatValues(parser, verb, io::FormatOption::Of::Reading, status);
    if (!status)
        readSheets(parser, verb, options, status);
    if (parser.isSet(QStringLiteral("stock")))
        options.stock = parser.value(QStringLiteral("stock"));
    options.values = parser.values(QStringLiteral("set"));
    options.isVerbose = parser.isSet(QStringLiteral("verbose"));
    return status ? std::nullopt : std::optional(options);
}

std::optional<int> applyOptions(Document &document, const DocumentOptions &options,
                                const Verb &verb)
{
    tl::expected<Document, QString> agreed = withValues(document, options.values);
    if (!agreed)
        return wrongUse(verb, tr("--set: %1").arg(agreed.error()));
    document = *std::move(agreed);
    if (options.stock) {
        if (const auto status = applyStock(document, *options.stock, options.thickness, verb))
            return status;
    }
    for (const auto &pointer : std::vector(document.stocks)) {
        Stock stock = *pointer;
        stock.thickness = options.thickness.value_or(stock.thickness);
        stock.kerf = options.kerf.value_or(stock.kerf);
        stock.clearance = options.clearance.value_or(stock.clearance);
        stock.sheet = options.sheet.value_or(stock.sheet);
        if (options.sheetCount)
            stock.sheetCount = options.sheetCount;
        Result<Document> next = setStock(document, stock);
        if (!next)
            return wrongUse(verb, whyNotStock(next.error().place, stock, options));
        document = std::move(*next);
    }
    return applyOffcuts(document, options, verb);
}

Loaded load(const QString &file, const DocumentOptions &options, const Verb &verb)
{
    Loaded loaded;
    io::ReadOptions reading;
    reading.values = options.reading;
    Result<io::LoadedDocument> read = io::readDocument(file, reading);
    if (!read) {
        loaded.status = report(read.error());
        return loaded;
    }
    //: %1 is a file's name, %2 a sentence about what is in it
    for (const QString &sentence : io::warningSummary(read->warnings))
        printError(tr("%1: %2").arg(QFileInfo(file).fileName(), sentence));
    if (options.isVerbose)
        for (const QString &line : io::warningLines(read->warnings))
            printError(line);
    loaded.warnings = std::move(read->warnings);
    loaded.document = std::move(read->document);
    loaded.format = read->format->key;
    loaded.status = applyOptions(loaded.document, options, verb);
    if (!loaded.status)
        for (const QString &sentence : notFollowing(loaded.document))
            printError(tr("%1: %2").arg(QFileInfo(file).fileName(), sentence));
    return loaded;
}

int report(const Error &error)
{
    printError(io::errorText(error));
    switch (error.code) {
    case ErrorCode::CannotWrite:
        return CannotWrite;
    default:
        return BadInput;
    }
}

int report(Error error, const QString &file)
{
    error.place = file.toStdString();
    return report(error);
}

} // namespace fff::cli
