#include "core/fabrication/fit_coupon.h"

#include "core/fabrication/kerf.h"
#include "core/fabrication/machine.h"
#include "core/geometry/boolean.h"
#include "core/model/lettering.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

namespace fff {

namespace {

constexpr int kMiddleSlit = (kCouponSlits + 1) / 2;

// mm
constexpr double kCouponMargin = 5.0; // from the sheet's edge to the nearest path
constexpr double kCouponGap = 3.0;    // between its parts
constexpr double kLeastWeb = 8.0;     // between slits: a laser's heat bends less, and digits fit
constexpr double kLeastDepth = 10.0;  // of slits
constexpr double kDepthPerThickness = 3.0;
constexpr double kSlitDigits = 3.5;  // height of numbers
constexpr double kWordsHeight = 3.0; // of a capital, or as small as it takes
constexpr double kMarkGap = 1.5;     // round numbers and words
constexpr double kStripWidth = 30.0; // of the strip to push in
constexpr double kSlatLength = 25.0;
constexpr double kNarrowest = 0.02; // a drawn slit: its two walls are cut apart

/// Where the slits are, along the piece's lower edge.
struct SlitRow
{
    double thickness = 0.0, web = 0.0, depth = 0.0; // mm
    int first = 1, last = kCouponSlits;             // numbers

