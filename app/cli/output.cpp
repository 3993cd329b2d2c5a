#include "app/cli/output.h"

#include "app/cli/cut_options.h"
#include "app/cli/cutting_warnings.h"
#ifdef FFF_HAS_VIEW
#include "app/cli/enclosed_steps.h"
#endif
#include "core/fabrication/cutting_order.h"
#include "core/fabrication/wholeness.h"
#include "core/io/cutting_file.h"
#include "core/io/error_text.h"
#include "core/io/file_set.h"
#include "core/io/listing.h"
#include "core/io/machine_library.h"
#include "core/io/workshop_archive.h"
#include "core/model/machine_kerfs.h"
#include "core/nesting/problem.h"
#include "core/operations/evaluate.h"
#include "core/skin/skin.h"

#include <QFileInfo>

#include <algorithm>
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

QString machineKeys()
{
    QStringList keys;
    for (const auto &machine : io::machineLibrary())
        keys += QString::fromStdString(machine->key);
    return io::enumerated(keys, tr("%1 or %2"));
}

constexpr double kMostNestSeconds = 3600.0;

/// Of --nest; nothing where parts lie by their boxes.
std::optional<NestOptions> nestingAsked(const QCommandLineParser &parser, QString &why)
{
    if (!parser.isSet(QStringLiteral("nest")))
        return std::nullopt;
    const QString text = parser.value(QStringLiteral("nest"));
    bool isNumber = false;
    const double seconds = text.toDouble(&isNumber);
    if (!isNumber || !(seconds >= 0.0 && seconds <= kMostNestSeconds)) {
        why = tr("--%1: found \"%2\", expected a number from 0 to %3.")
                  .arg(QStringLiteral("nest"), text, QString::number(kMostNestSeconds, 'f', 0));
        return std::nullopt;
    }
    NestOptions options;
    if (parser.isSet(QStringLiteral("no-turning")))
        options.turning = nest::Turning::Quarter;
    options.work = nest::workOf(seconds);
    return options;
}

/// What the options say of a cutting file; nothing, and `why`, when one makes no sense.
std::optional<io::CuttingFileOptions> cuttingOptions(const QCommandLineParser &parser, QString &why)
{
    io::CuttingFileOptions options;
    options.hasReference = !parser.isSet(QStringLiteral("no-reference"));
    options.hasJointColours = parser.isSet(QStringLiteral("joint-colours"));
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
    options.nesting = nestingAsked(parser, why);
    const QString sheets = parser.value(QStringLiteral("sheets"));
    options.isFilePerSheet = sheets == QStringLiteral("files");
    if (!sheets.isEmpty() && sheets != QStringLiteral("files") &&
        sheets != QStringLiteral("groups"))
        why = tr("--sheets: found \"%1\", expected groups or files.").arg(sheets);
    if (const QString machine = parser.value(QStringLiteral("machine")); !machine.isEmpty()) {
        const auto found = io::machineNamed(machine);
        if (found)
            options.machine = *found;
        else if (found.error().code == ErrorCode::UnknownReference && found.error().place.empty())
            why = tr("--machine: there is no machine \"%1\"; expected %2, or a .json file.")
                      .arg(machine, machineKeys());
        else
            why = tr("--machine: %1").arg(io::errorText(found.error()));
    }
    options.finish = finishAsked(parser, options.machine.get(), why);
    if (options.isFilePerSheet && parser.value(QStringLiteral("output")) == QStringLiteral("-"))
        why = tr("--sheets files needs a name: standard output is one file only.");
    return why.isEmpty() ? std::optional(options) : std::nullopt;
}

/// By --format, else by the file's name. Null: none that can be written.
const io::Format *formatOf(const QCommandLineParser &parser)
{
    return io::formatWritten(parser.isSet(QStringLiteral("format"))
                                 ? parser.value(QStringLiteral("format"))
                                 : QFileInfo(parser.value(QStringLiteral("output"))).suffix());
}

/// "svg, obj or fff", each behind `mark`.
QString suffixes(const QString &mark, io::Ability ability = &io::Format::isWritten)
{
    QStringList list;
    for (const io::Format *format : io::formatsThat(ability))
        list += mark + format->suffix();
    return io::enumerated(list, tr("%1 or %2"));
}

