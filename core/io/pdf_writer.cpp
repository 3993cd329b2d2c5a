#include "core/io/pdf_writer.h"

#include "core/fabrication/cutting_order.h"
#include "core/fabrication/joint_colours.h"
#include "core/io/pdf_file.h"
#include "core/io/pdf_tiles.h"
#include "core/io/stacked_sheets.h"

#include <QtCore/QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace fff::io {

namespace {

constexpr const char *kPaperOption = "paper";
constexpr double kPaperStroke = 0.2;      // mm, that one sees and cuts along
constexpr double kWords = 3.0;            // mm, height of a line of text
constexpr double kReferenceMargin = 10.0; // mm, round the bar on its page
constexpr std::uint32_t kBlack = 0x000000, kGrey = 0x909090;
const Vec2 kMeasuringBox(50.0, 4.0);                         // mm, on each page of paper
constexpr double kDash = 2.0, kCross = 3.0, kHairline = 0.1; // mm

Box2 boxOf(const ToolLine &line)
{
    Box2 box;
    for (const CubicBezier &curve : line.curves)
        for (const Vec2 &p : {curve.p0, curve.p1, curve.p2, curve.p3})
            box.extend(p);
    return box;
}

void draw(const std::vector<ToolLine> &lines, const CuttingDrawing &drawing, double width,
          PdfPage &page, const Box2 &within = {})
{
    std::uint32_t colour = 0;
    bool isFirst = true;
    for (const ToolLine &line : lines) {
        if (!within.isEmpty() && !boxOf(line).intersects(within))
            continue;
        const std::uint32_t next = colourOf(line.purpose, line.joint, drawing);
        if (std::exchange(isFirst, false) || next != colour)
            page.pen(colour = next, width);
        page.curves(line.curves, line.isClosed);
    }
}

/// Its text says how long it is.
void addMeasuringBox(const Vec2 &corner, const Vec2 &size, PdfPage &page)
{
    page.pen(kBlack, kHairline);
    page.rectangle(corner, size);
    const QString text =
        QCoreApplication::translate("Pdf", "%1 mm: print at 100 %").arg(static_cast<int>(size.x()));
    page.text(corner + Vec2(2.0, 0.5 * size.y() - 0.35 * kWords), kWords,
              text.toLatin1().toStdString());
}

std::vector<PdfPage> sheetPages(const CuttingDrawing &drawing)
{
    const Machine &machine = machineOf(drawing);
    std::vector<PdfPage> pages;
    for (const CuttingSheet &sheet : drawing.sheets) {
        PdfPage &page = pages.emplace_back(sheet.size);
        if (sheet.outline && machine.hasGuides) {
            page.pen(machine.of(Purpose::Guide).colour, machine.stroke);
            for (const Polygon &ring : edgesOf(sheet))
                for (std::size_t i = 0; i < ring.size(); ++i)
                    page.edge(ring[i], ring[(i + 1) % ring.size()]);
        }
        draw(inCuttingOrder(sheet), drawing, machine.stroke, page);
    }
    if (hasBar(drawing)) {
        PdfPage &page = pages.emplace_back(kReferenceSize + Vec2::Constant(2.0 * kReferenceMargin));
        addMeasuringBox(Vec2::Constant(kReferenceMargin), kReferenceSize, page);
    }
    return pages;
}

/// Where the page is cut off and glued to its neighbours.
void addSeams(const PdfTiles &tiles, const PdfTile &tile, PdfPage &page)
{
    const Vec2 low = PdfTiles::low(), high = low + tiles.room();
    constexpr double kHalf = 0.5 * kPaperOverlap;
    std::vector<double> across, along; // x of upright seams, y of level ones
    if (tile.column > 0)
        across.push_back(low.x() + kHalf);
    if (tile.column + 1 < tiles.columns)
        across.push_back(high.x() - kHalf);
    if (tile.row > 0)
        along.push_back(high.y() - kHalf);
    if (tile.row + 1 < tiles.rows)
        along.push_back(low.y() + kHalf);
    page.pen(kGrey, kHairline);
    // On the sheet dashes lie where the neighbour has them.
    const auto begun = [](double corner) {
        return corner - 2.0 * kDash * std::floor(corner / (2.0 * kDash));
    };
    page.dashes(kDash, begun(tile.corner.y()));
    for (const double x : across)
        page.edge({x, low.y()}, {x, high.y()});
    page.dashes(kDash, begun(tile.corner.x()));
    for (const double y : along)
        page.edge({low.x(), y}, {high.x(), y});
    page.dashes(0.0);
    // Crop marks at the ends of each seam and a cross in its middle, where its neighbour has them.
    page.pen(kBlack, kHairline);
    const Vec2 middle = 0.5 * (low + high);
    const auto cross = [&page](const Vec2 &p) {
        page.edge(p - Vec2(kCross, 0.0), p + Vec2(kCross, 0.0));
        page.edge(p - Vec2(0.0, kCross), p + Vec2(0.0, kCross));
    };
    // Where they begin; at both ends of what neighbours share, so that they have the same.
    const auto marks = [&](int axis) {
        return std::array<double, 4>{low[axis], low[axis] + kPaperOverlap - kCross,
                                     high[axis] - kPaperOverlap, high[axis] - kCross};
    };
    for (const double x : across) {
        cross({x, middle.y()});
        for (const double y : marks(1))
            page.edge({x, y}, {x, y + kCross});
    }
    for (const double y : along) {
        cross({middle.x(), y});
        for (const double x : marks(0))
            page.edge({x, y}, {x + kCross, y});
    }
}

/// Under what is drawn, where printers still print.
void addFoot(const CuttingDrawing &drawing, const CuttingSheet &sheet, const PdfTiles &tiles,
             const PdfTile &tile, PdfPage &page)
{
    const double low = kPaperMargin;
    if (drawing.hasReference)
        addMeasuringBox({kPaperMargin, low}, kMeasuringBox, page);
    const QString text = QCoreApplication::translate("Pdf", "Sheet %1, page %2")
                             .arg(sheet.number)
                             .arg(QString::fromStdString(tile.name()));
    page.text({0.5 * tiles.paper.x(), low + 0.5 * kMeasuringBox.y() - 0.35 * kWords}, kWords,
              text.toLatin1().toStdString());
}

std::vector<PdfPage> paperPages(const CuttingDrawing &drawing, const Vec2 &paper)
{
    std::vector<PdfPage> pages;
    for (const CuttingSheet &sheet : drawing.sheets) {
        const std::vector<ToolLine> lines = toolLines(sheet);
        Box2 drawn;
        for (const ToolLine &line : lines)
            drawn.extend(boxOf(line));
        if (drawn.isEmpty())
            continue;
        drawn.min -= Vec2::Constant(kPaperStroke);
        drawn.max += Vec2::Constant(kPaperStroke);
        const PdfTiles tiles = tilesOver(drawn, paper);
        for (const PdfTile &tile : tiles.tiles) {
            Box2 shown;
            shown.extend(tile.corner);
            shown.extend(Vec2(tile.corner + tiles.room()));
            if (std::none_of(lines.begin(), lines.end(), [&shown](const ToolLine &line) {
                    return boxOf(line).intersects(shown);
                }))
                continue;
            PdfPage &page = pages.emplace_back(tiles.paper);
            const Vec2 low = PdfTiles::low();
            page.beginClip(low, tiles.room(), low - tile.corner);
            draw(lines, drawing, kPaperStroke, page, shown);
            page.endClip();
            addSeams(tiles, tile, page);
            addFoot(drawing, sheet, tiles, tile, page);
        }
    }
    return pages;
}

} // namespace

