// Parts on sheets by their true outlines.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/base/tolerances.h"
#include "core/fabrication/nested_layout.h"
#include "core/fabrication/shared_cuts.h"
#include "core/geometry/turning.h"
#include "core/nesting/problem.h"
#include "tests/core/assembly/plates.h"
#include "tests/core/fabrication/parts_of.h"
#include "tests/core/nesting/nesting_oracle.h"
#include "tests/core/nesting/nesting_problems.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <numbers>

using namespace fff;
using namespace fff::test;
using nest::Turning;

namespace {

Part partOf(const Polygon &outline, StockId stock, int number)
{
    Part part;
    part.number = number;
    part.stock = stock;
    part.outline = regionOf(*Contour::fromPolygon(outline));
    return part;
}

std::vector<Part> triangles(int count, StockId stock)
{
    std::vector<Part> parts;
    for (int i = 0; i < count; ++i)
        parts.push_back(partOf({{-70, 30}, {70, 30}, {-70, 130}}, stock, i + 1));
    return parts;
}

/// A rectangle with a round top: straight edges and a curve.
Part archOf(double width, double height, StockId stock, int number)
{
    constexpr double kArc = 4.0 / 3.0 * (std::numbers::sqrt2 - 1.0);
    const double r = 0.5 * width;
    const Vec2 a(-r, 0), b(r, 0), c(r, height), top(0, height + r), d(-r, height);
    Part part;
    part.number = number;
    part.stock = stock;
    part.outline = regionOf(
        *Contour::fromSegments({CubicBezier::line(a, b), CubicBezier::line(b, c),
                                CubicBezier{c, c + Vec2(0, kArc * r), top + Vec2(kArc * r, 0), top},
                                CubicBezier{top, top - Vec2(kArc * r, 0), d + Vec2(0, kArc * r), d},
                                CubicBezier::line(d, a)}));
    return part;
}

/// What is wrong with the layout, as the nester's oracle sees it; oversized parts are none of it.
QString oracleOf(const Layout &layout, const std::vector<Part> &parts, const NestOptions &options)
{
    nest::Problem problem;
    nest::Solution solution;
    problem.margin = options.layout.margin;
    problem.spacing = options.layout.spacing;
    for (const Part &part : parts) {
        nest::Piece piece;
        piece.outline = part.outline.region;
        piece.turnsFreely = true;
        problem.pieces.push_back(std::move(piece));
    }
    for (const Sheet &sheet : layout.sheets) {
        const int index = static_cast<int>(problem.sheets.size());
        problem.sheets.push_back({{box(0, 0, sheet.size.x(), sheet.size.y()), {}}, 1});
        solution.sheets.push_back(index);
        for (const Placement &placement : sheet.placements)
            solution.places.push_back({placement.part, index, placement.turn, placement.offset});
    }
    return test::whatIsWrong(problem, solution);
}

} // namespace

class TestNestedLayout : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void trianglesShareTheirBoxes();
    void turnsOfEachPart();
    void everyStockHasItsSheets();
    void tooLargePartGetsItsOwnSheet();
    void aPartThatFitsOnlyAtAnAngle();
    void neverMoreSheetsThanBoxes();
    void nothingGivesNoSheet();
    void curvesStayOnTheSheet();
    void straightEdgesLieOnEachOther();
};

// Wrong: half of the sheet would be waste.
void TestNestedLayout::trianglesShareTheirBoxes()
{
    const Model model{newDocument(), {}};
    const std::vector<Part> parts = triangles(12, model.document.currentStock);
    NestOptions options;
    options.layout.sheet = Vec2(600, 230);
    options.turning = Turning::Half;
    options.work = nest::workOf(1.0);
    const NestedLayout nested = nestOut(parts, model, options);
    QCOMPARE(oracleOf(nested.layout, parts, options), QString());
    QVERIFY(nested.layout.oversized.empty());
    QCOMPARE(nested.layout.sheets.size(), 1U);
    QVERIFY(nested.work > 0);
    QVERIFY(layOut(parts, model, options.layout).sheets.size() > 1);
}

// Wrong: the grain of a part would run across it.
void TestNestedLayout::turnsOfEachPart()
{
    const Model model{newDocument(), {}};
    std::vector<Part> parts;
    for (int i = 0; i < 8; ++i)
        parts.push_back(partOf(box(0, 0, 90, 40), model.document.currentStock, i + 1));
    NestOptions options;
    options.layout.sheet = Vec2(200, 300);
    options.turning = Turning::Free;
    options.turnings = {Turning::None, Turning::Half, Turning::Quarter};
    options.work = nest::workOf(0.05);
    const NestedLayout nested = nestOut(parts, model, options);
    QCOMPARE(oracleOf(nested.layout, parts, options), QString());
    for (const Sheet &sheet : nested.layout.sheets)
        for (const Placement &placement : sheet.placements) {
            if (placement.part == 0)
                QVERIFY(placement.turn == Vec2(1, 0));
            if (placement.part == 1)
                QVERIFY(std::abs(placement.turn.x()) == 1.0);
            if (placement.part == 2)
                QVERIFY(placement.turn.x() * placement.turn.y() == 0.0);
        }
}