Result<Analysis> analysed(const Document &document, const QString &input)
{
    AnalysisCaches caches;
    Analysis analysis = analyse(evaluate(document), caches);
    const std::size_t sections = analysis.model.sectionCount();
    if (sections == 0 || sectionsWithoutPart(analysis.bodies).size() == sections) {
        Error nothing = nothingToExport(analysis).value();
        nothing.place = input.toStdString();
        return tl::unexpected(std::move(nothing));
    }
    return analysis;
}

/// What is written, and how.
struct Wish
{
    const io::Format &format;
    io::FormatValues values;
    QString path;
};

/// Of a list of names, when there are any.
void printNames(const char *text, const std::vector<std::string> &names)
{
    if (!names.empty())
        printError(tr(text).arg(joined(names)));
}

/// How wide it is drawn, and why narrower than it will be.
QString slitText(const DrawnSlit &slit)
{
    const auto number = [](double mm) { return QString::number(mm, 'f', 2); };
    return slit.kerf == 0.0
               ? tr("Slits are drawn %1 mm wide.").arg(number(slit.width))
               //: %2 is the width that is wanted, which is larger by the kerf %3
               : tr("Slits are drawn %1 mm wide (%2 − %3 kerf).")
                     .arg(number(slit.width), number(slit.width + slit.kerf), number(slit.kerf));
}

/// What was written, but cannot be put together, or not as it was meant.
void printImpossible(const Analysis &analysis)
{
    std::vector<std::string> names;
    for (const int section : sectionsWithoutPart(analysis.bodies))
        names.push_back(analysis.model.section(static_cast<std::size_t>(section))->name);
    printNames(
        QT_TRANSLATE_NOOP("CommandLine", "Cut away completely by slits, so there is no part: %1"),
        names);
    printWarnings(analysis);
}

void printOlder(const Wish &wish, std::size_t count)
{
    QStringList names;
    for (const QString &file : io::olderFiles(wish.path, count, wish.format.suffix()))
        names += QFileInfo(file).fileName();
    if (!names.isEmpty())
        printError(tr("Sheets of an earlier export are still there: %1")
                       .arg(names.join(QStringLiteral(", "))));
}

int writeSolids(const Wish &wish, const Document &document, const QString &input)
{
    const Result<Analysis> analysis = analysed(document, input);
    if (!analysis)
        return report(analysis.error());
    const Result<std::string> solids =
        wish.format.writeSolids(analysis->model, analysis->bodies, wish.values);
    if (!solids)
        return report(solids.error(), input);
    if (const Result<void> written = io::writeFile(wish.path, *solids); !written)
        return report(written.error());
    printImpossible(*analysis);
    return Done;
}

int writeSkin(const Wish &wish, const Document &document, const QString &input)
{
    const Result<Skin> skin = skinOf(evaluate(document).sections());
    if (!skin)
        return report(skin.error(), input);
    if (!skin->mesh)
        return report(noSkin(*skin), input);
    if (const Result<void> written = io::writeFile(wish.path, wish.format.writeSkin(*skin->mesh));
        !written)
        return report(written.error());
    printError(
        tr("Patches: %1, triangles: %2.").arg(skin->patches).arg(skin->mesh->triangles().size()));
    if (skin->open > 0)
        printError(tr("Places that stay open: %1").arg(skin->open));
    return Done;
}

/// Whether the sheets fit the machine, and how long it takes.
QString bedText(const Machine &machine, const CuttingDrawing &drawing)
{
    constexpr double kSecondsOfMinute = 60.0;
    ToolWay way;
    int tooLarge = 0;
    for (const CuttingSheet &sheet : drawing.sheets) {
        way += wayAlong(inCuttingOrder(sheet), machine);
        tooLarge += fitsBed(sheet.size, machine) ? 0 : 1;
    }
    const QString name = QString::fromStdString(machine.name);
    //: %1 is a machine, %2 and %3 are numbers
    QString text = tr("%1: %2 m of cuts, about %3 min.")
                       .arg(name, QString::number(way.cut / 1000.0, 'f', 1))
                       .arg(std::ceil(way.seconds / kSecondsOfMinute));
    if (tooLarge > 0)
        //: %1 x %2 is the size of a bed
        text += u' ' + tr("Sheets are larger than its bed of %1 x %2 mm; choose others by --sheet.")
                           .arg(machine.bed.x())
                           .arg(machine.bed.y());
    return text;
}