std::string writePdf(const CuttingDrawing &drawing, PdfPaper paper)
{
    switch (paper) {
    case PdfPaper::Sheets:
        return pdfBytes(sheetPages(drawing));
    case PdfPaper::A4:
        return pdfBytes(paperPages(drawing, {210.0, 297.0}));
    case PdfPaper::Letter:
        return pdfBytes(paperPages(drawing, {215.9, 279.4}));
    }
    return {}; // not reached: every paper is above
}

const Format &pdfFormat()
{
    static const Format format = {
        .key = "pdf",
        .suffixes = {"pdf"},
        .title = QT_TRANSLATE_NOOP("Format", "PDF, a page for each sheet"),
        .help = QT_TRANSLATE_NOOP("CommandLine", "PDF in true size"),
        .options = {{.name = kPaperOption,
                     .value = "PAPER",
                     .help = QT_TRANSLATE_NOOP("CommandLine",
                                               "Pages of a PDF file: sheet, or tiles on a4 or "
                                               "letter (sheet)."),
                     .choices = {{.name = "sheet"},
                                 {.name = "a4",
                                  .title = QT_TRANSLATE_NOOP("Format", "PDF, tiled on A4"),
                                  .use = FileUse::Paper},
                                 {.name = "letter",
                                  .title = QT_TRANSLATE_NOOP("Format", "PDF, tiled on Letter"),
                                  .use = FileUse::Paper}}}},
        .isColoured = true,
        .writeCutting = [](const CuttingDrawing &drawing,
                           const FormatValues &values) -> Result<std::string> {
            return writePdf(drawing, static_cast<PdfPaper>(valueOf(values, kPaperOption, 0.0)));
        }};
    return format;
}

} // namespace fff::io
