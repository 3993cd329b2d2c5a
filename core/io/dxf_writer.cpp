#include "core/io/dxf_writer.h"

#include "core/fabrication/cutting_order.h"
#include "core/geometry/arc_fit.h"
#include "core/io/stacked_sheets.h"

#include <QtCore/QCoreApplication>

#include <array>
#include <vector>

namespace fff::io {

namespace {

constexpr const char *kDxfOption = "dxf";

std::string_view layerName(Purpose purpose)
{
    switch (purpose) {
    case Purpose::Engrave:
    case Purpose::Number:
        return "ENGRAVE";
    case Purpose::Score:
        return "SCORE";
    case Purpose::InnerCut:
        return "CUT_INNER";
    case Purpose::OuterCut:
        return "CUT";
    case Purpose::Guide:
        return "GUIDE";
    }
    return "0"; // not reached: every purpose is above
}

/// The nearest of AutoCAD's first colours; black is white there, on a dark ground.
int colourIndex(std::uint32_t colour)
{
    constexpr std::array<std::uint32_t, 7> kColours = {0xFF0000, 0xFFFF00, 0x00FF00, 0x00FFFF,
                                                       0x0000FF, 0xFF00FF, 0x000000};
    const auto away = [colour](std::uint32_t other) {
        int squares = 0;
        for (const int shift : {0, 8, 16}) {
            const int difference =
                static_cast<int>(colour >> shift & 0xFF) - static_cast<int>(other >> shift & 0xFF);
            squares += difference * difference;
        }
        return squares;
    };
    std::size_t best = 0;
    for (std::size_t i = 1; i < kColours.size(); ++i)
        if (away(kColours[i]) < away(kColours[best]))
            best = i;
    return static_cast<int>(best) + 1;
}

std::vector<DxfLayer> layersFor(const Machine &machine)
{
    std::vector<DxfLayer> layers;
    for (const Purpose purpose :
         {Purpose::OuterCut, Purpose::InnerCut, Purpose::Score, Purpose::Engrave, Purpose::Guide})
        layers.push_back({layerName(purpose), colourIndex(machine.of(purpose).colour)});
    return layers;
}

/// A line as it is written.
struct DxfLine
{
    Purpose purpose;
    ArcPath path;
};

ArcPath moved(ArcPath path, const Vec2 &by)
{
    path.start += by;
    for (ArcStep &step : path.steps)
        step.end += by;
    return path;
}

DxfLine guide(std::span<const Vec2> corners)
{
    ArcPath path{corners.front(), {}, true};
    for (const Vec2 &corner : corners.subspan(1))
        path.steps.push_back({corner});
    path.steps.push_back({corners.front()});
    return {Purpose::Guide, std::move(path)};
}

std::vector<DxfLine> linesOf(const CuttingDrawing &drawing)
{
    std::vector<DxfLine> lines;
    const StackedSheets stack = stacked(drawing);
    for (std::size_t i = 0; i < drawing.sheets.size(); ++i) {
        const CuttingSheet &sheet = drawing.sheets[i];
        if (hasEdges(drawing, sheet))
            for (const Polygon &ring : edgesOf(sheet)) {
                DxfLine edge = guide(ring);
                edge.path = moved(std::move(edge.path), stack.corners[i]);
                lines.push_back(std::move(edge));
            }
        for (const ToolLine &line : inCuttingOrder(sheet)) {
            ArcPath path = moved(arcsAlong(line.curves, line.isClosed), stack.corners[i]);
            if (!path.steps.empty())
                lines.push_back({line.purpose, std::move(path)});
        }
    }
    if (hasBar(drawing))
        lines.push_back(guide(cornersOf(stack.reference, kReferenceSize)));
    return lines;
}

/// Visit(vertex, bulge of the edge behind it). The start of a closed line is not repeated.
template <class Visit>
void forVertices(const ArcPath &path, const Visit &visit)
{
    const std::size_t count = path.steps.size() + (path.isClosed ? 0 : 1);
    for (std::size_t i = 0; i < count; ++i)
        visit(i == 0 ? path.start : path.steps[i - 1].end,
              i < path.steps.size() ? path.steps[i].bulge : 0.0);
}

void addLight(const DxfLine &line, DxfText &out)
{
    out.entity("LWPOLYLINE", layerName(line.purpose), "AcDbPolyline");
    out.group(90, static_cast<int>(line.path.steps.size()) + (line.path.isClosed ? 0 : 1));
    out.group(70, line.path.isClosed ? 1 : 0);
    forVertices(line.path, [&out](const Vec2 &p, double bulge) {
        out.group(10, p.x());
        out.group(20, p.y());
        if (bulge != 0.0)
            out.group(42, bulge);
    });
}

void addOld(const DxfLine &line, DxfText &out)
{
    const std::string_view layer = layerName(line.purpose);
    out.entity("POLYLINE", layer, {});
    out.group(66, 1); // vertices follow
    for (const int code : {10, 20, 30})
        out.group(code, 0.0);
    out.group(70, line.path.isClosed ? 1 : 0);
    forVertices(line.path, [&](const Vec2 &p, double bulge) {
        out.entity("VERTEX", layer, {});
        out.group(10, p.x());
        out.group(20, p.y());
        out.group(30, 0.0);
        if (bulge != 0.0)
            out.group(42, bulge);
    });
    out.entity("SEQEND", layer, {});
}

/// ASCII, and on one line, of which readers take no more than 255 characters.
std::string plainWords(const std::string &text)
{
    constexpr std::size_t kMost = 120;
    std::string plain = text.substr(0, kMost);
    for (char &c : plain)
        if (c < ' ' || c > '~')
            c = '_';
    return plain;
}

std::vector<std::string> commentsOn(const CuttingDrawing &drawing)
{
    std::vector<std::string> comments = {"FlatFitFab " FFF_VERSION ", millimetres",
                                         drawing.isKerfApplied ? "kerf already applied"
                                                               : "kerf not applied"};
    for (const Stock &stock : drawing.stocks) {
        DrawingText numbers(100);
        numbers << plainWords(stock.name) << ", " << stock.thickness << " mm, kerf " << stock.kerf
                << " mm";
        comments.push_back(numbers.take());
    }
    return comments;
}

} // namespace

std::string writeDxf(const CuttingDrawing &drawing, DxfVersion version)
{
    const std::vector<DxfLine> lines = linesOf(drawing);
    Box2 extents;
    std::size_t length = 8000;
    for (const DxfLine &line : lines) {
        extents.extend(line.path.bounds());
        length += 120 + (version == DxfVersion::R12 ? 75 : 45) * line.path.steps.size();
    }
    if (extents.isEmpty())
        extents.extend(Vec2(Vec2::Zero()));
    DxfText out(version, commentsOn(drawing), extents, layersFor(machineOf(drawing)), length);
    for (const DxfLine &line : lines)
        if (version == DxfVersion::R12)
            addOld(line, out);
        else
            addLight(line, out);
    return out.take();
}

const Format &dxfFormat()
{
    static const Format format = {
        .key = "dxf",
        .suffixes = {"dxf"},
        .title = QT_TRANSLATE_NOOP("Format", "DXF, true to size"),
        .titleOfSheets = QT_TRANSLATE_NOOP("Format", "DXF, one for each sheet"),
        .help = QT_TRANSLATE_NOOP("CommandLine", "DXF with layers by purpose"),
        .options = {{.name = kDxfOption,
                     .value = "VERSION",
                     .help = QT_TRANSLATE_NOOP("CommandLine",
                                               "Version of a DXF file: r2000 or r12 (r2000)."),
                     .choices = {{.name = "r2000"},
                                 {.name = "r12",
                                  .title =
                                      QT_TRANSLATE_NOOP("Format", "DXF for old programs, R12")}}}},
        .writeCutting = [](const CuttingDrawing &drawing,
                           const FormatValues &values) -> Result<std::string> {
            return writeDxf(drawing, static_cast<DxfVersion>(valueOf(values, kDxfOption, 0.0)));
        }};
    return format;
}

} // namespace fff::io
