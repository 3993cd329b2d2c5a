#include "core/io/lightburn_writer.h"

#include "core/fabrication/cutting_order.h"
#include "core/io/drawing_text.h"
#include "core/io/stacked_sheets.h"
#include "core/io/xml_text.h"

#include <QtCore/QCoreApplication>

#include <map>
#include <utility>

namespace fff::io {

namespace {

constexpr double kPercent = 100.0;

/// In the order in which layers are burnt; guides are not.
constexpr std::array<std::pair<Purpose, std::string_view>, 5> kBurntInTurn = {
    {{Purpose::Engrave, "Engrave"},
     {Purpose::Number, "Numbers"},
     {Purpose::Score, "Score"},
     {Purpose::InnerCut, "Inner cuts"},
     {Purpose::OuterCut, "Outer cuts"}}};

void addSetting(const Machine::Process &process, std::string_view name, int priority,
                DrawingText &out)
{
    const auto value = [&out](std::string_view key, double number) {
        out << "        <" << key << " Value=\"" << number << "\"/>\n";
    };
    out << "    <CutSetting type=\"Cut\">\n";
    value("index", process.layer);
    out << "        <name Value=\"" << name << "\"/>\n";
    value("maxPower", kPercent * process.power);
    value("maxPower2", kPercent * process.power);
    value("speed", process.speed);
    value("priority", priority);
    out << "    </CutSetting>\n";
}

/// One of each layer, under its first purpose's name.
void addSettings(const Machine &machine, DrawingText &out)
{
    std::map<int, int> priorities;
    for (const auto &[purpose, name] : kBurntInTurn) {
        const Machine::Process &process = machine.of(purpose);
        const auto [known, isNew] =
            priorities.try_emplace(process.layer, static_cast<int>(priorities.size()));
        if (isNew)
            addSetting(process, name, known->second, out);
    }
}

/// The vertex of an edge that nothing bends.
constexpr std::string_view kNoLeaving = "c0x1", kNoArriving = "c1x1";

void addPoint(std::string_view before, const Vec2 &p, DrawingText &out)
{
    out.addPoint<Decimals::Six>(before, p);
}

void addControl(std::string_view x, std::string_view y, const Vec2 &p, DrawingText &out)
{
    out << x << p.x() << y << p.y();
}

bool isEdge(const CubicBezier &curve)
{
    return curve.isStraight(2.0 * kClipGrid);
}

void addShape(const ToolLine &line, int layer, const Vec2 &corner, DrawingText &out)
{
    const std::size_t curves = line.curves.size(), vertices = curves + (line.isClosed ? 0 : 1);
    out << "    <Shape Type=\"Path\" CutIndex=\"" << std::to_string(layer)
        << "\">\n        <XForm>1 0 0 1 0 0</XForm>\n        <VertList>";
    for (std::size_t i = 0; i < vertices; ++i) {
        const CubicBezier *leaving = i < curves ? &line.curves[i] : nullptr;
        const CubicBezier *arriving = i > 0           ? &line.curves[i - 1]
                                      : line.isClosed ? &line.curves.back()
                                                      : nullptr;
        addPoint("V", corner + (leaving ? leaving->p0 : arriving->p3), out);
        if (leaving && !isEdge(*leaving))
            addControl("c0x", "c0y", corner + leaving->p1, out);
        else
            out << kNoLeaving;
        if (arriving && !isEdge(*arriving))
            addControl("c1x", "c1y", corner + arriving->p2, out);
        else
            out << kNoArriving;
    }
    out << "</VertList>\n        <PrimList>";
    for (std::size_t i = 0; i < curves; ++i)
        out << (isEdge(line.curves[i]) ? "L" : "B") << std::to_string(i) << " "
            << std::to_string((i + 1) % vertices);
    out << "</PrimList>\n    </Shape>\n";
}

void addFrame(std::span<const Vec2> corners, const Vec2 &at, int layer, DrawingText &out)
{
    ToolLine frame{Purpose::Guide, 0, {}, true};
    for (std::size_t i = 0; i < corners.size(); ++i)
        frame.curves.push_back(CubicBezier::line(corners[i], corners[(i + 1) % corners.size()]));
    addShape(frame, layer, at, out);
}

void addNotes(const CuttingDrawing &drawing, DrawingText &out)
{
    out << "    <Notes ShowOnLoad=\"0\" Notes=\"FlatFitFab " FFF_VERSION "; kerf "
        << (drawing.isKerfApplied ? "already applied" : "not applied");
    for (const Stock &stock : drawing.stocks)
        out << "; " << escaped(stock.name) << ", " << stock.thickness << " mm, kerf " << stock.kerf
            << " mm";
    out << "\"/>\n";
}

} // namespace

std::string writeLightBurn(const CuttingDrawing &drawing)
{
    const Machine &machine = machineOf(drawing);
    const StackedSheets stack = stacked(drawing);
    std::size_t points = 0;
    for (const CuttingSheet &sheet : drawing.sheets)
        for (const CuttingPart &part : sheet.parts)
            points += part.pointCount();
    DrawingText out(4000 + 40 * points);
    out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
           "<LightBurnProject AppVersion=\"1.2.01\" FormatVersion=\"1\" MaterialHeight=\"0\" "
           "MirrorX=\"False\" MirrorY=\"False\">\n";
    addSettings(machine, out);
    const int guides = machine.of(Purpose::Guide).layer;
    for (std::size_t i = 0; i < drawing.sheets.size(); ++i) {
        const CuttingSheet &sheet = drawing.sheets[i];
        if (hasEdges(drawing, sheet))
            for (const Polygon &ring : edgesOf(sheet))
                addFrame(ring, stack.corners[i], guides, out);
        for (const ToolLine &line : inCuttingOrder(sheet))
            addShape(line, machine.of(line.purpose).layer, stack.corners[i], out);
    }
    if (hasBar(drawing))
        addFrame(cornersOf(stack.reference, kReferenceSize), Vec2::Zero(), guides, out);
    addNotes(drawing, out);
    out << "</LightBurnProject>\n";
    return out.take();
}

const Format &lightBurnFormat()
{
    static const Format format = {.key = "lbrn2",
                                  .suffixes = {"lbrn2"},
                                  .program = "LightBurn",
                                  .title = QT_TRANSLATE_NOOP("Format", "LightBurn project"),
                                  .titleOfSheets =
                                      QT_TRANSLATE_NOOP("Format", "LightBurn, one for each sheet"),
                                  .help = QT_TRANSLATE_NOOP("CommandLine", "a LightBurn project"),
                                  .writeCutting = [](const CuttingDrawing &drawing,
                                                     const FormatValues &) -> Result<std::string> {
                                      return writeLightBurn(drawing);
                                  }};
    return format;
}

} // namespace fff::io
