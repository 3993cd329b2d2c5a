#include "core/base/tolerances.h"
#include "core/fabrication/layout.h"
#include "core/fabrication/open_sheets.h"
#include "tests/core/assembly/plates.h"
#include "tests/core/fabrication/parts_of.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <QTest>

#include <random>

using namespace fff;
using namespace fff::test;

namespace {

std::vector<Part> rectangles(const std::vector<Vec2> &sizes, StockId stock)
{
    std::vector<Part> parts;
    for (const Vec2 &size : sizes) {
        Part part;
        part.number = static_cast<int>(parts.size()) + 1;
        part.stock = stock;
        // Somewhere else than at the origin: parts keep their section's coordinates.
        part.outline =
            regionOf(*Contour::fromPolygon(rectangle(-70, 30, -70 + size.x(), 30 + size.y())));
        parts.push_back(part);
    }
    return parts;
}

Box2 placedBox(const Part &part, const Placement &placement)
{
    Box2 box;
    for (const Vec2 &p : part.outline.region.outer)
        box.extend(placement.apply(p));
    return box;
}

/// Empty when every part lies on one sheet, inside its margin and apart from all others.
QString whatIsWrong(const Layout &layout, const std::vector<Part> &parts,
                    const LayoutOptions &options)
{
    constexpr double kGridRounding = 1e-6; // mm: regions are on the grid, outlines are not
    std::vector<int> seen(parts.size(), 0);
    for (const Sheet &sheet : layout.sheets) {
        std::vector<Box2> boxes;
        for (const Placement &placement : sheet.placements) {
            const Part &part = parts[static_cast<std::size_t>(placement.part)];
            ++seen[static_cast<std::size_t>(placement.part)];
            if (part.stock != sheet.stock)
                return QStringLiteral("on a sheet of another stock");
            const Box2 box = placedBox(part, placement);
            if (box.min.minCoeff() < options.margin - kGridRounding ||
                (sheet.size - box.max).minCoeff() < options.margin - kGridRounding)
                return QStringLiteral("part %1 in the margin").arg(part.number);
            for (const Box2 &other : boxes) {
                const Vec2 gap = (box.min - other.max).cwiseMax(other.min - box.max);
                if (gap.maxCoeff() < options.spacing - kGridRounding)
                    return QStringLiteral("part %1 too near to another").arg(part.number);
            }
            boxes.push_back(box);
        }
    }
    for (const int count : seen) {
        if (count != 1)
            return QStringLiteral("a part is placed %1 times").arg(count);
    }
    return {};
}

} // namespace

class TestLayout : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void partsLieApartOnTheirSheets_data();
    void partsLieApartOnTheirSheets();
    void partsTurnToFit();
    void boxesGoOnTheFirstSheetWithRoom();
    void equalBoxesSearchEachSheetOnce();
    void whatLayLiesWhereItLay();
    void diagonalPartsAreTurned();
    void partsThatFitOnlyAtAnAngle();
    void tooLargePartGetsItsOwnSheet();
    void everyStockHasItsSheets();
    void shelvesAreFilled();
    void sameInputSameLayout();
    void nothingGivesNoSheet();
};

void TestLayout::partsLieApartOnTheirSheets_data()
{
    QTest::addColumn<int>("count");
    QTest::addColumn<double>("largest");
    QTest::addColumn<Vec2>("sheet");
    QTest::newRow("one part") << 1 << 100.0 << Vec2(600, 400);
    QTest::newRow("a few parts") << 12 << 150.0 << Vec2(600, 400);
    QTest::newRow("hundreds of small parts") << 300 << 40.0 << Vec2(600, 400);
    QTest::newRow("parts on a narrow sheet") << 40 << 80.0 << Vec2(100, 1000);
    QTest::newRow("parts some of which are too large") << 40 << 300.0 << Vec2(210, 297);
}

// Wrong: cuts would run through other parts or off the sheet.
void TestLayout::partsLieApartOnTheirSheets()
{
    QFETCH(int, count);
    QFETCH(double, largest);
    QFETCH(Vec2, sheet);
    constexpr unsigned kSeed = 31;
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<double> size(1.0, largest);
    std::vector<Vec2> sizes;
    for (int i = 0; i < count; ++i)
        sizes.emplace_back(size(random), size(random));
    const Model model{newDocument(), {}};
    const std::vector<Part> parts = rectangles(sizes, model.document.currentStock);
    LayoutOptions options;
    options.sheet = sheet;
    options.margin = 7.0;
    options.spacing = 3.0;
    const Layout layout = layOut(parts, model, options);
    const QString wrong = whatIsWrong(layout, parts, options);
    QVERIFY2(wrong.isEmpty(), qPrintable(QStringLiteral("seed %1: ").arg(kSeed) + wrong));
    for (const Sheet &s : layout.sheets) {
        const bool isOwn =
            s.placements.size() == 1 &&
            std::count(layout.oversized.begin(), layout.oversized.end(), s.placements[0].part) == 1;
        QVERIFY(isOwn || s.size == sheet);
    }
}

