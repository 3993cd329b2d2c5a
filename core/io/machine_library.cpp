#include "core/io/machine_library.h"

#include "core/io/document_file.h"
#include "core/io/json_cursor.h"
#include "core/io/json_syntax.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QFile>
#include <QtCore/QJsonDocument>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>
#include <utility>

namespace fff::io {

namespace {

constexpr std::size_t kMostMachines = 1000, kMostGCodeLines = 100, kMostGCodeLine = 120;
constexpr double kLeastSpeed = 1e-3, kLeastStroke = 1e-3; // mm/s, mm: nothing moves, or is seen
constexpr double kMostSpeed = 10'000.0, kMostBed = 100'000.0, kMostStroke = 10.0; // mm/s, mm
constexpr double kMostPowerValue = 1e6;
constexpr int kLightBurnLayers = 32;

constexpr std::array<std::pair<const char *, Purpose>, kPurposes> kPurposeKeys = {
    {{"engrave", Purpose::Engrave},
     {"numbers", Purpose::Number},
     {"score", Purpose::Score},
     {"innerCut", Purpose::InnerCut},
     {"outerCut", Purpose::OuterCut},
     {"guide", Purpose::Guide}}};

Machine::Process &processOf(Machine &machine, Purpose purpose)
{
    return machine.processes[static_cast<std::size_t>(purpose)];
}

/// What may be left out.
template <class Read>
void ifThere(const JsonCursor &cursor, const char *key, const Read &read)
{
    if (const JsonCursor member = cursor.member(key); member.exists())
        read(member);
}

double within(const JsonCursor &cursor, double least, double most, const char *expected)
{
    const double value = cursor.number();
    if (value >= least && value <= most)
        return value;
    cursor.failExpected(expected);
    return least;
}

std::uint32_t colourAt(const JsonCursor &cursor)
{
    const std::string text = cursor.text();
    std::uint32_t colour = 0;
    if (text.size() == 7 && text.front() == '#') {
        const auto [end, error] =
            std::from_chars(text.data() + 1, text.data() + text.size(), colour, 16);
        if (error == std::errc() && end == text.data() + text.size())
            return colour;
    }
    cursor.failExpected(QT_TRANSLATE_NOOP("Error", "a colour such as #ff0000"));
    return 0;
}

void readColours(const JsonCursor &cursor, Machine &machine)
{
    ifThere(cursor, "stroke", [&](const JsonCursor &stroke) {
        machine.stroke = within(stroke, kLeastStroke, kMostStroke,
                                QT_TRANSLATE_NOOP("Error", "a width of lines in mm"));
    });
    for (const auto &[key, purpose] : kPurposeKeys) {
        const JsonCursor colour = cursor.member(key);
        if (purpose == Purpose::Guide && colour.isNull())
            machine.hasGuides = false;
        else if (colour.exists())
            processOf(machine, purpose).colour = colourAt(colour);
    }
}

/// Engraving and numbers alike, and both kinds of cuts.
template <class Set>
void forProcesses(const JsonCursor &cursor, Machine &machine, const Set &set)
{
    constexpr std::array<std::pair<const char *, Purpose>, 5> kKinds = {
        {{"engrave", Purpose::Engrave},
         {"engrave", Purpose::Number},
         {"score", Purpose::Score},
         {"cut", Purpose::InnerCut},
         {"cut", Purpose::OuterCut}}};
    for (const auto &[key, purpose] : kKinds)
        if (const JsonCursor value = cursor.member(key); value.exists())
            set(value, processOf(machine, purpose));
}

void readSpeeds(const JsonCursor &cursor, Machine &machine)
{
    const auto speed = [](const JsonCursor &value) {
        return within(value, kLeastSpeed, kMostSpeed,
                      QT_TRANSLATE_NOOP("Error", "a speed in mm/s"));
    };
    forProcesses(cursor, machine, [&](const JsonCursor &value, Machine::Process &process) {
        process.speed = speed(value);
    });
    ifThere(cursor, "travel", [&](const JsonCursor &travel) { machine.travel = speed(travel); });
}

std::string gcodeLine(const JsonCursor &cursor)
{
    std::string line = cursor.text();
    const bool isPlain =
        std::all_of(line.begin(), line.end(), [](char c) { return c >= ' ' && c <= '~'; });
    if (!isPlain || line.size() > kMostGCodeLine)
        cursor.failExpected(QT_TRANSLATE_NOOP("Error", "a line of G-code"));
    return line;
}

void readGCode(const JsonCursor &cursor, Machine::GCode &gcode)
{
    for (const auto &[key, lines] :
         {std::pair("head", &gcode.head), std::pair("sheet", &gcode.sheet),
          std::pair("foot", &gcode.foot)}) {
        const JsonCursor list = cursor.member(key);
        if (!list.exists())
            continue;
        lines->clear();
        for (const JsonCursor &item : list.items()) {
            if (lines->size() == kMostGCodeLines)
                return item.fail(ErrorCode::BadCount,
                                 {std::to_string(list.items().size()),
                                  std::to_string(kMostGCodeLines),
                                  QT_TRANSLATE_NOOP("Error", "lines of G-code")});
            lines->push_back(gcodeLine(item));
        }
    }
    ifThere(cursor, "on", [&](const JsonCursor &line) { gcode.on = gcodeLine(line); });
    ifThere(cursor, "off", [&](const JsonCursor &line) { gcode.off = gcodeLine(line); });
    ifThere(cursor, "mostPower", [&](const JsonCursor &most) {
        gcode.mostPower =
            within(most, 1.0, kMostPowerValue, QT_TRANSLATE_NOOP("Error", "the largest S"));
    });
}

void readBed(const JsonCursor &cursor, Machine &machine)
{
    machine.bed = cursor.point2();
    if (!(machine.bed.minCoeff() >= 1.0 && machine.bed.maxCoeff() <= kMostBed))
        cursor.failExpected(QT_TRANSLATE_NOOP("Error", "width and height in mm"));
}

void readPowers(const JsonCursor &cursor, Machine &machine)
{
    forProcesses(cursor, machine, [](const JsonCursor &value, Machine::Process &process) {
        process.power = within(value, 0.0, 1.0, QT_TRANSLATE_NOOP("Error", "a share from 0 to 1"));
    });
}

void readLayers(const JsonCursor &cursor, Machine &machine)
{
    for (const auto &[key, purpose] : kPurposeKeys)
        if (const JsonCursor layer = cursor.member(key); layer.exists())
            processOf(machine, purpose).layer =
                static_cast<int>(layer.integer(0, kLightBurnLayers - 1));
}

void readFinish(const JsonCursor &cursor, CutFinish &finish)
{
    ifThere(cursor, "tabs", [&](const JsonCursor &tabs) {
        finish.tabs = static_cast<int>(tabs.integer(0, kMostTabs));
    });
    ifThere(cursor, "tabWidth", [&](const JsonCursor &width) {
        finish.tabWidth = within(width, kLeastTabWidth, kMostTabWidth,
                                 QT_TRANSLATE_NOOP("Error", "a width of tabs in mm"));
    });
    ifThere(cursor, "lead", [&](const JsonCursor &lead) {
        finish.lead =
            within(lead, 0.0, kMostLead, QT_TRANSLATE_NOOP("Error", "a length of leads in mm"));
    });
    ifThere(cursor, "sharesCuts",
            [&](const JsonCursor &shares) { finish.sharesCuts = shares.truth(); });
}

/// colours  all of the file's
void readColoursNamed(const JsonCursor &name, const JsonCursor &colours, Machine &machine)
{
    const std::string key = name.text();
    if (!colours.exists() || !colours.member(key.c_str()).exists())
        name.fail(ErrorCode::UnknownReference, {io::quoted(key)});
    else
        readColours(colours.member(key.c_str()), machine);
}

Machine readMachine(const JsonCursor &cursor, const JsonCursor &colours)
{
    Machine machine;
    machine.key = cursor.member("key").text();
    machine.name = cursor.member("name").text();
    ifThere(cursor, "bed", [&](const JsonCursor &bed) { readBed(bed, machine); });
    ifThere(cursor, "colours",
            [&](const JsonCursor &name) { readColoursNamed(name, colours, machine); });
    ifThere(cursor, "speeds", [&](const JsonCursor &speeds) { readSpeeds(speeds, machine); });
    ifThere(cursor, "powers", [&](const JsonCursor &powers) { readPowers(powers, machine); });
    ifThere(cursor, "layers", [&](const JsonCursor &layers) { readLayers(layers, machine); });
    ifThere(cursor, "finish",
            [&](const JsonCursor &finish) { readFinish(finish, machine.finish); });
    ifThere(cursor, "gcode", [&](const JsonCursor &gcode) { readGCode(gcode, machine.gcode); });
    return machine;
}

std::vector<std::shared_ptr<const Machine>> &knownMachines()
{
    static std::vector<std::shared_ptr<const Machine>> all = [] {
        std::vector<std::shared_ptr<const Machine>> known;
        QFile file(QStringLiteral(":/machines/machines.json"));
        if (file.open(QIODevice::ReadOnly))
            if (const auto read = readMachines(file.readAll().toStdString(), "machines.json"))
                for (const Machine &machine : *read)
                    known.push_back(std::make_shared<const Machine>(machine));
        if (known.empty()) // not reached: a test reads the file
            known.push_back(std::make_shared<const Machine>(usualMachine()));
        return known;
    }();
    return all;
}

} // namespace

Result<std::vector<Machine>> readMachines(std::string_view bytes, const std::string &name)
{
    Problems problems{name};
    const QJsonDocument json = parseJson(bytes, problems);
    const JsonCursor root(json.object(), "$", problems);
    std::vector<Machine> machines;
    for (const JsonCursor &item : root.member("machines").items()) {
        if (problems.failed())
            break;
        if (machines.size() == kMostMachines) {
            item.fail(ErrorCode::BadCount,
                      {std::to_string(kMostMachines + 1), std::to_string(kMostMachines),
                       QT_TRANSLATE_NOOP("Error", "machines")});
            break;
        }
        machines.push_back(readMachine(item, root.member("colours")));
        const std::string &key = machines.back().key;
        if (std::count_if(machines.begin(), machines.end(),
                          [&key](const Machine &one) { return one.key == key; }) > 1)
            item.fail(ErrorCode::DuplicateId, {io::quoted(key)});
    }
    if (!problems.failed() && machines.empty())
        root.member("machines").failExpected(QT_TRANSLATE_NOOP("Error", "a machine"));
    if (problems.failed())
        return tl::unexpected(*problems.error);
    return machines;
}

std::span<const std::shared_ptr<const Machine>> machineLibrary()
{
    return knownMachines();
}

void addOwnMachines(std::vector<Machine> own)
{
    std::vector<std::shared_ptr<const Machine>> &all = knownMachines();
    for (Machine &machine : own) {
        auto one = std::make_shared<const Machine>(std::move(machine));
        const auto known = std::find_if(all.begin(), all.end(),
                                        [&](const auto &other) { return other->key == one->key; });
        if (known != all.end())
            *known = std::move(one);
        else
            all.push_back(std::move(one));
    }
}

Result<std::shared_ptr<const Machine>> machineNamed(const QString &keyOrFile)
{
    if (keyOrFile.endsWith(QLatin1String(".json"), Qt::CaseInsensitive))
        return readFile(keyOrFile).and_then([&](const std::string &bytes) {
            return readMachines(bytes, keyOrFile.toStdString())
                .map([](std::vector<Machine> machines) {
                    return std::make_shared<const Machine>(std::move(machines.front()));
                });
        });
    for (const std::shared_ptr<const Machine> &machine : machineLibrary())
        if (keyOrFile.compare(QString::fromStdString(machine->key), Qt::CaseInsensitive) == 0)
            return machine;
    return failure(ErrorCode::UnknownReference, {}, {keyOrFile.toStdString()});
}

} // namespace fff::io
