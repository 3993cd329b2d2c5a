#include "core/io/svg_writer.h"

#include "core/fabrication/cutting_order.h"
#include "core/fabrication/joint_colours.h"
#include "core/fabrication/machine.h"
#include "core/io/drawing_text.h"
#include "core/io/stacked_sheets.h"
#include "core/io/xml_text.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace fff::io {

namespace {

/// From a sheet's coordinates to those of the drawing.
class Transform
{
public:
    /// sheetBottom  y of the sheet's lower edge in the drawing
    explicit Transform(double sheetBottom) : m_bottom(sheetBottom) {}

    Vec2 operator()(const Vec2 &p) const { return {p.x(), m_bottom - p.y()}; }

private:
    double m_bottom;
};

/// A segment of a path from where the one before ended.
void addCurve(const CubicBezier &curve, const Transform &transform, DrawingText &out)
{
    out.addPoint<Decimals::Six>(" C ", transform(curve.p1));
    out.addPoint<Decimals::Six>(" ", transform(curve.p2));
    out.addPoint<Decimals::Six>(" ", transform(curve.p3));
}

/// Z draws a last edge that is straight.
void addCut(const CuttingLine &line, const Transform &transform, DrawingText &out)
{
    out.addPoint<Decimals::Six>("M ", transform(line.start()));
    const int count = line.segmentCount();
    for (int i = 0; i < count; ++i) {
        if (!line.isStraight(i))
            addCurve(line.segment(i), transform, out);
        else if (i + 1 < count)
            out.addPoint<Decimals::Six>(" L ", transform(line.end(i)));
    }
    out << " Z";
}

void addDrawn(const CuttingLine &line, const Transform &transform, DrawingText &out)
{
    out.addPoint<Decimals::Six>("M ", transform(line.start()));
    for (int i = 0; i < line.segmentCount(); ++i) {
        if (line.isStraight(i))
            out.addPoint<Decimals::Six>(" L ", transform(line.end(i)));
        else
            addCurve(line.segment(i), transform, out);
    }
    if (line.isClosed())
        out << " Z";
}

void addFollowed(const ToolLine &line, const Transform &transform, DrawingText &out)
{
    out.addPoint<Decimals::Six>("M ", transform(line.start()));
    for (const CubicBezier &curve : line.curves) {
        if (curve.isStraight(2.0 * kClipGrid))
            out.addPoint<Decimals::Six>(" L ", transform(curve.p3));
        else
            addCurve(curve, transform, out);
    }
    if (line.isClosed)
        out << " Z";
}

std::string hexColour(std::uint32_t colour)
{
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text = "#";
    for (int shift = 20; shift >= 0; shift -= 4)
        text += kDigits[colour >> shift & 0xF];
    return text;
}

/// What the lines of each purpose are drawn in.
class SvgColours
{
public:
    explicit SvgColours(const CuttingDrawing &drawing) : m_drawing(drawing)
    {
        for (std::size_t i = 0; i < kPurposes; ++i)
            m_texts[i] = hexColour(machineOf(drawing).processes[i].colour);
    }
    std::string_view of(Purpose purpose) const
    {
        return m_texts[static_cast<std::size_t>(purpose)];
    }
    /// Whether numbers of joints are not simply in that of numbers.
    bool hasJoints() const { return m_drawing.hasJointColours; }
    std::string ofJoint(int joint) const
    {
        return hexColour(colourOf(Purpose::Number, joint, m_drawing));
    }

private:
    const CuttingDrawing &m_drawing;
    std::array<std::string, kPurposes> m_texts;
};

/// One path for all numbers, or one for each where those of joints have colours.
void addLabel(const CuttingPart &part, const Transform &transform, const SvgColours &colours,
              DrawingText &out)
{
    std::optional<int> last; // whose number it is
    part.forLabel([&](bool isFirst, const Vec2 &p, int joint) {
        const bool isNext = isFirst && (!last || (colours.hasJoints() && joint != *last));
        if (isNext) {
            if (last)
                out << "\"/>\n";
            out << "      <path stroke=\"";
            if (colours.hasJoints() && joint > 0)
                out << colours.ofJoint(joint);
            else
                out << colours.of(Purpose::Number);
            out << "\" d=\"";
            last = joint;
        }
        out.addPoint<Decimals::Three>(isNext ? "M " : isFirst ? " M " : " L ", transform(p));
    });
    if (last)
        out << "\"/>\n";
}

void addRectangle(const Vec2 &corner, const Vec2 &size, const SvgColours &colours, DrawingText &out)
{
    out << "    <rect x=\"" << corner.x() << "\" y=\"" << corner.y() << "\" width=\"" << size.x()
        << "\" height=\"" << size.y() << "\" stroke=\"" << colours.of(Purpose::Guide) << "\"/>\n";
}

/// top  of the sheet in the drawing
void addEdges(const CuttingSheet &sheet, double top, const SvgColours &colours, DrawingText &out)
{
    if (!sheet.outline)
        return addRectangle({0.0, top}, sheet.size, colours, out);
    out << "    <path stroke=\"" << colours.of(Purpose::Guide) << "\" d=\"";
    for (const Polygon &ring : edgesOf(sheet)) {
        for (std::size_t i = 0; i < ring.size(); ++i)
            out.addPoint<Decimals::Six>(i == 0 ? "M" : "L",
                                        {ring[i].x(), top + sheet.size.y() - ring[i].y()});
        out << "Z";
    }
    out << "\"/>\n";
}

bool isCut(LineRole role)
{
    return role == LineRole::InnerCut || role == LineRole::OuterCut;
}

/// followed  the part's lines, where they are not as they are drawn; else none
void addPart(const CuttingPart &part, const std::vector<ToolLine> &followed,
             const Transform &transform, const SvgColours &colours, DrawingText &out)
{
    const auto path = [&](Purpose purpose, const auto &addShape) {
        out << "      <path stroke=\"" << colours.of(purpose) << "\" d=\"";
        addShape();
        out << "\"/>\n";
    };
    out << "    <g id=\"part-" << std::to_string(part.number()) << "\">\n      <title>"
        << escaped(part.name()) << "</title>\n";
    addLabel(part, transform, colours, out);
    for (const ToolLine &line : followed)
        if (line.purpose != Purpose::Number)
            path(line.purpose, [&] { addFollowed(line, transform, out); });
    part.forLines([&](const CuttingLine &line) {
        if (!followed.empty())
            return;
        path(purposeOf(line.role()), [&] {
            if (isCut(line.role()))
                addCut(line, transform, out);
            else
                addDrawn(line, transform, out);
        });
    });
    out << "    </g>\n";
}

void addMetadata(const CuttingDrawing &drawing, DrawingText &out)
{
    out << "  <metadata>\n    <fff:cutting xmlns:fff=\"urn:flatfitfab:cutting\" "
           "version=\"" FFF_VERSION "\" kerf-applied=\""
        << (drawing.isKerfApplied ? "yes" : "no") << "\">\n";
    for (const Stock &stock : drawing.stocks)
        out << "      <fff:stock name=\"" << escaped(stock.name) << "\" thickness=\""
            << stock.thickness << "\" clearance=\"" << stock.clearance << "\" kerf=\"" << stock.kerf
            << "\" unit=\"mm\"/>\n";
    out << "    </fff:cutting>\n  </metadata>\n";
}

/// Of each part, where cuts have tabs, leads or neighbours to share with; else empty.
std::vector<std::vector<ToolLine>> followedLines(const CuttingSheet &sheet)
{
    std::vector<std::vector<ToolLine>> lines(sheet.parts.size());
    if (!sheet.finish.isPlain())
        for (ToolLine &line : inCuttingOrder(sheet))
            lines[line.part].push_back(std::move(line));
    return lines;
}

/// Width and height of the drawing.
Vec2 drawingSize(const CuttingDrawing &drawing)
{
    Vec2 size = Vec2::Zero();
    const auto append = [&size](const Vec2 &s) {
        size.y() += s.y() + (size.y() > 0.0 ? kSheetGap : 0.0);
        size.x() = std::max(size.x(), s.x());
    };
    for (const CuttingSheet &sheet : drawing.sheets)
        append(sheet.size);
    if (hasBar(drawing))
        append(kReferenceSize);
    return size;
}

/// About as much text as a drawing takes, rather more: so that it is not moved while it grows.
std::size_t estimatedLength(const CuttingDrawing &drawing)
{
    constexpr std::size_t kHead = 2000, kPart = 240, kPoint = 24;
    std::size_t length = kHead;
    for (const CuttingSheet &sheet : drawing.sheets)
        for (const CuttingPart &part : sheet.parts)
            length += kPart + kPoint * part.pointCount();
    return length;
}

} // namespace

