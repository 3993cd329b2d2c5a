// flatfitfab-bench: what loading, slits, parts, cutting file, an edit and its undo cost.
#include "core/io/document_file.h"
#include "core/io/error_text.h"
#include "tests/bench/adjust_cost.h"
#include "tests/bench/drawing_growth.h"
#include "tests/bench/fabrication_cost.h"
#include "tests/bench/generated_models.h"
#include "tests/bench/kernel.h"
#include "tests/bench/mesh_cost.h"
#include "tests/bench/nesting_cost.h"
#include "tests/bench/report.h"
#include "tests/bench/strength_cost.h"
#include "tests/bench/stroke_event.h"
#include "tests/bench/value_cost.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QDir>
#include <QTextStream>

using namespace fff;
using namespace fff::bench;

namespace {

constexpr int kDefaultRuns = 5;

/// A model to measure: a file, and which of its sections is edited.
struct Case
{
    std::string name;
    QString path;
    int edited = -1;
};

int fail(const QString &message)
{
    QTextStream(stderr) << message << Qt::endl;
    return 1;
}

std::vector<Case> casesIn(const QString &folder)
{
    std::vector<Case> cases;
    const QStringList filters{QStringLiteral("*.txt"), QStringLiteral("*.fff")};
    for (const QFileInfo &file : QDir(folder).entryInfoList(filters, QDir::Files, QDir::Name))
        cases.push_back({file.completeBaseName().toStdString(), file.absoluteFilePath()});
    return cases;
}

/// Written into the folder, so that they are loaded like any other.
std::vector<Case> generatedCases(const QString &folder)
{
    std::vector<Case> cases;
    const auto add = [&](const std::string &name, const Document &document, int edited = -1) {
        const QString path =
            folder + QLatin1Char('/') + QString::number(cases.size()) + QStringLiteral(".txt");
        if (io::writeFile(path, flatfabText(document)))
            cases.push_back({name, path, edited});
    };
    for (int sections : {50, 200, 800, 3200, 12800})
        add("comb of " + std::to_string(sections), comb(sections));
    for (int sections : {800, 3200, 12800})
        add("jointed comb of " + std::to_string(sections), jointedComb(sections));
    const auto square = [](const char *name, int n) {
        return std::string(name) + ' ' + std::to_string(n) + " × " + std::to_string(n);
    };
    for (int n : {5, 10, 20, 25, 40, 50, 100})
        add(square("lattice", n), lattice(n));
    for (int n : {5, 10, 20, 40}) {
        const Document document = latticeWithShort(n);
        add(square("short in lattice", n), document,
            static_cast<int>(document.sections.size()) - 1);
    }
    for (int n : {10, 20, 40, 80, 160})
        add(square("crates of 10, in all", n), crates(n, 10));
    const auto addRepeated = [&](const char *kind, bool scaled, bool branches, const char *what) {
        const QString path =
            folder + QLatin1Char('/') + QString::number(cases.size()) + QStringLiteral(".fff");
        if (!io::writeDocument(path, repeated(kind, scaled, branches)))
            return;
        for (const int edited : {0, 1})
            cases.push_back(
                {std::string("50 ") + what + (edited == 0 ? ", spine" : ", rib"), path, edited});
    };
    addRepeated("linear", false, false, "linear");
    addRepeated("linear", true, false, "linear scaled");
    addRepeated("linear", false, true, "linear branches");
    addRepeated("revolve", false, false, "revolved");
    addRepeated("revolve", true, false, "revolved scaled");
    return cases;
}

/// Strokes of so many samples, by each kind of hand that is wanted.
std::vector<StrokeTiming> drawnStrokes(const QStringList &sizes, const QStringList &only,
                                       const std::optional<Kernel> &kernel)
{
    std::vector<StrokeTiming> rows;
    for (const std::string &hand : strokeHands()) {
        if (!only.isEmpty() && !only.contains(QString::fromStdString(hand)))
            continue;
        for (const QString &size : sizes) {
            const double before = kernel ? kernel->run() : 0.0;
            StrokeTiming row = drawStroke(hand, size.toInt());
            row.kernel = kernel ? 0.5 * (before + kernel->run()) : 0.0;
            QTextStream(stderr) << QString::fromStdString(hand) << ' ' << size << Qt::endl;
            rows.push_back(std::move(row));
        }
    }
    return rows;
}

/// Of all cases that are wanted.
template <class Row, class IsWanted, class Measure>
Result<std::vector<Row>> rowsOf(const std::vector<Case> &cases, IsWanted isWanted,
                                const std::optional<Kernel> &kernel, Measure measureOne)
{
    std::vector<Row> rows;
    // Before and after each model: others may be busy on the machine at one time and not another.
    double before = kernel ? kernel->run() : 0.0;
    for (const Case &item : cases) {
        if (!isWanted(item.name))
            continue;
        Result<Row> row = measureOne(item);
        if (!row)
            return tl::unexpected(row.error());
        const double after = kernel ? kernel->run() : 0.0;
        row->kernel = 0.5 * (before + after);
        before = after;
        QTextStream(stderr) << QString::fromStdString(row->name) << Qt::endl;
        rows.push_back(*std::move(row));
    }
    return rows;
}

} // namespace

