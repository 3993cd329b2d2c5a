#include "core/io/svg_writer.h"

#include "core/base/tolerances.h"
#include "core/io/drawing_text.h"

#include <QString>
#include <algorithm>
#include <set>
#include <utility>

namespace fff::io {

namespace {

constexpr double kSheetGap = 10.0;
const Vec2 kReferenceSize(100.0, 10.0);
constexpr std::string_view kCut = "#ff0000";
constexpr std::string_view kNumbers = "#0000ff";
constexpr std::string_view kEngraved = "#000000";
constexpr std::string_view kScored = "#00ff00";
constexpr std::string_view kGuide = "#ffcc00";

bool isPlainText(const std::string &text)
{
    return std::all_of(text.begin(), text.end(), [](char c) {
        return c >= ' ' && c <= '~' && c != '&' && c != '<' && c != '>' && c != '"';
    });
}

/// For text and attributes. What is no UTF-8 or not allowed in XML becomes U+FFFD.
std::string escaped(const std::string &text)
{
    if (isPlainText(text))
        return text;
    QString result;
    for (const QChar c : QString::fromStdString(text)) {
        if (c == QLatin1Char('&'))
            result += QStringLiteral("&amp;");
        else if (c == QLatin1Char('<'))
            result += QStringLiteral("&lt;");
        else if (c == QLatin1Char('>'))
            result += QStringLiteral("&gt;");
        else if (c == QLatin1Char('"'))
            result += QStringLiteral("&quot;");
        else if ((c < QLatin1Char(' ') && !c.isSpace()) || c.unicode() >= 0xFFFE)
            result += QChar(QChar::ReplacementCharacter);
        else
            result += c;
    }
    return result.toStdString();
}

/// From a part's coordinates to those of the drawing.
class Transform
{
public:
    Transform(const Placement &placement, double sheetBottom)
        : m_placement(placement), m_bottom(sheetBottom)
    {
    }