/// With what the machine removes of its stocks, where that is known and nothing else was asked for.
Document onMachine(const QCommandLineParser &parser, const Document &document,
                   const Machine *machine)
{
    return machine && !parser.isSet(QStringLiteral("kerf")) ? cutOn(document, machine->key)
                                                            : document;
}

int writeCuttingFile(const QCommandLineParser &parser, const Wish &wish, const Document &document,
                     const QString &input)
{
    QString why; // nothing: whyNoOutput has looked
    io::CuttingFileOptions options = cuttingOptions(parser, why).value_or(io::CuttingFileOptions());
    const Result<Analysis> analysis =
        analysed(onMachine(parser, document, options.machine.get()), input);
    if (!analysis)
        return report(analysis.error());
    options.format = &wish.format;
    options.values = wish.values;
#ifdef FFF_HAS_VIEW
    if (options.format == &io::workshopFormat()) {
        QString none;
        options.lying = layoutFor(*analysis, options); // which the steps tell of
        options.enclosed =
            enclosedSteps(*analysis, QFileInfo(input).completeBaseName(), options.lying, none);
        if (options.enclosed.empty())
            //: %1 is a sentence
            printError(tr("The steps are not among the files: %1").arg(none));
    }
#endif
    const Result<io::CuttingFile> file = io::makeCuttingFile(*analysis, options);
    if (!file)
        return report(file.error(), input);
    if (const QString none = whyNoRoom(file->drawing.stocks, options.layout); !none.isEmpty()) {
        printError(none);
        return BadInput;
    }
    const Result<void> written =
        options.isFilePerSheet
            ? io::writeFiles(io::numberedFiles(wish.path, file->sheets, wish.format.suffix()))
            : io::writeFile(wish.path, file->whole);
    if (!written)
        return report(written.error());
    QString made = tr("Parts: %1, sheets: %2, %3 % used.")
                       .arg(file->partCount)
                       .arg(file->sheetCount())
                       .arg(std::lround(100.0 * file->usedShare));
    if (file->slit)
        made += u' ' + slitText(*file->slit);
    printError(made);
    if (options.machine)
        printError(bedText(*options.machine, file->drawing));
    explainSharedCuts(file->drawing);
    explainLeads(file->drawing);
    for (const MissingSheets &missing : file->missing)
        //: %1 is a stock, %2 a number
        printError(tr("Sheets of %1 that are missing: %2")
                       .arg(QString::fromStdString(missing.stock))
                       .arg(missing.count));
    printNames(
        QT_TRANSLATE_NOOP("CommandLine", "Too large for the sheet, on sheets of their own: %1"),
        file->oversized);
    printNames(QT_TRANSLATE_NOOP("CommandLine", "Too slim to carry a number: %1"), file->unmarked);
    printNames(
        QT_TRANSLATE_NOOP("CommandLine", "A hole or a notch narrower than the kerf is not cut: %1"),
        file->uncut);
    printNames(QT_TRANSLATE_NOOP("CommandLine", "No room for the numbers of all joints: %1"),
               file->unmarkedJoints);
    if (options.isFilePerSheet)
        printOlder(wish, file->sheets.size());
    printImpossible(*analysis);
    return Done;
}

} // namespace