int main(int argc, char **argv)
{
    QCoreApplication application(argc, argv);
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral(
        "Measures what the program does with each model of the folders and with generated ones."));
    parser.addHelpOption();
    parser.addOption(
        {QStringLiteral("json"), QStringLiteral("Also as JSON."), QStringLiteral("FILE")});
    parser.addOption({QStringLiteral("kernel"),
                      QStringLiteral("Program (or its .cpp) whose time is the unit of comparison."),
                      QStringLiteral("FILE")});
    parser.addOption({QStringLiteral("peer"),
                      QStringLiteral("The old program's timings, to be compared with."),
                      QStringLiteral("FILE")});
    parser.addOption({QStringLiteral("runs"), QStringLiteral("Of which the median is taken (5)."),
                      QStringLiteral("N"), QString::number(kDefaultRuns)});
    parser.addOption({QStringLiteral("only"),
                      QStringLiteral("Models whose name contains this; may be repeated."),
                      QStringLiteral("TEXT")});
    parser.addOption({QStringLiteral("strokes"),
                      QStringLiteral("Strokes of so many samples instead, separated by commas; "
                                     "--only names hands."),
                      QStringLiteral("N,…")});
    parser.addOption({QStringLiteral("strength"),
                      QStringLiteral("What it costs to say whether the models hold, instead; of "
                                     "the runs the shortest.")});
    parser.addOption({QStringLiteral("meshes"),
                      QStringLiteral("What meshes to draw over cost, instead; of the runs the "
                                     "shortest.")});
    parser.addOption({QStringLiteral("nesting"),
                      QStringLiteral("How close the items of the folders' strips (.json) come in "
                                     "these seconds of work, and what first layouts cost, "
                                     "instead."),
                      QStringLiteral("S,…")});
    parser.addOption({QStringLiteral("values"),
                      QStringLiteral("What values that are made of each other cost, of the runs "
                                     "the shortest, and moves of the sliders of the folders' "
                                     "models, instead.")});
    parser.addOption({QStringLiteral("fabrication"),
                      QStringLiteral("What it costs to lay the folders' models on sheets, to lay "
                                     "them again after an edit of one part, and to write them, "
                                     "instead; of the runs the shortest.")});
    parser.addPositionalArgument(QStringLiteral("FOLDER"), QStringLiteral("Models to measure."),
                                 QStringLiteral("[FOLDER…]"));
    parser.process(application);

    std::optional<Kernel> kernel;
    if (parser.isSet(QStringLiteral("kernel"))) {
        const Result<Kernel> opened = Kernel::open(parser.value(QStringLiteral("kernel")));
        if (!opened)
            return fail(io::errorText(opened.error()));
        kernel = *opened;
    }
    const QStringList only = parser.values(QStringLiteral("only"));
    if (parser.isSet(QStringLiteral("strokes"))) {
        const QStringList sizes = parser.value(QStringLiteral("strokes")).split(QLatin1Char(','));
        QTextStream(stdout) << QString::fromStdString(
            strokeTable(drawnStrokes(sizes, only, kernel)));
        return 0;
    }
    const int runs = std::max(1, parser.value(QStringLiteral("runs")).toInt());
    if (parser.isSet(QStringLiteral("meshes"))) {
        QTextStream(stdout) << QString::fromStdString(meshTable(meshCosts(runs, kernel)));
        return 0;
    }
    if (parser.isSet(QStringLiteral("nesting"))) {
        std::vector<double> seconds;
        for (const QString &s : parser.value(QStringLiteral("nesting")).split(QLatin1Char(',')))
            seconds.push_back(s.toDouble());
        const auto strips = stripResults(parser.positionalArguments(), seconds, only);
        if (!strips)
            return fail(io::errorText(strips.error()));
        QTextStream(stdout) << QString::fromStdString(stripTable(*strips, seconds))
                            << QString::fromStdString(nestingTable(nestingCosts(runs, kernel)));
        return 0;
    }
    if (parser.isSet(QStringLiteral("values"))) {
        const auto adjusted = adjustCosts(parser.positionalArguments(), kernel);
        if (!adjusted)
            return fail(io::errorText(adjusted.error()));
        QTextStream(stdout) << QString::fromStdString(valueTable(valueCosts(runs, kernel)))
                            << QString::fromStdString(adjustTable(*adjusted));
        return 0;
    }
    std::optional<Peer> peer;
    if (parser.isSet(QStringLiteral("peer"))) {
        const Result<Peer> read = readPeer(parser.value(QStringLiteral("peer")));
        if (!read)
            return fail(io::errorText(read.error()));
        peer = *read;
    }
    std::vector<Case> cases;
    for (const QString &folder : parser.positionalArguments()) {
        const std::vector<Case> more = casesIn(folder);
        cases.insert(cases.end(), more.begin(), more.end());
    }
    const QTemporaryDir folder;
    const std::vector<Case> generated = generatedCases(folder.path());
    cases.insert(cases.end(), generated.begin(), generated.end());
    const auto isWanted = [&](const std::string &name) {
        return only.isEmpty() || std::any_of(only.begin(), only.end(), [&](const QString &text) {
                   return QString::fromStdString(name).contains(text);
               });
    };

    if (parser.isSet(QStringLiteral("strength"))) {
        const auto rows = rowsOf<StrengthCost>(cases, isWanted, kernel, [runs](const Case &item) {
            return strengthCost(item.name, item.path, runs, item.edited);
        });
        if (!rows)
            return fail(io::errorText(rows.error()));
        QTextStream(stdout) << QString::fromStdString(strengthTables(*rows, peer));
        return 0;
    }
    if (parser.isSet(QStringLiteral("fabrication"))) {
        const auto rows =
            rowsOf<FabricationCost>(cases, isWanted, kernel, [runs](const Case &item) {
                return fabricationCost(item.name, item.path, runs);
            });
        if (!rows)
            return fail(io::errorText(rows.error()));
        QTextStream(stdout) << QString::fromStdString(fabricationTable(*rows));
        return 0;
    }
    const auto measured = rowsOf<Measurement>(cases, isWanted, kernel, [runs](const Case &item) {
        return measure(item.name, item.path, runs, item.edited);
    });
    if (!measured)
        return fail(io::errorText(measured.error()));
    const std::vector<Measurement> &rows = *measured;
    const std::vector<DrawingCost> drawings = drawingCosts(isWanted, kernel);
    QTextStream(stdout) << QString::fromStdString(tables(rows, peer) + drawingTable(drawings));
    if (parser.isSet(QStringLiteral("json"))) {
        const auto written = io::writeFile(parser.value(QStringLiteral("json")), json(rows, peer));
        if (!written)
            return fail(io::errorText(written.error()));
    }
    return 0;
}
