// The parts of a model close together on its sheets, or a problem of strip packing.
#include "app/cli/command_line.h"
#include "core/analysis/cutting.h"
#include "core/analysis/lying_parts.h"
#include "core/fabrication/kerf.h"
#include "core/fabrication/nested_layout.h"
#include "core/fabrication/wholeness.h"
#include "core/io/json_writer.h"
#include "core/io/nesting_instance.h"
#include "core/nesting/nester.h"
#include "core/operations/evaluate.h"

#include <QFileInfo>

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <numbers>
#include <thread>

namespace fff::cli {

namespace {

using io::JsonWriter;
using nest::Turning;

constexpr double kDefaultSeconds = 10.0, kMostSeconds = 3600.0;
constexpr double kMostSeed = 4294967295.0;
/// Where the machine is so slow that the work takes this many times as long as was asked for, the
/// best so far has to do.
constexpr double kPatience = 2.0;

QString tr(const char *text)
{
    return QCoreApplication::translate("CommandLine", text);
}

/// What was asked for.
struct NestAsked
{
    double seconds = kDefaultSeconds;
    std::uint64_t seed = 1;
    std::optional<Turning> turning;
    std::optional<double> margin, spacing; // mm
    bool asJson = false;
};

std::optional<Turning> turningNamed(const QString &name)
{
    if (name == QStringLiteral("none"))
        return Turning::None;
    if (name == QStringLiteral("180"))
        return Turning::Half;
    if (name == QStringLiteral("90"))
        return Turning::Quarter;
    return name == QStringLiteral("free") ? std::optional(Turning::Free) : std::nullopt;
}

void addNestOptions(QCommandLineParser &parser)
{
    const auto add = [&](const char *name, const QString &text, const char *value) {
        parser.addOption({QLatin1String(name), text, QLatin1String(value)});
    };
    parser.addOption({QStringLiteral("json"), tr("Prints JSON, for other programs.")});
    add("seconds", tr("How long to search (10); 0 takes the first layout."), "S");
    add("seed", tr("Another number gives another layout, the same one the same."), "N");
    add("rotations", tr("How parts may be turned: none, 180, 90 or free."), "HOW");
    add("margin", tr("From the sheet's edge to the nearest cut."), "MM");
    add("spacing", tr("Between neighbouring cuts."), "MM");
}

/// Nothing, and `status` to return, when an option makes no sense.
std::optional<NestAsked> nestAsked(const QCommandLineParser &parser, const Verb &verb,
                                   std::optional<int> &status)
{
    NestAsked asked;
    asked.asJson = parser.isSet(QStringLiteral("json"));
    asked.seconds =
        number(parser, verb, "seconds", 0.0, status, kMostSeconds).value_or(kDefaultSeconds);
    if (!status) {
        const double seed = number(parser, verb, "seed", 0.0, status, kMostSeed).value_or(1.0);
        asked.seed = static_cast<std::uint64_t>(std::max(0.0, seed));
    }
    if (!status)
        asked.margin = number(parser, verb, "margin", 0.0, status);
    if (!status)
        asked.spacing = number(parser, verb, "spacing", 0.0, status);
    if (const QString name = parser.value(QStringLiteral("rotations"));
        !status && parser.isSet(QStringLiteral("rotations"))) {
        asked.turning = turningNamed(name);
        if (!asked.turning)
            status = wrongUse(
                verb, tr("--rotations: found \"%1\", expected none, 180, 90 or free.").arg(name));
    }
    return status ? std::nullopt : std::optional(asked);
}

/// Stops what takes too long by the clock.
class Guard
{
public:
    explicit Guard(double seconds)
        : m_thread([this, seconds](std::stop_token over) {
              std::unique_lock lock(m_mutex);
              const auto time = std::chrono::duration<double>(kPatience * seconds + 1.0);
              if (!m_wakeUp.wait_for(lock, over, time, [&over] { return over.stop_requested(); }))
                  m_stop.request_stop();
          })
    {
    }

