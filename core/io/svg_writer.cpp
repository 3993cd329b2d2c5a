#include "core/io/svg_writer.h"

#include "core/base/tolerances.h"

#include <QString>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

namespace fff::io {

namespace {

constexpr double kSheetGap = 10.0;
const Vec2 kReferenceSize(100.0, 10.0);
constexpr double kDecimals = 1e6; // coordinates are whole multiples of one over this
constexpr const char *kCut = "#ff0000";
constexpr const char *kEngraving = "#0000ff";
constexpr const char *kGuide = "#ffcc00";

/// Appends the shortest text of the number rounded to kDecimals, without an exponent. By whole
/// numbers: a drawing is made of little else.
void append(std::string &out, double value)
{
    const auto whole = static_cast<std::int64_t>(std::llround(value * kDecimals));
    std::uint64_t rest = static_cast<std::uint64_t>(whole < 0 ? -whole : whole);
    std::array<char, 32> buffer;
    char *const end = buffer.data() + buffer.size();
    char *begin = end;
    bool hasDigits = false; // after the point, from the last one that is not 0
    for (std::int64_t place = 1; place < static_cast<std::int64_t>(kDecimals); place *= 10) {
        const auto digit = static_cast<char>(rest % 10);
        rest /= 10;
        hasDigits |= digit != 0;
        if (hasDigits)
            *--begin = static_cast<char>('0' + digit);
    }
    if (hasDigits)
        *--begin = '.';
    do {
        *--begin = static_cast<char>('0' + static_cast<char>(rest % 10));
        rest /= 10;
    } while (rest != 0);
    if (whole < 0)
        *--begin = '-';
    out.append(begin, end);
}

void append(std::string &out, const Vec2 &p)
{
    append(out, p.x());
    out += ' ';
    append(out, p.y());
}

std::string number(double value)
{
    std::string text;
    append(text, value);
    return text;
}

std::string pair(const Vec2 &p)
{
    return number(p.x()) + ' ' + number(p.y());
}

/// For text and attributes. What is no UTF-8 or not allowed in XML becomes U+FFFD.
std::string escaped(const std::string &text)
{
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

void appendClosed(const Contour &contour, const Transform &transform, std::string &out)
{
    out += "M ";
    append(out, transform(contour.points().front()));
    const int count = contour.segmentCount();
    for (int i = 0; i < count; ++i) {
        const CubicBezier curve = contour.segment(i);
        if (!curve.isStraight(kClipGrid)) {
            const char *separator = " C ";
            for (const Vec2 *p : {&curve.p1, &curve.p2, &curve.p3}) {
                out += std::exchange(separator, " ");
                append(out, transform(*p));
            }
        } else if (i + 1 < count) { // Z draws the last one
            out += " L ";
            append(out, transform(curve.p3));
        }
    }
    out += " Z";
}

void appendOpen(const Stroke &stroke, const Transform &transform, std::string &out)
{
    const char *separator = "M ";
    for (const Vec2 &p : stroke) {
        out += std::exchange(separator, " L ");
        append(out, transform(p));
    }
}

std::string rectangle(const Vec2 &corner, const Vec2 &size)
{
    return "<rect x=\"" + number(corner.x()) + "\" y=\"" + number(corner.y()) + "\" width=\"" +
           number(size.x()) + "\" height=\"" + number(size.y()) + "\" stroke=\"" + kGuide +
           "\"/>\n";
}

void writePart(const Part &part, const Engraving *engraving, const Transform &transform,
               const Model &model, std::string &out)
{
    const auto path = [&](const char *colour, const auto &appendShape) {
        out.append("      <path stroke=\"").append(colour).append("\" d=\"");
        appendShape();
        out += "\"/>\n";
    };
    const Section &section = *model.section(static_cast<std::size_t>(part.section));
    out += "    <g id=\"part-" + std::to_string(part.number) + "\">\n";
    out += "      <title>" + escaped(section.name) + "</title>\n";
    if (engraving) {
        for (const Stroke &stroke : engraving->strokes)
            path(kEngraving, [&] { appendOpen(stroke, transform, out); });
    }
    for (const Contour &hole : part.outline.holes)
        path(kCut, [&] { appendClosed(hole, transform, out); });
    path(kCut, [&] { appendClosed(part.outline.outer, transform, out); });
    out += "    </g>\n";
}

void writeMetadata(const Layout &layout, const Model &model, const SvgOptions &options,
                   std::string &out)
{
    std::set<StockId> used;
    for (const Sheet &sheet : layout.sheets)
        used.insert(sheet.stock);
    out += "  <metadata>\n    <fff:cutting xmlns:fff=\"urn:flatfitfab:cutting\" "
           "version=\"" FFF_VERSION "\" kerf-applied=\"";
    out += options.kerfApplied ? "yes\">\n" : "no\">\n";
    for (const auto &stock : model.document.stocks) {
        if (!used.contains(stock->id))
            continue;
        out += "      <fff:stock name=\"" + escaped(stock->name) + "\" thickness=\"" +
               number(stock->thickness) + "\" clearance=\"" + number(stock->clearance) +
               "\" kerf=\"" + number(stock->kerf) + "\" unit=\"mm\"/>\n";
    }
    out += "    </fff:cutting>\n  </metadata>\n";
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

} // namespace

std::string writeSvg(const Layout &layout, const std::vector<Part> &parts,
                     const std::vector<Engraving> &engravings, const Model &model,
                     const SvgOptions &options)
{
    const Vec2 size = drawingSize(layout, options);
    std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                      "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"" +
                      number(size.x()) + "mm\" height=\"" + number(size.y()) +
                      "mm\" viewBox=\"0 0 " + pair(size) + "\">\n";
    writeMetadata(layout, model, options, out);
    double top = 0.0;
    for (std::size_t i = 0; i < layout.sheets.size(); ++i) {
        const Sheet &sheet = layout.sheets[i];
        out += "  <g id=\"sheet-" + std::to_string(static_cast<int>(i) + options.firstSheet) +
               "\" fill=\"none\" stroke-width=\"0.05\">\n";
        if (layout.sheets.size() > 1)
            out += "    " + rectangle({0.0, top}, sheet.size);
        for (const Placement &placement : sheet.placements) {
            const auto part = static_cast<std::size_t>(placement.part);
            writePart(parts[part], engravings.empty() ? nullptr : &engravings[part],
                      Transform(placement, top + sheet.size.y()), model, out);
        }
        out += "  </g>\n";
        top += sheet.size.y() + kSheetGap;
    }
    if (options.hasReference)
        out += "  <g id=\"reference-100mm-10mm\" fill=\"none\" stroke-width=\"0.05\">\n    " +
               rectangle({0.0, top}, kReferenceSize) + "  </g>\n";
    return out + "</svg>\n";
}

} // namespace fff::io