std::string writeSvg(const CuttingDrawing &drawing)
{
    const Vec2 size = drawingSize(drawing);
    DrawingText out(estimatedLength(drawing));
    out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
           "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\""
        << size.x() << "mm\" height=\"" << size.y() << "mm\" viewBox=\"0 0 " << size.x() << " "
        << size.y() << "\">\n";
    addMetadata(drawing, out);
    const Machine &machine = machineOf(drawing);
    const SvgColours colours(drawing);
    double top = 0.0;
    for (const CuttingSheet &sheet : drawing.sheets) {
        out << "  <g id=\"sheet-" << std::to_string(sheet.number)
            << "\" fill=\"none\" stroke-width=\"" << machine.stroke << "\">\n";
        if (hasEdges(drawing, sheet))
            addEdges(sheet, top, colours, out);
        const std::vector<std::vector<ToolLine>> followed = followedLines(sheet);
        for (std::size_t i = 0; i < sheet.parts.size(); ++i)
            addPart(sheet.parts[i], followed[i], Transform(top + sheet.size.y()), colours, out);
        out << "  </g>\n";
        top += sheet.size.y() + kSheetGap;
    }
    if (hasBar(drawing)) {
        out << "  <g id=\"reference-100mm-10mm\" fill=\"none\" stroke-width=\"" << machine.stroke
            << "\">\n";
        addRectangle({0.0, top}, kReferenceSize, colours, out);
        out << "  </g>\n";
    }
    out << "</svg>\n";
    return out.take();
}

} // namespace fff::io