    LongWork work() const { return {m_stop.get_token(), {}}; }

private:
    std::stop_source m_stop;
    std::mutex m_mutex;
    std::condition_variable_any m_wakeUp;
    std::jthread m_thread; // last: it uses the others
};

double degreesOf(const Vec2 &turn)
{
    const double degrees = std::atan2(turn.y(), turn.x()) * 180.0 / std::numbers::pi;
    return degrees < 0.0 ? degrees + 360.0 : degrees;
}

/// Of the work that was done, as seconds are asked for: the same for the same seed.
double secondsOf(std::int64_t work)
{
    return static_cast<double>(work) / nest::kWorkPerSecond;
}

std::string instanceJson(const io::NestingInstance &instance, const nest::Solution &solution)
{
    JsonWriter json;
    json.beginObject();
    json.member("instance", instance.name);
    json.member("length", solution.length);
    json.member("density", solution.density);
    json.key("items");
    json.beginArray();
    for (const nest::Place &place : solution.places) {
        json.beginObject(JsonWriter::Layout::Line);
        json.member("id", instance.ids[static_cast<std::size_t>(place.piece)]);
        json.member("rotation", degreesOf(place.turn));
        json.member("at", place.offset);
        json.endObject();
    }
    json.endArray();
    json.member("seconds", secondsOf(solution.work));
    json.endObject();
    return json.take();
}

int nestInstance(const QString &file, const NestAsked &asked)
{
    const Result<std::string> bytes = io::readFile(file);
    if (!bytes)
        return report(bytes.error());
    Result<io::NestingInstance> instance = io::readNestingInstance(*bytes, file.toStdString());
    if (!instance)
        return report(instance.error());
    nest::Problem &problem = instance->problem;
    problem.margin = asked.margin.value_or(0.0);
    problem.spacing = asked.spacing.value_or(0.0);
    for (nest::Piece &piece : problem.pieces) {
        if (!asked.turning)
            continue;
        piece.turns = nest::turnsOf(*asked.turning);
        piece.turnsFreely = *asked.turning == Turning::Free;
    }
    const Guard guard(asked.seconds);
    const nest::Solution solution =
        nest::nestPieces(problem, {asked.seed, nest::workOf(asked.seconds), true}, guard.work());
    if (!solution.left.empty()) {
        const auto piece = static_cast<std::size_t>(solution.left.front());
        //: %1 is a file and a place in it
        printError(tr("%1: this item is too large for the strip.")
                       .arg(QStringLiteral("%1:$.items[%2]").arg(file, QString::number(piece))));
        return BadInput;
    }
    if (asked.asJson)
        return print(instanceJson(*instance, solution));
    return printLines({tr("Length: %1").arg(QString::number(solution.length)),
                       tr("Density: %1 %").arg(QString::number(100.0 * solution.density, 'f', 2))});
}

/// A model's parts as they are cut.
struct PartsToNest
{
    std::vector<Part> parts;
    Model model;
};

Result<PartsToNest> partsToNest(Document document)
{
    AnalysisCaches caches;
    const Analysis analysis = analyse(evaluate(std::move(document)), caches);
    if (const Result<void> known = haveParts(analysis.model, analysis.bodies); !known)
        return tl::unexpected(known.error());
    std::vector<Part> parts = makeParts(analysis.model, analysis.assembly, analysis.bodies);
    if (parts.empty())
        return nothingToExport(analysis);
    auto paths = compensateKerf(std::move(parts), analysis.model, analysis.bodies);
    if (!paths)
        return tl::unexpected(paths.error());
    return PartsToNest{*std::move(paths), analysis.model};
}

bool isTooLarge(const Layout &layout, int part)
{
    return std::find(layout.oversized.begin(), layout.oversized.end(), part) !=
           layout.oversized.end();
}

/// Sheets with parts that fit them.
std::vector<Sheet> properSheets(const Layout &layout)
{
    std::vector<Sheet> sheets;
    for (const Sheet &sheet : layout.sheets)
        if (!sheet.placements.empty() && !isTooLarge(layout, sheet.placements.front().part))
            sheets.push_back(sheet);
    return sheets;
}

std::vector<std::string> namesOfTooLarge(const Layout &layout, const PartsToNest &of)
{
    std::vector<std::string> names;
    for (const int index : layout.oversized) {
        const Part &part = of.parts[static_cast<std::size_t>(index)];
        names.push_back(of.model.section(static_cast<std::size_t>(part.section))->name);
    }
    return names;
}

double fillOf(const Sheet &sheet, const std::vector<Part> &parts)
{
    Layout alone;
    alone.sheets.push_back(sheet);
    return usedShare(alone, parts);
}

void writeSheet(JsonWriter &json, const Sheet &sheet, const PartsToNest &of)
{
    json.beginObject();
    json.member("size", sheet.size);
    const Stock *stock = of.model.document.find(sheet.stock);
    json.member("stock", stock ? stock->name : std::string());
    json.member("fill", fillOf(sheet, of.parts));
    json.key("parts");
    json.beginArray();
    for (const Placement &placement : sheet.placements) {
        json.beginObject(JsonWriter::Layout::Line);
        json.member("number", of.parts[static_cast<std::size_t>(placement.part)].number);
        json.member("rotation", degreesOf(placement.turn));
        json.member("at", placement.offset);
        json.endObject();
    }
    json.endArray();
    json.endObject();
}

std::string nestJson(const NestedLayout &nested, const PartsToNest &of, const NestAsked &asked)
{
    JsonWriter json;
    json.beginObject();
    json.member("seconds", secondsOf(nested.work));
    json.member("seed", asked.seed);
    json.key("sheets");
    json.beginArray();
    for (const Sheet &sheet : properSheets(nested.layout))
        writeSheet(json, sheet, of);
    json.endArray();
    json.key("tooLarge");
    json.beginArray();
    for (const std::string &name : namesOfTooLarge(nested.layout, of))
        json.value(name);
    json.endArray();
    json.endObject();
    return json.take();
}

QStringList nestText(const NestedLayout &nested, const PartsToNest &of)
{
    const std::vector<Sheet> sheets = properSheets(nested.layout);
    QStringList lines{tr("Parts: %1, sheets: %2")
                          .arg(QString::number(of.parts.size()), QString::number(sheets.size()))};
    for (const Sheet &sheet : sheets) {
        const Stock *stock = of.model.document.find(sheet.stock);
        //: A sheet's size, its stock, how many parts lie on it, and how much of it they cover
        lines += tr("%1 × %2 mm, %3: %4 parts, %5 % covered")
                     .arg(QString::number(sheet.size.x()), QString::number(sheet.size.y()),
                          stock ? QString::fromStdString(stock->name) : QString(),
                          QString::number(sheet.placements.size()),
                          QString::number(100.0 * fillOf(sheet, of.parts), 'f', 1));
    }
    return lines;
}

int nestModel(const QString &file, const DocumentOptions &documentOptions, const NestAsked &asked,
              const Verb &verb)
{
    Loaded loaded = load(file, documentOptions, verb);
    if (loaded.status)
        return *loaded.status;
    const Result<PartsToNest> of = partsToNest(std::move(loaded.document));
    if (!of)
        return report(of.error(), file);
    NestOptions options;
    options.layout.margin = asked.margin.value_or(options.layout.margin);
    options.layout.spacing = asked.spacing.value_or(options.layout.spacing);
    options.turning = asked.turning.value_or(options.turning);
    options.seed = asked.seed;
    options.work = nest::workOf(asked.seconds);
    addWishes(of->model, bodiesOfParts(of->model, of->parts), options);
    const Guard guard(asked.seconds);
    const NestedLayout nested = nestOut(of->parts, of->model, options, guard.work());
    for (const std::string &name : namesOfTooLarge(nested.layout, *of))
        printError(tr("%1: a part is too large for its sheet.").arg(QString::fromStdString(name)));
    return asked.asJson ? print(nestJson(nested, *of, asked)) : printLines(nestText(nested, *of));
}

} // namespace

int runNest(const QStringList &arguments)
{
    QCommandLineParser parser;
    addNestOptions(parser);
    addDocumentOptions(parser);
    const Verb &verb = verbNamed("nest");
    const Arguments parsed = parse(parser, verb, arguments, 1);
    if (parsed.status)
        return *parsed.status;
    std::optional<int> status;
    const auto asked = nestAsked(parser, verb, status);
    if (!asked)
        return *status;
    const auto options = documentOptions(parser, verb, status);
    if (!options)
        return *status;
    const QString file = parsed.files.first();
    return QFileInfo(file).suffix().compare(QStringLiteral("json"), Qt::CaseInsensitive) == 0
               ? nestInstance(file, *asked)
               : nestModel(file, *options, *asked, verb);
}

} // namespace fff::cli