void TestNestedLayout::everyStockHasItsSheets()
{
    Document document = newDocument();
    const StockId first = document.currentStock;
    Stock other = *document.find(first);
    other.name = "Other";
    other.sheet = Vec2(300, 200);
    document = *addStock(std::move(document), other);
    const Model model{document, {}};
    std::vector<Part> parts = triangles(4, first);
    for (Part part : triangles(5, document.currentStock))
        parts.push_back(std::move(part));
    NestOptions options;
    const Layout layout = nestOut(parts, model, options).layout;
    QCOMPARE(oracleOf(layout, parts, options), QString());
    QVERIFY(layout.sheets.size() >= 2);
    for (const Sheet &sheet : layout.sheets) {
        QVERIFY(sheet.size == model.document.find(sheet.stock)->sheet);
        for (const Placement &placement : sheet.placements)
            QVERIFY(parts[static_cast<std::size_t>(placement.part)].stock == sheet.stock);
    }
}

void TestNestedLayout::tooLargePartGetsItsOwnSheet()
{
    const Model model{newDocument(), {}};
    std::vector<Part> parts = triangles(3, model.document.currentStock);
    parts.insert(parts.begin() + 1, partOf(box(5, 5, 900, 700), model.document.currentStock, 9));
    NestOptions options;
    const Layout layout = nestOut(parts, model, options).layout;
    QCOMPARE(oracleOf(layout, parts, options), QString());
    QCOMPARE(layout.oversized, std::vector<int>{1});
    QCOMPARE(layout.sheets.size(), 2U);
    QVERIFY((layout.sheets[1].size - Vec2(910, 710)).norm() < 1e-6);
}

void TestNestedLayout::aPartThatFitsOnlyAtAnAngle()
{
    const Model model{newDocument(), {}};
    const std::vector<Part> parts{partOf(box(0, 0, 650, 12), model.document.currentStock, 1)};
    NestOptions options; // on 600 x 400
    QVERIFY(nestOut(parts, model, options).layout.oversized.empty());
    options.turning = Turning::Quarter;
    QCOMPARE(nestOut(parts, model, options).layout.oversized.size(), 1U);
}

void TestNestedLayout::neverMoreSheetsThanBoxes()
{
    const Model model{newDocument(), {}};
    for (unsigned seed = 1; seed <= 4; ++seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> side(10.0, 90.0);
        std::vector<Part> parts;
        for (int i = 0; i < 40; ++i)
            parts.push_back(
                partOf(box(3, 4, side(random), side(random)), model.document.currentStock, i + 1));
        NestOptions options;
        options.layout.sheet = Vec2(210, 297);
        const Layout layout = nestOut(parts, model, options).layout;
        QCOMPARE(oracleOf(layout, parts, options), QString());
        QVERIFY(layout.sheets.size() <= layOut(parts, model, options.layout).sheets.size());
    }
}

void TestNestedLayout::nothingGivesNoSheet()
{
    const Model model{newDocument(), {}};
    QVERIFY(nestOut({}, model, {}).layout.sheets.empty());
}

/// Their chords did, and the curves went beyond them, up to 0.0087 mm over the edge.
void TestNestedLayout::curvesStayOnTheSheet()
{
    const Model model{newDocument(), {}};
    std::vector<Part> parts;
    for (int i = 0; i < 12; ++i)
        parts.push_back(archOf(60.0 + i, 35.0 + 2.0 * i, model.document.currentStock, i + 1));
    for (const double margin : {0.0, 5.0}) {
        NestOptions options;
        options.layout.margin = margin;
        options.layout.spacing = 0.0;
        options.work = nest::workOf(0.05);
        const Layout layout = nestOut(parts, model, options).layout;
        QVERIFY(layout.oversized.empty());
        for (const Sheet &sheet : layout.sheets)
            for (const Placement &placement : sheet.placements) {
                Box2 box = turnedBounds(
                    parts[static_cast<std::size_t>(placement.part)].outline.outer, placement.turn);
                const Vec2 low = box.min + placement.offset,
                           high = sheet.size - (box.max + placement.offset);
                QVERIFY2(low.cwiseMin(high).minCoeff() >= margin - kClipSlack,
                         qPrintable(QString::number(low.cwiseMin(high).minCoeff(), 'g', 9)));
            }
    }
}

/// They were kept apart as if they were curves, and cut twice: an arch has both.
void TestNestedLayout::straightEdgesLieOnEachOther()
{
    const Model model{newDocument(), {}};
    std::vector<Part> parts;
    for (int i = 0; i < 8; ++i)
        parts.push_back(archOf(80.0, 60.0, model.document.currentStock, i + 1));
    NestOptions options;
    options.layout.spacing = 0.0;
    options.turning = Turning::Half;
    const Layout layout = nestOut(parts, model, options).layout;
    QCOMPARE(layout.sheets.size(), std::size_t(1));
    std::vector<ToolLine> lines;
    for (const Placement &placement : layout.sheets.front().placements) {
        const Contour &outer = parts[static_cast<std::size_t>(placement.part)].outline.outer;
        ToolLine line;
        for (int k = 0; k < outer.segmentCount(); ++k) {
            const CubicBezier c = outer.segment(k);
            line.curves.push_back({placement.apply(c.p0), placement.apply(c.p1),
                                   placement.apply(c.p2), placement.apply(c.p3)});
        }
        line.isClosed = true;
        lines.push_back(std::move(line));
    }
    std::vector<const ToolLine *> pointers;
    for (const ToolLine &line : lines)
        pointers.push_back(&line);
    double shared = 0.0;
    for (const std::vector<LineSpan> &spans : sharedSpans(pointers))
        for (const LineSpan &span : spans)
            shared += span.to - span.from;
    QVERIFY2(shared >= 3.0 * 60.0, qPrintable(QString::number(shared)));
}

FFF_TEST(TestNestedLayout)
#include "tst_nested_layout.moc"
