#include "tests/bench/drawing_growth.h"

#include "core/interaction/drawing_editing.h"
#include "core/interaction/interaction.h"
#include "core/io/document_file.h"
#include "core/io/svg_reader.h"
#include "core/model/edits.h"
#include "core/operations/evaluate.h"
#include "core/session/session_commands.h"
#include "core/session/session_host.h"
#include "tests/bench/growth_table.h"
#include "tests/bench/stopwatch.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTextStream>

#include <cmath>
#include <cstdio>
#include <numbers>

namespace fff::bench {

namespace {

constexpr double kSide = 10'000.0; // mm, of the drawing and of what it is put on

struct DrawnCase
{
    std::string name;
    int size = 0;
    std::string svg;
};

std::string svgOf(const std::string &elements)
{
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"10000mm\" height=\"10000mm\" "
           "viewBox=\"0 0 10000 10000\">" +
           elements + "</svg>";
}

std::string rectangleText(double x, double y, double width, double height)
{
    char text[160];
    std::snprintf(text, sizeof text,
                  "<rect x=\"%.4f\" y=\"%.4f\" width=\"%.4f\" height=\"%.4f\"/>\n", x, y, width,
                  height);
    return text;
}

std::string besideEachOther(int count)
{
    const int columns = static_cast<int>(std::ceil(std::sqrt(count)));
    const double step = 0.9 * kSide / columns;
    std::string text;
    for (int i = 0; i < count; ++i)
        text += rectangleText(100.0 + (i % columns) * step, 100.0 + (i / columns) * step,
                              0.6 * step, 0.4 * step);
    return svgOf(text);
}

std::string inEachOther(int count)
{
    const double step = 0.4 * kSide / count;
    std::string text;
    for (int i = 0; i < count; ++i)
        text += rectangleText(100.0 + i * step, 100.0 + i * step, 0.9 * kSide - 2.0 * i * step,
                              0.9 * kSide - 2.0 * i * step);
    return svgOf(text);
}

/// Once round, in waves. curved: three corners a curve.
std::string pathOf(int corners, bool curved)
{
    std::string text = "<path d=\"M";
    char place[80];
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners;
        const double radius = 0.4 * kSide * (1.0 + 0.1 * std::sin(40.0 * angle));
        std::snprintf(place, sizeof place, "%.4f %.4f\n", 0.5 * kSide + radius * std::cos(angle),
                      0.5 * kSide + radius * std::sin(angle));
        const bool isBegun = curved ? i % 3 == 1 && i + 2 < corners : i > 0;
        if (isBegun)
            text += curved ? 'C' : 'L';
        if (!curved || i == 0 || (i - 1) / 3 * 3 + 3 < corners)
            text += place;
    }
    return svgOf(text + "Z\"/>");
}

std::vector<DrawnCase> cases(const std::function<bool(const std::string &)> &isWanted)
{
    std::vector<DrawnCase> all;
    const auto add = [&](const char *what, int size, const auto &make) {
        const std::string name = std::string("drawing of ") + std::to_string(size) + ' ' + what;
        if (isWanted(name))
            all.push_back({name, size, make(size)});
    };
    for (const int size : {1'000, 4'000, 16'000, 64'000})
        add("rectangles", size, besideEachOther);
    for (const int size : {1'000, 4'000, 16'000, 64'000})
        add("rectangles in each other", size, inEachOther);
    for (const int size : {62'500, 250'000, 1'000'000})
        add("corners", size, [](int corners) { return pathOf(corners, false); });
    for (const int size : {62'500, 250'000, 1'000'000})
        add("corners of curves", size, [](int corners) { return pathOf(corners, true); });
    return all;
}

/// A document with one section on which there is room for all of it.
Document canvas()
{
    NewSection section;
    section.name = "Canvas";
    section.shape =
        Shape::make(
            Contour::fromPolygon({{0.0, 0.0}, {kSide, 0.0}, {kSide, kSide}, {0.0, kSide}}).value(),
            {})
            .value();
    return addSection(newDocument(), std::move(section)).value();
}

double commandCost(const QString &path)
{
    Session session;
    SessionHost host(session);
    Interaction interaction(host);
    QObject::connect(&session, &Session::modelChanged, &session,
                     [&interaction] { interaction.modelChanged(); });
    session.reset(newDocument());
    CommandRegistry commands;
    registerSessionCommands(commands, session, interaction);
    double milliseconds = 0.0;
    timed(milliseconds, [&] {
        return commands.run("section.importSections", {{"path", path.toStdString()}}).has_value();
    });
    return milliseconds;
}

DrawingCost costOf(const DrawnCase &item, const QString &path)
{
    DrawingCost cost{item.name, item.size};
    const Result<io::SvgDrawing> read = timed(cost.read, [&path] { return io::readDrawing(path); });
    if (!read)
        return cost;
    Drawing drawing{{}, "drawing"};
    for (const io::SvgDrawing::Line &line : read->lines)
        drawing.lines.push_back(line.path);
    const Model empty = evaluate(newDocument()), one = evaluate(canvas());
    const SectionRef section = one.document.sections.front()->id;
    timed(cost.sections, [&] { return drawingSections(empty, drawing, {}); });
    timed(cost.holes, [&] { return drawingHoles(one, section, drawing); });
    timed(cost.marks, [&] { return drawingMark(one, section, drawing, Mark::Kind::Engraved); });
    cost.command = commandCost(path);
    return cost;
}

constexpr std::array<GrowthColumn<DrawingCost>, 5> kColumns{{{"read", &DrawingCost::read},
                                                             {"sections", &DrawingCost::sections},
                                                             {"holes", &DrawingCost::holes},
                                                             {"marks", &DrawingCost::marks},
                                                             {"command", &DrawingCost::command}}};

} // namespace

std::vector<DrawingCost> drawingCosts(const std::function<bool(const std::string &)> &isWanted,
                                      const std::optional<Kernel> &kernel)
{
    const QTemporaryDir folder;
    std::vector<DrawingCost> costs;
    for (const DrawnCase &item : cases(isWanted)) {
        const QString path = folder.filePath(QStringLiteral("drawing.svg"));
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly) ||
            file.write(item.svg.data(), static_cast<qint64>(item.svg.size())) < 0)
            return costs;
        file.close();
        const double before = kernel ? kernel->run() : 0.0;
        costs.push_back(costOf(item, path));
        costs.back().kernel = kernel ? 0.5 * (before + kernel->run()) : 0.0;
        QTextStream(stderr) << QString::fromStdString(item.name) << Qt::endl;
    }
    return costs;
}

std::string drawingTable(const std::vector<DrawingCost> &costs)
{
    return growthTable("Drawings", kColumns, costs);
}

} // namespace fff::bench
