// Parts on what is left of sheets, and on sheets of several sizes. If this fails, a part is cut
// where there is no material.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/fabrication/hand_placing.h"
#include "core/fabrication/nested_layout.h"
#include "core/fabrication/sheet_supply.h"
#include "core/model/edits.h"
#include "tests/core/fabrication/parts_of.h"
#include "tests/core/nesting/nesting_oracle.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <cmath>
#include <map>
#include <numbers>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

Part plainPart(const Polygon &outline, StockId stock, int number)
{
    Part part;
    part.number = number;
    part.stock = stock;
    part.outline = regionOf(*Contour::fromPolygon(outline));
    return part;
}

Polygon star(double radius, double depth, int corners, const Vec2 &middle)
{
    Polygon points;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners;
        const double r = i % 2 == 0 ? radius : radius * (1.0 - depth);
        points.push_back(middle + r * Vec2(std::cos(angle), std::sin(angle)));
    }
    return points;
}

/// With bays, and a hole in its middle.
SpareSheet starSheet(double radius, int count)
{
    const Vec2 middle(radius, radius);
    const Outline outline{*Contour::fromPolygon(star(radius, 0.3, 10, middle)),
                          {*Contour::fromPolygon(star(0.3 * radius, 0.0, 8, middle))},
                          false};
    return spareSheet(outline, count).value();
}

Model modelWith(std::vector<SpareSheet> spares, std::optional<int> count = std::nullopt)
{
    Document document = newDocument();
    Stock stock = *document.find(document.currentStock);
    stock.spares = std::move(spares);
    stock.sheetCount = count;
    return {setStock(document, stock).value(), {}};
}

std::vector<Part> lobed(int count, unsigned seed, StockId stock)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> radius(8.0, 45.0), depth(0.0, 0.5);
    std::uniform_int_distribution<int> corners(2, 6);
    std::vector<Part> parts;
    for (int i = 0; i < count; ++i)
        parts.push_back(plainPart(star(radius(random), depth(random), 2 * corners(random), {1, 2}),
                                  stock, i + 1));
    return parts;
}

/// As the nester's oracle sees it, on the sheets' true outlines.
QString faultOnSheets(const Layout &layout, const std::vector<Part> &parts,
                      const NestOptions &options)
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
        problem.sheets.push_back({outlineOf(sheet), 1});
        solution.sheets.push_back(index);
        for (const Placement &placement : sheet.placements)
            solution.places.push_back({placement.part, index, placement.turn, placement.offset});
    }
    return test::whatIsWrong(problem, solution);
}

std::map<int, PinnedPart> placesOf(const Layout &layout)
{
    std::map<int, PinnedPart> places;
    for (const Sheet &sheet : layout.sheets)
        for (const Placement &one : sheet.placements)
            places[one.part] = {one.part, sheet.index, one.turn, one.offset, false};
    return places;
}

/// Each sheet that there is once, with the outline that it has.
QString whatIsWrongWith(const Layout &layout, const Stock &stock, const LayoutOptions &options)
{
    const SheetSupply supply(stock, options);
    std::map<int, int> times;
    for (const Sheet &sheet : layout.sheets) {
        if (!supply.has(sheet.index))
            return QStringLiteral("sheet %1 is not there").arg(sheet.index);
        if (++times[sheet.index] > 1)
            return QStringLiteral("sheet %1 is there twice").arg(sheet.index);
        if (sheet.size != supply.sheet(sheet.index).size)
            return QStringLiteral("sheet %1 has another size").arg(sheet.index);
    }
    return {};
}

} // namespace

class TestOffcuts : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void layoutsAreSound_data();
    void layoutsAreSound();
    void offcutsAreUsedUpFirst();
    void searchesUseOffcutsUp();
    void wholeSheetsCostMore();
    void theLargestPartFitsTheLargestSheetOnly();
    void sheetsBeyondThoseThatThereAre();
    void theHandFindsTheHole();
    void whatIsNoSheet();
};

void TestOffcuts::layoutsAreSound_data()
{
    QTest::addColumn<unsigned>("seed");
    QTest::addColumn<double>("margin");
    QTest::addColumn<double>("spacing");
    unsigned seed = 1;
    for (const double margin : {0.0, 1.0, 5.0, 12.0})
        for (const double spacing : {0.0, 2.0, 6.0})
            QTest::addRow("margin %g, spacing %g", margin, spacing) << seed++ << margin << spacing;
}