    Vec2 operator()(const Vec2 &p) const
    {
        const Vec2 onSheet = m_placement.apply(p);
        return {onSheet.x(), m_bottom - onSheet.y()};
    }

private:
    const Placement &m_placement;
    double m_bottom; // y of the sheet's lower edge in the drawing
};

/// A segment of a path from where the one before ended.
void addCurve(const CubicBezier &curve, const Transform &transform, DrawingText &out)
{
    out.addPoint<Decimals::Six>(" C ", transform(curve.p1));
    out.addPoint<Decimals::Six>(" ", transform(curve.p2));
    out.addPoint<Decimals::Six>(" ", transform(curve.p3));
}

void addClosed(const Contour &contour, const Transform &transform, DrawingText &out)
{
    out.addPoint<Decimals::Six>("M ", transform(contour.points().front()));
    const int count = contour.segmentCount();
    for (int i = 0; i < count; ++i) {
        const CubicBezier curve = contour.segment(i);
        if (!curve.isStraight(kClipGrid)) {
            addCurve(curve, transform, out);
        } else if (i + 1 < count) { // Z draws the last one
            out.addPoint<Decimals::Six>(" L ", transform(curve.p3));
        }
    }
    out << " Z";
}

void addLine(const CurvePath &path, const Transform &transform, DrawingText &out)
{
    out.addPoint<Decimals::Six>("M ", transform(path.points().front()));
    for (int i = 0; i < path.segmentCount(); ++i) {
        const CubicBezier curve = path.segment(i);
        if (curve.isStraight(kClipGrid))
            out.addPoint<Decimals::Six>(" L ", transform(curve.p3));
        else
            addCurve(curve, transform, out);
    }
    if (path.isClosed())
        out << " Z";
}

void addOpen(const Strokes &strokes, const Transform &transform, DrawingText &out)
{
    std::string_view start = "M ";
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        std::string_view before = std::exchange(start, " M ");
        for (const Vec2 &p : strokes[i])
            out.addPoint<Decimals::Three>(std::exchange(before, " L "), transform(p));
    }
}

void addRectangle(const Vec2 &corner, const Vec2 &size, DrawingText &out)
{
    out << "    <rect x=\"" << corner.x() << "\" y=\"" << corner.y() << "\" width=\"" << size.x()
        << "\" height=\"" << size.y() << "\" stroke=\"" << kGuide << "\"/>\n";
}

void addPart(const Part &part, const Engraving *engraving, const Transform &transform,
             const Model &model, DrawingText &out)
{
    const auto path = [&](std::string_view colour, const auto &addShape) {
        out << "      <path stroke=\"" << colour << "\" d=\"";
        addShape();
        out << "\"/>\n";
    };
    const Section &section = *model.section(static_cast<std::size_t>(part.section));
    out << "    <g id=\"part-" << std::to_string(part.number) << "\">\n      <title>"
        << escaped(section.name) << "</title>\n";
    if (engraving && !engraving->strokes.isEmpty())
        path(kNumbers, [&] { addOpen(engraving->strokes, transform, out); });
    if (engraving) {
        for (const CurvePath &line : engraving->lines.engraved)
            path(kEngraved, [&] { addLine(line, transform, out); });
        for (const CurvePath &line : engraving->lines.scored)
            path(kScored, [&] { addLine(line, transform, out); });
    }
    for (const Contour &hole : part.outline.holes)
        path(kCut, [&] { addClosed(hole, transform, out); });
    path(kCut, [&] { addClosed(part.outline.outer, transform, out); });
    out << "    </g>\n";
}

void addMetadata(const Layout &layout, const Model &model, const SvgOptions &options,
                 DrawingText &out)
{
    std::set<StockId> used;
    for (const Sheet &sheet : layout.sheets)
        used.insert(sheet.stock);
    out << "  <metadata>\n    <fff:cutting xmlns:fff=\"urn:flatfitfab:cutting\" "
           "version=\"" FFF_VERSION "\" kerf-applied=\""
        << (options.kerfApplied ? "yes" : "no") << "\">\n";
    for (const auto &stock : model.document.stocks) {
        if (!used.contains(stock->id))
            continue;
        out << "      <fff:stock name=\"" << escaped(stock->name) << "\" thickness=\""
            << stock->thickness << "\" clearance=\"" << stock->clearance << "\" kerf=\""
            << stock->kerf << "\" unit=\"mm\"/>\n";
    }
    out << "    </fff:cutting>\n  </metadata>\n";
}

/// Control points; of straight segments fewer are written.
std::size_t pointCount(const CurvedRegion &outline)
{
    std::size_t count = outline.outer.points().size();
    for (const Contour &hole : outline.holes)
        count += hole.points().size();
    return count;
}

/// Width and height of the drawing.
Vec2 drawingSize(const Layout &layout, const SvgOptions &options)
{
    Vec2 size = Vec2::Zero();
    const auto append = [&size](const Vec2 &s) {
        size.y() += s.y() + (size.y() > 0.0 ? kSheetGap : 0.0);
        size.x() = std::max(size.x(), s.x());
    };
    for (const Sheet &sheet : layout.sheets)
        append(sheet.size);
    if (options.hasReference)
        append(kReferenceSize);
    return size;
}

/// About as much text as a drawing takes, rather more: so that it is not moved while it grows.
std::size_t estimatedLength(const Layout &layout, const std::vector<Part> &parts,
                            const std::vector<Engraving> &engravings)
{
    constexpr std::size_t kHead = 2000, kPart = 200, kCutPoint = 24, kStrokePoint = 18, kLine = 40;
    std::size_t length = kHead;
    for (const Sheet &sheet : layout.sheets) {
        for (const Placement &placement : sheet.placements) {
            const auto part = static_cast<std::size_t>(placement.part);
            length += kPart + kCutPoint * pointCount(parts[part].outline);
            if (engravings.empty())
                continue;
            const Engraving &engraving = engravings[part];
            length += kStrokePoint * engraving.strokes.pointCount();
            for (const auto *lines : {&engraving.lines.engraved, &engraving.lines.scored})
                for (const CurvePath &line : *lines)
                    length += kLine + kCutPoint * line.points().size();
        }
    }
    return length;
}

} // namespace

std::string writeSvg(const Layout &layout, const std::vector<Part> &parts,
                     const std::vector<Engraving> &engravings, const Model &model,
                     const SvgOptions &options)
{
    const Vec2 size = drawingSize(layout, options);
    DrawingText out(estimatedLength(layout, parts, engravings));
    out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
           "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\""
        << size.x() << "mm\" height=\"" << size.y() << "mm\" viewBox=\"0 0 " << size.x() << " "
        << size.y() << "\">\n";
    addMetadata(layout, model, options, out);
    double top = 0.0;
    for (std::size_t i = 0; i < layout.sheets.size(); ++i) {
        const Sheet &sheet = layout.sheets[i];
        out << "  <g id=\"sheet-" << std::to_string(static_cast<int>(i) + options.firstSheet)
            << "\" fill=\"none\" stroke-width=\"0.05\">\n";
        if (layout.sheets.size() > 1)
            addRectangle({0.0, top}, sheet.size, out);
        for (const Placement &placement : sheet.placements) {
            const auto part = static_cast<std::size_t>(placement.part);
            addPart(parts[part], engravings.empty() ? nullptr : &engravings[part],
                    Transform(placement, top + sheet.size.y()), model, out);
        }
        out << "  </g>\n";
        top += sheet.size.y() + kSheetGap;
    }
    if (options.hasReference) {
        out << "  <g id=\"reference-100mm-10mm\" fill=\"none\" stroke-width=\"0.05\">\n";
        addRectangle({0.0, top}, kReferenceSize, out);
        out << "  </g>\n";
    }
    out << "</svg>\n";
    return out.take();
}

} // namespace fff::io