    double widthOf(int number) const { return thickness + clearanceOfSlit(number); }
    double pitch() const { return widthOf(kCouponSlits) + web; }
    double middleOf(int number) const
    {
        return web + 0.5 * widthOf(kCouponSlits) + (number - first) * pitch();
    }
    double length() const { return web + (last - first + 1) * pitch(); }
    double height() const
    {
        return depth + kSlitDigits + kWordsHeight + 3.0 * kMarkGap + 0.5 * kLeastWeb;
    }
};

std::string plainNumber(double value)
{
    std::array<char, 32> text{};
    constexpr double kThousandths = 1000.0;
    const auto end = std::to_chars(text.data(), text.data() + text.size(),
                                   std::round(value * kThousandths) / kThousandths);
    return {text.data(), end.ptr};
}

tl::unexpected<Error> tooSmall(const Stock &stock)
{
    return failure(
        ErrorCode::BadValue, "sheet",
        {plainNumber(stock.sheet.x()) + " x " + plainNumber(stock.sheet.y()), "a larger sheet"});
}

/// Errors  as fitCoupon().
Result<SlitRow> slitRow(const Stock &stock)
{
    SlitRow row;
    row.thickness = stock.thickness;
    row.web = std::max(kLeastWeb, stock.thickness);
    row.depth = std::max(kLeastDepth, kDepthPerThickness * stock.thickness);
    if (row.widthOf(kMiddleSlit) - stock.kerf < kNarrowest)
        return failure(
            ErrorCode::ClosedSlit, {},
            {stock.name, millimetres(row.widthOf(kMiddleSlit)), millimetres(stock.kerf)});
    while (row.widthOf(row.first) - stock.kerf < kNarrowest)
        ++row.first;
    const double room = stock.sheet.maxCoeff() - 2.0 * kCouponMargin - stock.kerf;
    while (row.length() > room && row.first < row.last) {
        // From whichever end is further from the middle.
        if (row.last - kMiddleSlit >= kMiddleSlit - row.first)
            --row.last;
        else
            ++row.first;
    }
    if (row.last <= kMiddleSlit)
        return tooSmall(stock);
    return row;
}

Polygon boxFrom(const Vec2 &corner, const Vec2 &size)
{
    return {corner,
            {corner.x() + size.x(), corner.y()},
            corner + size,
            {corner.x(), corner.y() + size.y()}};
}

Result<CurvedRegion> rectangle(const Vec2 &size)
{
    return Contour::fromPolygon(boxFrom(Vec2::Zero(), size)).and_then([](const Contour &contour) {
        return subtract(contour, {}, {}, kCutChord).map([](auto regions) { return regions.at(0); });
    });
}

Result<CurvedRegion> slitPiece(const SlitRow &row)
{
    std::vector<Polygon> slits;
    for (int number = row.first; number <= row.last; ++number) {
        const double width = row.widthOf(number);
        // Beyond the edge that it opens at.
        slits.push_back(
            boxFrom({row.middleOf(number) - 0.5 * width, -row.web}, {width, row.web + row.depth}));
    }
    return Contour::fromPolygon(boxFrom(Vec2::Zero(), {row.length(), row.height()}))
        .and_then([&slits](const Contour &contour) {
            return subtract(contour, {}, slits, kCutChord).map([](auto regions) {
                return regions.at(0);
            });
        });
}

/// Without what is no letter of the alphabet.
Result<std::vector<CurvePath>> readableWords(Lettering words)
{
    for (;;) {
        auto paths = letterPaths(words);
        const bool isUnknownLetter = !paths && paths.error().place == "text" &&
                                     !paths.error().args.empty() &&
                                     !paths.error().args.front().empty();
        if (!isUnknownLetter)
            return paths;
        const std::string letter = paths.error().args.front();
        const std::size_t at = words.text.find(letter);
        if (at == std::string::npos)
            return paths;
        words.text.erase(at, letter.size());
    }
}

Box2 boxOfPaths(const std::vector<CurvePath> &paths)
{
    Box2 box;
    for (const CurvePath &path : paths)
        box.extend(path.bounds());
    return box;
}

/// What it is, along its upper edge.
std::vector<CurvePath> engravedWords(const Stock &stock, const Machine *machine, const SlitRow &row)
{
    Lettering words;
    words.text = stock.name + ", " + plainNumber(stock.thickness) + " mm, kerf " +
                 plainNumber(stock.kerf) + " mm";
    if (machine)
        words.text += ", " + machine->name;
    std::replace(words.text.begin(), words.text.end(), '\n', ' ');
    words.height = kWordsHeight;
    words.at = {0.5 * row.length(), row.height() - kMarkGap - 0.5 * kWordsHeight};
    auto paths = readableWords(words);
    if (!paths)
        return {}; // a name of no letters that we have
    const double room = row.length() - 2.0 * kMarkGap, length = boxOfPaths(*paths).size().x();
    if (length > room) {
        words.height *= room / length;
        paths = readableWords(words);
    }
    return paths ? *std::move(paths) : std::vector<CurvePath>();
}

Engraving engravedNumbers(const SlitRow &row)
{
    Engraving engraving;
    for (int number = row.first; number <= row.last; ++number) {
        const double width = kSlitDigits * strokedSize(number).x();
        appendNumber(number, {row.middleOf(number) - 0.5 * width, row.depth + kMarkGap},
                     kSlitDigits, engraving.strokes);
    }
    return engraving;
}

/// The parts of one stock, side by side.
class CouponSheet
{
public:
    /// length  of a row at most, with the margins
    CouponSheet(double kerf, double length)
        : m_gap(kCouponGap + kerf), m_end(length - kCouponMargin)
    {
    }

    /// Rows from below, of each row from the left.
    void add(CurvedRegion outline, Engraving engraving, std::string name)
    {
        const Box2 box = outline.outer.bounds();
        if (m_at.x() > kCouponMargin && m_at.x() + box.size().x() > m_end)
            startRow();
        Placement placement;
        placement.part = static_cast<int>(m_source.parts.size());
        placement.offset = m_at - box.min;
        m_right = std::max(m_right, m_at.x() + box.size().x());
        m_top = std::max(m_top, m_at.y() + box.size().y());
        m_at.x() += box.size().x() + m_gap;
        Part &part = m_source.parts.emplace_back();
        part.number = static_cast<int>(m_source.parts.size());
        part.outline = std::move(outline);
        m_source.engravings.push_back(std::move(engraving));
        m_names.push_back(std::move(name));
        m_placements.push_back(placement);
    }
    void startRow() { m_at = {kCouponMargin, m_top + m_gap}; }