// Laid, laid again around half of it pinned, and searched for: sound each time, and pins stay.
void TestOffcuts::layoutsAreSound()
{
    QFETCH(unsigned, seed);
    QFETCH(double, margin);
    QFETCH(double, spacing);
    const Model model =
        modelWith({starSheet(140.0, 2), *rectangularSheet({150.0, 90.0}, 2), starSheet(70.0, 1)});
    const Stock &stock = *model.document.stocks.front();
    const std::vector<Part> parts = lobed(60, seed, stock.id);
    NestOptions options;
    options.layout.margin = margin;
    options.layout.spacing = spacing;
    const NestedLayout first = nestOut(parts, model, options);
    QCOMPARE(faultOnSheets(first.layout, parts, options), QString());
    QCOMPARE(whatIsWrongWith(first.layout, stock, options.layout), QString());

    std::mt19937 random(seed);
    for (const auto &[part, place] : placesOf(first.layout))
        if (random() % 2 == 0)
            options.pinned.push_back(place);
    options.seed = seed + 100;
    options.work = nest::workOf(0.05);
    const NestedLayout second = nestOut(parts, model, options);
    QCOMPARE(faultOnSheets(second.layout, parts, options), QString());
    QCOMPARE(whatIsWrongWith(second.layout, stock, options.layout), QString());
    QVERIFY(second.loosened.empty());
    const std::map<int, PinnedPart> places = placesOf(second.layout);
    for (const PinnedPart &pin : options.pinned)
        QVERIFY(places.at(pin.part) == pin);
    const NestedLayout again = nestOut(parts, model, options);
    QVERIFY(placesOf(again.layout) == places);
}

void TestOffcuts::offcutsAreUsedUpFirst()
{
    const Model model = modelWith({starSheet(140.0, 1)});
    const std::vector<Part> parts = lobed(6, 3, model.document.currentStock);
    const Layout layout = nestOut(parts, model, {}).layout;
    QCOMPARE(layout.sheets.size(), 1U);
    QCOMPARE(layout.sheets.front().index, -1);
    QVERIFY(layout.sheets.front().outline != nullptr);
    // Also where a part needs a whole one, on which the others would have room as well.
    std::vector<Part> more = parts;
    more.push_back(plainPart(box(0, 0, 560, 60), model.document.currentStock, 9));
    const Layout both = nestOut(more, model, {}).layout;
    QCOMPARE(both.sheets.size(), 2U);
    QCOMPARE(both.sheets.front().index, -1);
    QCOMPARE(both.sheets.back().placements.size(), 1U);
    // Where a size is asked for, there are sheets of that and nothing else.
    NestOptions options;
    options.layout.sheet = Vec2(500, 300);
    QVERIFY(nestOut(parts, model, options).layout.sheets.front().size == Vec2(500, 300));
}

// As little as possible of whole sheets is taken, at all grades: a search that looked at the number
// of sheets alone put all parts on one whole sheet, and left the offcut where it was.
void TestOffcuts::searchesUseOffcutsUp()
{
    const Model model = modelWith({*rectangularSheet({260.0, 150.0}, 1)});
    std::vector<Part> parts;
    for (int i = 0; i < 10; ++i)
        parts.push_back(
            plainPart(star(40.0 + i, 0.4, 8, {0, 0}), model.document.currentStock, i + 1));
    NestOptions options;
    const Layout quick = nestOut(parts, model, options).layout;
    QCOMPARE(quick.sheets.size(), 2U);
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        options.seed = seed;
        options.work = nest::workOf(0.3);
        const Layout layout = nestOut(parts, model, options).layout;
        QCOMPARE(faultOnSheets(layout, parts, options), QString());
        QCOMPARE(layout.sheets.size(), 2U);
        QCOMPARE(layout.sheets.front().index, -1);
        QVERIFY(!layout.sheets.front().placements.empty());
        QVERIFY(
            !(takenArea(quick, parts, options.layout) < takenArea(layout, parts, options.layout)));
    }
    // And where offcuts do for all of them, no whole one is taken.
    parts.resize(2);
    const Layout few = nestOut(parts, model, options).layout;
    QCOMPARE(few.sheets.size(), 1U);
    QCOMPARE(few.sheets.front().index, -1);
}

void TestOffcuts::wholeSheetsCostMore()
{
    const std::vector<Part> parts{plainPart(box(0, 0, 100, 100), StockId{1}, 1),
                                  plainPart(box(0, 0, 100, 100), StockId{1}, 2)};
    const auto on = [](int index, const Vec2 &size, std::vector<Placement> placements) {
        return Sheet{StockId{1}, size, std::move(placements), index, {}};
    };
    const Vec2 whole(600, 400), offcut(260, 150), at(5, 5);
    const Layout both{
        {on(-1, offcut, {{0, Vec2::UnitX(), at}}), on(0, whole, {{1, Vec2::UnitX(), at}})}, {}};
    const Layout stacked{{on(0, whole, {{0, Vec2::UnitX(), at}, {1, Vec2::UnitX(), Vec2(5, 110)}})},
                         {}};
    const Layout spare{{on(-1, offcut, {{0, Vec2::UnitX(), at}, {1, Vec2::UnitX(), Vec2(120, 5)}})},
                       {}};
    const auto taken = [&](const Layout &layout) { return takenArea(layout, parts, {}); };
    QVERIFY(taken(both) < taken(stacked));
    QVERIFY(taken(spare) < taken(both));
    QCOMPARE(taken(both).wholes, 600.0 * 110.0);
    QCOMPARE(taken(both).offcuts, 260.0 * 150.0);
}

