#include "core/io/svg_writer.h"

#include "core/io/drawing_text.h"

#include <QString>
#include <algorithm>
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

void addLabel(const CuttingPart &part, const Transform &transform, DrawingText &out)
{
    std::string_view start = "M ";
    part.forLabel([&](bool isFirst, const Vec2 &p) {
        out.addPoint<Decimals::Three>(isFirst ? std::exchange(start, " M ") : " L ", transform(p));
    });
}

void addRectangle(const Vec2 &corner, const Vec2 &size, DrawingText &out)
{
    out << "    <rect x=\"" << corner.x() << "\" y=\"" << corner.y() << "\" width=\"" << size.x()
        << "\" height=\"" << size.y() << "\" stroke=\"" << kGuide << "\"/>\n";
}

struct Look
{
    std::string_view colour;
    bool isCut = false;
};

Look lookOf(LineRole role)
{
    switch (role) {
    case LineRole::Engrave:
        return {kEngraved};
    case LineRole::Score:
        return {kScored};
    case LineRole::InnerCut:
    case LineRole::OuterCut:
        return {kCut, true};
    }
    return {kCut, true}; // not reached: every role is above
}

void addPart(const CuttingPart &part, const Transform &transform, DrawingText &out)
{
    const auto path = [&](std::string_view colour, const auto &addShape) {
        out << "      <path stroke=\"" << colour << "\" d=\"";
        addShape();
        out << "\"/>\n";
    };
    out << "    <g id=\"part-" << std::to_string(part.number()) << "\">\n      <title>"
        << escaped(part.name()) << "</title>\n";
    if (part.hasLabel())
        path(kNumbers, [&] { addLabel(part, transform, out); });
    part.forLines([&](const CuttingLine &line) {
        const Look look = lookOf(line.role());
        path(look.colour, [&] {
            if (look.isCut)
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
    if (drawing.hasReference)
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
    double top = 0.0;
    for (const CuttingSheet &sheet : drawing.sheets) {
        out << "  <g id=\"sheet-" << std::to_string(sheet.number)
            << "\" fill=\"none\" stroke-width=\"0.05\">\n";
        if (drawing.sheets.size() > 1)
            addRectangle({0.0, top}, sheet.size, out);
        for (const CuttingPart &part : sheet.parts)
            addPart(part, Transform(top + sheet.size.y()), out);
        out << "  </g>\n";
        top += sheet.size.y() + kSheetGap;
    }
    if (drawing.hasReference) {
        out << "  <g id=\"reference-100mm-10mm\" fill=\"none\" stroke-width=\"0.05\">\n";
        addRectangle({0.0, top}, kReferenceSize, out);
        out << "  </g>\n";
    }
    out << "</svg>\n";
    return out.take();
}

} // namespace fff::io