    CuttingSheet take(StockId stock)
    {
        CuttingSheet sheet;
        sheet.size = Vec2(m_right, m_top) + Vec2::Constant(kCouponMargin);
        sheet.stock = stock;
        for (Part &part : m_source.parts)
            part.stock = stock;
        const auto source = std::make_shared<const CuttingPart::Source>(std::move(m_source));
        for (std::size_t i = 0; i < m_placements.size(); ++i)
            sheet.parts.emplace_back(source, m_placements[i], m_names[i]);
        return sheet;
    }

private:
    CuttingPart::Source m_source;
    std::vector<Placement> m_placements;
    std::vector<std::string> m_names;
    double m_gap, m_end;
    Vec2 m_at = Vec2::Constant(kCouponMargin);
    double m_right = 0.0, m_top = 0.0;
};

Result<CuttingSheet> couponSheet(const Stock &stock, const Machine *machine,
                                 const CouponWords &words)
{
    const Result<SlitRow> row = slitRow(stock);
    if (!row)
        return tl::unexpected(row.error());
    const auto compensated = [&stock](const CurvedRegion &region) {
        return compensateKerf(region, stock.kerf);
    };
    auto slits = slitPiece(*row).and_then(compensated);
    auto strip = rectangle({kStripWidth, kSlatLength}).and_then(compensated);
    const auto slat = rectangle({kCouponSlat, kSlatLength});
    for (const auto *made : {&std::as_const(slits), &std::as_const(strip), &slat})
        if (!*made) {
            Error error = made->error();
            error.args = {stock.name, millimetres(stock.kerf)};
            return tl::unexpected(std::move(error));
        }
    CouponSheet sheet(stock.kerf, stock.sheet.maxCoeff());
    Engraving engraving = engravedNumbers(*row);
    engraving.lines.engraved = engravedWords(stock, machine, *row);
    sheet.add(*std::move(slits), std::move(engraving), words.slits);
    sheet.startRow();
    sheet.add(*std::move(strip), {}, words.strip);
    for (int i = 0; i < kCouponSlats; ++i)
        sheet.add(*slat, {}, words.slat);
    CuttingSheet taken = sheet.take(stock.id);
    if (taken.size.maxCoeff() > stock.sheet.maxCoeff() + kClipGrid ||
        taken.size.minCoeff() > stock.sheet.minCoeff() + kClipGrid)
        return tooSmall(stock);
    return taken;
}

} // namespace

double clearanceOfSlit(int number)
{
    return (number - kMiddleSlit) * kCouponStep;
}

int slitOfClearance(double clearance)
{
    const double off = std::clamp(clearance / kCouponStep, 1.0 - kMiddleSlit,
                                  static_cast<double>(kCouponSlits - kMiddleSlit));
    return kMiddleSlit + static_cast<int>(std::lround(off));
}

Result<CouponRange> couponRange(const Stock &stock)
{
    return slitRow(stock).map([](const SlitRow &row) { return CouponRange{row.first, row.last}; });
}

double kerfOfSlats(double measured)
{
    return (kCouponSlats * kCouponSlat - measured) / kCouponSlats;
}

Result<CuttingDrawing> fitCoupon(std::span<const Stock> stocks,
                                 std::shared_ptr<const Machine> machine, const CouponWords &words)
{
    CuttingDrawing drawing;
    drawing.isKerfApplied = true;
    drawing.hasReference = false;
    drawing.stocks.assign(stocks.begin(), stocks.end());
    for (const Stock &stock : stocks) {
        Result<CuttingSheet> sheet = couponSheet(stock, machine.get(), words);
        if (!sheet)
            return tl::unexpected(std::move(sheet.error()));
        sheet->number = static_cast<int>(drawing.sheets.size()) + 1;
        drawing.sheets.push_back(*std::move(sheet));
    }
    drawing.machine = std::move(machine);
    return drawing;
}

} // namespace fff