void TestOffcuts::theLargestPartFitsTheLargestSheetOnly()
{
    const Model model = modelWith({*rectangularSheet({1000.0, 300.0}, 1)});
    const std::vector<Part> parts{plainPart(box(0, 0, 900, 250), model.document.currentStock, 1),
                                  plainPart(box(0, 0, 900, 250), model.document.currentStock, 2)};
    const Layout layout = nestOut(parts, model, {}).layout;
    QCOMPARE(layout.oversized.size(), 1U); // there is one of it
    QCOMPARE(layout.sheets.front().index, -1);
    QCOMPARE(faultOnSheets(layout, parts, {}), QString());
}

void TestOffcuts::sheetsBeyondThoseThatThereAre()
{
    const Model model = modelWith({*rectangularSheet({320.0, 220.0}, 1)}, 1);
    std::vector<Part> parts;
    for (int i = 0; i < 4; ++i)
        parts.push_back(plainPart(box(0, 0, 300, 200), model.document.currentStock, i + 1));
    const Stock &stock = *model.document.stocks.front();
    // One on the offcut; two of the others side by side on the only sheet.
    QCOMPARE(missingSheets(nestOut(parts, model, {}).layout, stock), 1);
    parts.resize(3);
    QCOMPARE(missingSheets(nestOut(parts, model, {}).layout, stock), 0);
    QCOMPARE(missingSheets(nestOut(parts, model, {}).layout, birchPlywood()), 0);
}

void TestOffcuts::theHandFindsTheHole()
{
    const Model model = modelWith({starSheet(140.0, 1)});
    const std::vector<Part> parts{plainPart(box(-8, -8, 8, 8), model.document.currentStock, 1)};
    const Layout layout = nestOut(parts, model, {}).layout;
    const HandPlacing hand(parts, layout, {}, 0);
    QVERIFY(hand.takes(0));
    QVERIFY(hand.isSound({0, Vec2::UnitX(), {140.0, 200.0}}));  // between hole and edge
    QVERIFY(!hand.isSound({0, Vec2::UnitX(), {140.0, 140.0}})); // in the hole
    QVERIFY(!hand.isSound({0, Vec2::UnitX(), {20.0, 20.0}}));   // in a corner of its box
}

void TestOffcuts::whatIsNoSheet()
{
    const Document document = newDocument();
    Stock stock = *document.find(document.currentStock);
    const auto refused = [&](auto change) {
        Stock next = stock;
        change(next);
        const Result<Document> made = setStock(document, next);
        return made ? std::string() : made.error().place;
    };
    const SpareSheet good = *rectangularSheet({100.0, 50.0}, 1);
    QCOMPARE(refused([&](Stock &s) { s.spares = {good}; }), std::string());
    QCOMPARE(refused([&](Stock &s) { s.spares = {{good.shape, 0}}; }), std::string("spares"));
    QCOMPARE(refused([&](Stock &s) { s.spares = {{nullptr, 1}}; }), std::string("spares"));
    QCOMPARE(refused([&](Stock &s) {
                 s.spares = std::vector(2, SpareSheet{good.shape, 600});
             }),
             std::string("spares"));
    QCOMPARE(refused([](Stock &s) { s.sheetCount = 0; }), std::string("sheetCount"));
    QCOMPARE(refused([](Stock &s) { s.kerfs = {{"b", 0.1}, {"a", 0.1}}; }), std::string("kerfs"));
    QCOMPARE(refused([](Stock &s) { s.kerfs = {{"a", -0.1}}; }), std::string("kerfs"));
    QCOMPARE(refused([](Stock &s) { s.nominalThickness = 0.0; }), std::string("nominalThickness"));
    QVERIFY(!rectangularSheet({0.0, 50.0}) && !rectangularSheet({-1.0, 50.0}));
    const Outline bow{*Contour::fromPolygon({{0, 0}, {100, 0}, {0, 80}, {100, 60}}), {}, false};
    QVERIFY(!spareSheet(bow));
}

FFF_TEST(TestOffcuts)
#include "tst_offcuts.moc"