// Wrong: a long part would be called too large though it fits when turned.
void TestLayout::partsTurnToFit()
{
    const Model model{newDocument(), {}};
    const std::vector<Part> parts = rectangles({{20, 500}}, model.document.currentStock);
    const LayoutOptions options; // 600 x 400
    const Layout layout = layOut(parts, model, options);
    QVERIFY(layout.oversized.empty());
    QCOMPARE(layout.sheets.size(), 1U);
    QVERIFY(layout.sheets[0].placements[0].turn == Vec2::UnitY());
    QCOMPARE(whatIsWrong(layout, parts, options), QString());
}

// Wrong: a stick drawn at 45 degrees would take as much as a square plate.
void TestLayout::diagonalPartsAreTurned()
{
    const Model model{newDocument(), {}};
    std::vector<Part> parts =
        rectangles(std::vector<Vec2>(20, Vec2(1, 1)), model.document.currentStock);
    for (Part &part : parts)
        part.outline = regionOf(polygonContour(turnedRectangle({9, 9}, 380, 15, 0.8)));
    LayoutOptions options;
    const Layout turned = layOut(parts, model, options);
    QCOMPARE(turned.sheets.size(), 1U);
    QCOMPARE(whatIsWrong(turned, parts, options), QString());
    QVERIFY(usedShare(turned, parts) > 0.45);
    options.turnsFreely = false;
    QVERIFY(layOut(parts, model, options).sheets.size() >= 10U);
}

// Wrong: a part would be called too large that lies on the sheet from corner to corner.
void TestLayout::partsThatFitOnlyAtAnAngle()
{
    const Model model{newDocument(), {}};
    const std::vector<Part> parts =
        rectangles({{640, 12}, {30, 30}, {12, 660}}, model.document.currentStock);
    LayoutOptions options; // 600 x 400: 707 mm from corner to corner of what the margins leave
    const Layout layout = layOut(parts, model, options);
    QVERIFY(layout.oversized.empty());
    QCOMPARE(whatIsWrong(layout, parts, options), QString());
    options.turnsFreely = false;
    QCOMPARE(layOut(parts, model, options).oversized, (std::vector<int>{0, 2}));
}

// Wrong: a part that no plate holds would be cut off, or silently left out.
void TestLayout::tooLargePartGetsItsOwnSheet()
{
    const Model model{newDocument(), {}};
    const std::vector<Part> parts =
        rectangles({{50, 50}, {700, 450}, {30, 30}}, model.document.currentStock);
    const LayoutOptions options;
    const Layout layout = layOut(parts, model, options);
    QCOMPARE(layout.oversized, std::vector<int>{1});
    QCOMPARE(layout.sheets.size(), 2U);
    QVERIFY((layout.sheets[1].size - Vec2(710, 460)).norm() < 1e-9);
    QCOMPARE(whatIsWrong(layout, parts, options), QString());
}

// Wrong: acrylic parts would be cut from plywood.
void TestLayout::everyStockHasItsSheets()
{
    Model model{newDocument(), {}};
    const StockId wood = model.document.currentStock;
    Stock acrylic = flatfabAcrylic();
    acrylic.sheet = {300, 200};
    model.document = *addStock(model.document, acrylic);
    std::vector<Part> parts = rectangles({{50, 50}, {40, 40}, {30, 30}}, wood);
    parts[1].stock = model.document.currentStock;
    const Layout layout = layOut(parts, model, {});
    QCOMPARE(layout.sheets.size(), 2U);
    QVERIFY(layout.sheets[1].size == Vec2(300, 200));
    QCOMPARE(whatIsWrong(layout, parts, {}), QString());
}

// Wrong: a plate would be wasted on what fits on the one before.
void TestLayout::shelvesAreFilled()
{
    const Model model{newDocument(), {}};
    // 11 columns of 50 + 2 mm and 7 rows fill 590 x 390.
    const std::vector<Part> parts =
        rectangles(std::vector<Vec2>(77, Vec2(50, 50)), model.document.currentStock);
    QCOMPARE(layOut(parts, model, {}).sheets.size(), 1U);
}

// Wrong: the same model would give another file every time.
void TestLayout::sameInputSameLayout()
{
    const Model model{newDocument(), {}};
    std::vector<Vec2> sizes;
    for (int i = 0; i < 50; ++i)
        sizes.emplace_back(10 + i % 5, 20 + i % 3);
    const std::vector<Part> parts = rectangles(sizes, model.document.currentStock);
    const Layout a = layOut(parts, model, {}), b = layOut(parts, model, {});
    QCOMPARE(a.sheets.size(), b.sheets.size());
    for (std::size_t i = 0; i < a.sheets[0].placements.size(); ++i) {
        QCOMPARE(a.sheets[0].placements[i].part, b.sheets[0].placements[i].part);
        QVERIFY(a.sheets[0].placements[i].offset == b.sheets[0].placements[i].offset);
    }
}

