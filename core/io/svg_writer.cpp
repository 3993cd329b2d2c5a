#include "core/io/svg_writer.h"

#include "core/base/tolerances.h"

#include <QString>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <set>
#include <utility>

namespace fff::io {

namespace {

constexpr double kSheetGap = 10.0;
const Vec2 kReferenceSize(100.0, 10.0);
constexpr const char *kCut = "#ff0000";
constexpr const char *kEngraving = "#0000ff";
constexpr const char *kGuide = "#ffcc00";

/// What coordinates are whole multiples of: one over a power of ten.
enum class Decimals : std::uint32_t {
    Cut = 1'000'000,  // a nanometre: the drawing is what was computed
    Engraving = 1'000 // a micrometre: no one measures a digit, and there are many
};

/// The texts of 00 … 99, one after the other.
constexpr std::array<char, 200> kPairs = [] {
    std::array<char, 200> pairs{};
    for (std::size_t i = 0; i < 100; ++i) {
        pairs[2 * i] = static_cast<char>('0' + i / 10);
        pairs[2 * i + 1] = static_cast<char>('0' + i % 10);
    }
    return pairs;
}();

/// A short text that grows to its front.
class Digits
{
public:
    void put(char c) { *--m_begin = c; }
    void putPair(std::uint64_t below100)
    {
        m_begin -= 2;
        std::memcpy(m_begin, kPairs.data() + 2 * below100, 2);
    }
    void putWhole(std::uint64_t value)
    {
        for (; value >= 100; value /= 100)
            putPair(value % 100);
        if (value >= 10)
            putPair(value);
        else
            put(static_cast<char>('0' + value));
    }
    /// As many digits as there are zeros in `scale`, without those 0 that stand last.
    void putFraction(std::uint32_t value, std::uint32_t scale)
    {
        for (; scale >= 10 && value % 10 == 0; scale /= 10)
            value /= 10;
        for (; scale >= 100; scale /= 100, value /= 100)
            putPair(value % 100);
        if (scale >= 10)
            put(static_cast<char>('0' + value));
    }
    void appendTo(std::string &out) const
    {
        out.append(m_begin, static_cast<std::size_t>(end() - m_begin));
    }

private:
    const char *end() const { return m_buffer.data() + m_buffer.size(); }

    std::array<char, 64> m_buffer;
    char *m_begin = m_buffer.data() + m_buffer.size();
};

/// The shortest text of the number rounded to so many decimals, without an exponent. By whole
/// numbers: a drawing is made of little else.
template <Decimals decimals>
void put(Digits &digits, double value)
{
    constexpr auto kScale = static_cast<std::uint32_t>(decimals);
    const auto size = static_cast<std::uint64_t>(std::abs(value) * kScale + 0.5);
    if (const auto fraction = static_cast<std::uint32_t>(size % kScale)) {
        digits.putFraction(fraction, kScale);
        digits.put('.');
    }
    digits.putWhole(size / kScale);
    if (value < 0.0 && size > 0)
        digits.put('-');
}

template <Decimals decimals>
void append(std::string &out, const Vec2 &p)
{
    Digits digits;
    put<decimals>(digits, p.y());
    digits.put(' ');
    put<decimals>(digits, p.x());
    digits.appendTo(out);
}

std::string number(double value)
{
    Digits digits;
    put<Decimals::Cut>(digits, value);
    std::string text;
    digits.appendTo(text);
    return text;
}

std::string pair(const Vec2 &p)
{
    return number(p.x()) + ' ' + number(p.y());
}

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

void appendClosed(const Contour &contour, const Transform &transform, std::string &out)
{
    out += "M ";
    append<Decimals::Cut>(out, transform(contour.points().front()));
    const int count = contour.segmentCount();
    for (int i = 0; i < count; ++i) {
        const CubicBezier curve = contour.segment(i);
        if (!curve.isStraight(kClipGrid)) {
            const char *separator = " C ";
            for (const Vec2 *p : {&curve.p1, &curve.p2, &curve.p3}) {
                out += std::exchange(separator, " ");
                append<Decimals::Cut>(out, transform(*p));
            }
        } else if (i + 1 < count) { // Z draws the last one
            out += " L ";
            append<Decimals::Cut>(out, transform(curve.p3));
        }
    }
    out += " Z";
}

void appendOpen(const Strokes &strokes, const Transform &transform, std::string &out)
{
    const char *start = "M ";
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        const char *separator = std::exchange(start, " M ");
        for (const Vec2 &p : strokes[i]) {
            out += std::exchange(separator, " L ");
            append<Decimals::Engraving>(out, transform(p));
        }
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
    if (engraving && !engraving->strokes.isEmpty())
        path(kEngraving, [&] { appendOpen(engraving->strokes, transform, out); });
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
    constexpr std::size_t kHead = 2000, kPart = 200, kCutPoint = 24, kStrokePoint = 18;
    std::size_t length = kHead;
    for (const Sheet &sheet : layout.sheets) {
        for (const Placement &placement : sheet.placements) {
            const auto part = static_cast<std::size_t>(placement.part);
            length += kPart + kCutPoint * pointCount(parts[part].outline);
            if (!engravings.empty())
                length += kStrokePoint * engravings[part].strokes.pointCount();
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
    std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                      "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"" +
                      number(size.x()) + "mm\" height=\"" + number(size.y()) +
                      "mm\" viewBox=\"0 0 " + pair(size) + "\">\n";
    out.reserve(estimatedLength(layout, parts, engravings));
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
    out += "</svg>\n";
    return out;
}

} // namespace fff::io