void addOutputOptions(QCommandLineParser &parser)
{
    parser.addOption({{QStringLiteral("o"), QStringLiteral("output")},
                      tr("The file to write; - is standard output."),
                      QStringLiteral("OUT")});
    parser.addOption({QStringLiteral("format"),
                      tr("%1; needed if the file's name does not tell.").arg(suffixes(QString())),
                      QStringLiteral("KIND")});
    parser.addOption(
        {QStringLiteral("no-reference"), tr("Leaves out the 100 mm bar beside the sheets.")});
    parser.addOption({QStringLiteral("joint-colours"),
                      tr("Engraves the numbers of each joint in a colour of its own, the same on "
                         "both parts.")});
    parser.addOption({QStringLiteral("margin"), tr("From the sheet's edge to the nearest cut (5)."),
                      QStringLiteral("MM")});
    parser.addOption(
        {QStringLiteral("spacing"), tr("Between neighbouring cuts (2)."), QStringLiteral("MM")});
    parser.addOption(
        {QStringLiteral("no-turning"), tr("Quarter turns only, for sheets with a grain.")});
    parser.addOption({QStringLiteral("nest"),
                      tr("Lays parts by their true outlines, searching for so many seconds; 0 "
                         "takes the first layout (by their boxes)."),
                      QStringLiteral("S")});
    parser.addOption({QStringLiteral("sheets"),
                      tr("groups: one SVG with a group a sheet; files: OUT-1.svg, OUT-2.svg and so "
                         "on (groups)."),
                      QStringLiteral("HOW")});
    parser.addOption(
        {QStringLiteral("machine"),
         tr("The machine that cuts, for its colours, speeds and G-code: %1; or a .json "
            "file with one's own (generic).")
             .arg(machineKeys()),
         QStringLiteral("NAME")});
    parser.addOption(
        {QStringLiteral("skin"),
         //: %1 are ends of names, such as "obj or stl"
         tr("Writes the form that the sections suggest, as a surface (%1), in place of the solids.")
             .arg(suffixes(QString(), &io::Format::writesSkins))});
    addCutOptions(parser);
    addFormatOptions(parser, io::FormatOption::Of::Writing);
}

QString whyNoOutput(const QCommandLineParser &parser)
{
    if (!parser.isSet(QStringLiteral("output")))
        return tr("-o is missing: give the file to write.");
    const QString output = parser.value(QStringLiteral("output"));
    if (output.isEmpty())
        return tr("-o: a file needs a name.");
    if (output == QStringLiteral("-") && !parser.isSet(QStringLiteral("format")))
        return tr("With -o - the format is missing: --format %1.").arg(suffixes(QString()));
    if (!formatOf(parser))
        return tr("%1: this kind of file cannot be written; expected %2.")
            .arg(output, suffixes(QStringLiteral(".")));
    if (parser.isSet(QStringLiteral("skin")) && !formatOf(parser)->writesSkins())
        return tr("--skin: this kind of file cannot hold it; expected %1.")
            .arg(suffixes(QStringLiteral("."), &io::Format::writesSkins));
    if (parser.isSet(QStringLiteral("coupon")) && !formatOf(parser)->writesCutting())
        return tr("--coupon: this kind of file cannot hold it; expected %1.")
            .arg(suffixes(QStringLiteral("."), &io::Format::writesCutting));
    if (parser.isSet(QStringLiteral("joint-colours")) && !formatOf(parser)->showsJointColours())
        return tr("--joint-colours: this kind of file cannot hold them; expected %1.")
            .arg(suffixes(QStringLiteral("."), &io::Format::showsJointColours));
    QString why;
    cuttingOptions(parser, why);
    return why;
}

int writeOutput(const QCommandLineParser &parser, const Verb &verb, const Document &document,
                const QString &input)
{
    std::optional<int> status;
    const Wish wish{*formatOf(parser),
                    formatValues(parser, verb, io::FormatOption::Of::Writing, status),
                    parser.value(QStringLiteral("output"))};
    if (status)
        return *status;
    if (parser.isSet(QStringLiteral("skin")) ||
        (wish.format.isExported() && !wish.format.writesCutting() && !wish.format.writesSolids()))
        return writeSkin(wish, document, input);
    if (parser.isSet(QStringLiteral("coupon"))) {
        QString why; // nothing: whyNoOutput has looked
        const auto options = cuttingOptions(parser, why);
        const std::shared_ptr<const Machine> machine = options ? options->machine : nullptr;
        return writeCoupon(wish.format, wish.values, wish.path,
                           onMachine(parser, document, machine.get()), machine);
    }
    if (wish.format.writesCutting())
        return writeCuttingFile(parser, wish, document, input);
    if (wish.format.writesSolids())
        return writeSolids(wish, document, input);
    const Result<void> written =
        io::modelBytes(document, wish.path.toStdString(), wish.format, wish.values)
            .and_then([&](const std::string &bytes) { return io::writeFile(wish.path, bytes); });
    return written ? Done : report(written.error());
}

} // namespace fff::cli