// Wrong: an empty file with one empty plate.
void TestLayout::nothingGivesNoSheet()
{
    QVERIFY(layOut({}, Model{newDocument(), {}}, {}).sheets.empty());
}

/// On all sheets from the first on.
std::pair<std::size_t, Skyline::Place>
putBySearching(std::vector<Skyline> &sheets, const Vec2 &size, const std::vector<Vec2> &boxes)
{
    for (std::size_t sheet = 0;; ++sheet) {
        if (sheet == sheets.size())
            sheets.emplace_back(size);
        Skyline::Place best{Vec2::Zero(), std::numeric_limits<double>::infinity()};
        std::size_t which = 0;
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const Skyline::Place place = sheets[sheet].find(boxes[i]);
            if (place.top < best.top) {
                best = place;
                which = i;
            }
        }
        if (best.top < std::numeric_limits<double>::infinity()) {
            sheets[sheet].put(boxes[which], best);
            return {sheet, best};
        }
    }
}

// Wrong: what is known of full sheets would leave out one that has room, and more would be cut.
void TestLayout::boxesGoOnTheFirstSheetWithRoom()
{
    std::mt19937 random(91);
    const Vec2 size(100.0, 80.0);
    for (const int sizes : {3, 20, 100000}) {
        std::uniform_int_distribution<int> step(1, 78 * sizes);
        OpenSheets ours(size);
        std::vector<Skyline> theirs;
        for (int i = 0; i < 600; ++i) {
            // Few sizes come often, and larger ones behind smaller ones.
            const Vec2 box = Vec2(1 + step(random) % (40 * sizes), 1 + step(random)) / sizes;
            std::vector<Vec2> boxes{box};
            if (i % 3 > 0)
                boxes.push_back({box.y(), box.x()});
            const OpenSheets::Place place = ours.put(boxes);
            const auto [sheet, on] = putBySearching(theirs, size, boxes);
            QCOMPARE(place.sheet, sheet);
            QVERIFY(place.on.corner == on.corner && place.on.top == on.top);
            QCOMPARE(ours.count(), theirs.size());
        }
        QVERIFY(ours.count() > 20);
    }
}

// Wrong: laying out would cost the parts times the sheets.
void TestLayout::equalBoxesSearchEachSheetOnce()
{
    for (const std::size_t count : {1000, 16000}) {
        OpenSheets sheets({600.0, 400.0});
        const std::array<Vec2, 2> lying{Vec2(60, 40), Vec2(40, 60)}, large{Vec2(90, 45)};
        for (std::size_t i = 0; i < count; ++i) {
            sheets.put(lying);
            sheets.put({large.data(), 1});
        }
        QVERIFY(sheets.searches() <= 3 * count + 3 * sheets.count());
    }
}

// Wrong: every edit would lay out all parts anew, or parts that grew would lie on others.
void TestLayout::whatLayLiesWhereItLay()
{
    const Document document = newDocument();
    const Model model = evaluate(document);
    const StockId stock = document.stocks.front()->id;
    const auto sized = [&](double width, double area) {
        OutlineSize size;
        size.area = area;
        size.drawn.box.extend(Vec2::Zero());
        size.drawn.box.extend(Vec2(width, 30.0));
        size.smallest = size.lowest = size.drawn;
        return SizedPart{stock, std::make_shared<const OutlineSize>(size)};
    };
    std::vector<SizedPart> parts(40, sized(70.0, 2000.0));
    LayoutCache cache;
    const Layout first = layOutBySize(parts, model, {}, cache);
    const auto sheets = cache.stocks.front().sheets;
    parts[7] = sized(70.0, 1500.0); // cut deeper
    const Layout second = layOutBySize(parts, model, {}, cache);
    QVERIFY(cache.stocks.front().sheets == sheets);
    QVERIFY(usedShare(second, parts) < usedShare(first, std::vector<SizedPart>(40, parts[0])));

    LayoutOptions wider;
    wider.spacing = 9.0;
    std::vector<SizedPart> grown = parts;
    grown[7] = sized(90.0, 1500.0);
    for (const auto &[now, options] : {std::pair(grown, LayoutOptions()), {parts, wider}}) {
        const Layout ours = layOutBySize(now, model, options, cache);
        const Layout theirs = layOutBySize(now, model, options);
        QVERIFY(cache.stocks.front().sheets != sheets);
        QCOMPARE(ours.sheets.size(), theirs.sheets.size());
        for (std::size_t i = 0; i < ours.sheets.size(); ++i) {
            QCOMPARE(ours.sheets[i].placements.size(), theirs.sheets[i].placements.size());
            for (std::size_t k = 0; k < ours.sheets[i].placements.size(); ++k)
                QVERIFY(ours.sheets[i].placements[k].offset ==
                        theirs.sheets[i].placements[k].offset);
        }
    }
}

FFF_TEST(TestLayout)
#include "tst_layout.moc"
