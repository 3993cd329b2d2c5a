// The order in which a machine follows lines. If this fails, parts fall before they are done, or a
// line is burnt twice.
#include "core/fabrication/cutting_order.h"
#include "core/model/edits.h"
#include "tests/core/assembly/plates.h"
#include "tests/core/fabrication/parts_of.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>

using namespace fff;
using namespace fff::test;

class TestCuttingOrder : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void engravedThenScoredThenHolesThenOutsides();
    void whatLiesInAHoleIsCutBeforeTheHole();
    void allLinesAreThere();
    void nextIsTheNearest();
    void noLineTwice();
    void manyPartsTakeLittleTime();
    void timeIsByTheSpeeds();
};

namespace {

/// Parts made by hand, each where it is put.
CuttingSheet sheetOf(std::vector<Part> parts, std::vector<Engraving> engravings,
                     const std::vector<Vec2> &places)
{
    const auto source = std::make_shared<const CuttingPart::Source>(
        CuttingPart::Source{std::move(parts), std::move(engravings)});
    CuttingSheet sheet;
    sheet.size = {600, 400};
    for (std::size_t i = 0; i < places.size(); ++i) {
        Placement placement;
        placement.part = static_cast<int>(i);
        placement.offset = places[i];
        sheet.parts.emplace_back(source, placement, "part");
    }
    return sheet;
}

Part partOf(const CurvedRegion &outline, int number)
{
    Part part;
    part.number = number;
    part.outline = outline;
    return part;
}

CurvedRegion ring(double outer, double inner)
{
    return regionOf(circle({0, 0}, outer), {circle({0, 0}, inner)});
}

Engraving marked()
{
    Engraving engraving;
    engraving.hasNumber = true;
    engraving.strokes.start();
    for (const Vec2 &p : {Vec2(0, 0), Vec2(0, 3), Vec2(1, 3)})
        engraving.strokes.add(p);
    engraving.lines.engraved.push_back(*CurvePath::fromLine({{4, 0}, {6, 0}}));
    engraving.lines.scored.push_back(*CurvePath::fromLine({{-6, 0}, {-4, 0}}));
    return engraving;
}

std::vector<Purpose> purposesOf(const std::vector<ToolLine> &lines)
{
    std::vector<Purpose> purposes;
    for (const ToolLine &line : lines)
        if (purposes.empty() || purposes.back() != line.purpose)
            purposes.push_back(line.purpose);
    return purposes;
}

double lengthOfAll(const std::vector<ToolLine> &lines)
{
    double length = 0.0;
    for (const ToolLine &line : lines)
        length += lengthOf(line);
    return length;
}

} // namespace

void TestCuttingOrder::engravedThenScoredThenHolesThenOutsides()
{
    const CuttingSheet sheet = sheetOf({partOf(ring(20, 12), 1), partOf(ring(20, 12), 2)},
                                       {marked(), marked()}, {{50, 50}, {150, 50}});
    const std::vector<Purpose> purposes = purposesOf(inCuttingOrder(sheet));
    const auto firstOf = [&](Purpose purpose) {
        return std::find(purposes.begin(), purposes.end(), purpose);
    };
    const auto lastOf = [&](Purpose purpose) {
        return std::find(purposes.rbegin(), purposes.rend(), purpose).base();
    };
    QVERIFY(lastOf(Purpose::Engrave) <= firstOf(Purpose::Score));
    QVERIFY(lastOf(Purpose::Number) <= firstOf(Purpose::Score));
    QVERIFY(lastOf(Purpose::Score) <= firstOf(Purpose::InnerCut));
    QVERIFY(lastOf(Purpose::InnerCut) <= firstOf(Purpose::OuterCut));
    QVERIFY(lastOf(Purpose::OuterCut) == purposes.end());
}

// A disc in the hole of a ring in the hole of a ring: from within, whatever is nearer.
void TestCuttingOrder::whatLiesInAHoleIsCutBeforeTheHole()
{
    const CuttingSheet sheet =
        sheetOf({partOf(ring(90, 80), 1), partOf(ring(70, 60), 2),
                 partOf(regionOf(circle({0, 0}, 20)), 3), partOf(regionOf(circle({0, 0}, 5)), 4)},
                {}, {{100, 100}, {100, 100}, {100, 100}, {300, 100}});
    std::vector<std::size_t> outsides;
    std::vector<std::pair<std::size_t, Purpose>> order;
    for (const ToolLine &line : inCuttingOrder(sheet, {300, 100}))
        order.emplace_back(line.part, line.purpose);
    const auto place = [&](std::size_t part, Purpose purpose) {
        return std::find(order.begin(), order.end(), std::pair(part, purpose)) - order.begin();
    };
    QCOMPARE(order.size(), std::size_t(6));
    QVERIFY(place(2, Purpose::OuterCut) < place(1, Purpose::InnerCut));
    QVERIFY(place(1, Purpose::InnerCut) < place(1, Purpose::OuterCut));
    QVERIFY(place(1, Purpose::OuterCut) < place(0, Purpose::InnerCut));
    QVERIFY(place(0, Purpose::InnerCut) < place(0, Purpose::OuterCut));
}

void TestCuttingOrder::allLinesAreThere()
{
    const CuttingSheet sheet = sheetOf({partOf(ring(20, 12), 1), partOf(ring(30, 12), 2)},
                                       {marked(), marked()}, {{50, 50}, {150, 50}});
    const std::vector<ToolLine> drawn = toolLines(sheet), ordered = inCuttingOrder(sheet);
    QCOMPARE(ordered.size(), drawn.size());
    QVERIFY(std::abs(lengthOfAll(ordered) - lengthOfAll(drawn)) < 1e-9);
    for (const ToolLine &line : ordered) {
        QVERIFY(!line.isClosed || line.start() == line.end());
        for (std::size_t i = 1; i < line.curves.size(); ++i)
            QVERIFY(line.curves[i - 1].p3 == line.curves[i].p0);
    }
    QVERIFY(std::abs(wayAlong(ordered, usualMachine()).cut - 2.0 * M_PI * (20 + 12 + 30 + 12)) <
            0.2);
}

// Discs in a row, given in no order: the tool goes along the row, not to and fro.
void TestCuttingOrder::nextIsTheNearest()
{
    std::vector<Part> parts;
    std::vector<Vec2> places;
    for (const int x : {5, 1, 4, 0, 3, 2}) {
        parts.push_back(partOf(regionOf(circle({0, 0}, 10)), x));
        places.emplace_back(30.0 * x + 15.0, 15.0);
    }
    const CuttingSheet sheet = sheetOf(std::move(parts), {}, places);
    std::vector<int> numbers;
    for (const ToolLine &line : inCuttingOrder(sheet))
        numbers.push_back(sheet.parts[line.part].number());
    QCOMPARE(numbers, (std::vector{0, 1, 2, 3, 4, 5}));
}

// The same line, begun elsewhere and run the other way, is the same line; another is not.
void TestCuttingOrder::noLineTwice()
{
    const Contour square = *Contour::fromPolygon(rectangle(0, 0, 20, 20));
    std::vector<CubicBezier> turned;
    for (int i = 0; i < 4; ++i)
        turned.push_back(square.segment((i + 2) % 4));
    Part plain = partOf(regionOf(square), 1), other = plain;
    other.outline.outer = Contour::ofSegments(turned).reversed();
    Engraving twice;
    for (int i = 0; i < 2; ++i)
        twice.lines.engraved.push_back(
            *CurvePath::fromLine({{4.0 + 12.0 * i, 5}, {16.0 - 12.0 * i, 5}}));
    const std::vector<ToolLine> lines =
        inCuttingOrder(sheetOf({plain, other}, {twice, Engraving()}, {{50, 50}, {50, 50}}));
    QCOMPARE(lines.size(), std::size_t(2));
    QCOMPARE(
        inCuttingOrder(sheetOf({plain, other}, {twice, Engraving()}, {{50, 50}, {51, 50}})).size(),
        std::size_t(3));
}

// Each next line is looked for in a tree: among all, this would be the test that never ends.
void TestCuttingOrder::manyPartsTakeLittleTime()
{
    constexpr int kCount = 5000;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> anywhere(0.0, 9000.0);
    std::vector<Part> parts;
    std::vector<Vec2> places;
    const CurvedRegion outline = ring(4, 2);
    for (int i = 0; i < kCount; ++i) {
        parts.push_back(partOf(outline, i));
        places.emplace_back(anywhere(random), anywhere(random));
    }
    const std::vector<ToolLine> lines = inCuttingOrder(sheetOf(std::move(parts), {}, places));
    QCOMPARE(lines.size(), std::size_t(2 * kCount));
    // A tour of random points that always goes to the nearest is about 0.9 √(n · area) long.
    const double tour = std::sqrt(kCount * 9000.0 * 9000.0);
    QVERIFY(wayAlong(lines, usualMachine()).travel < 2.0 * 1.3 * tour);
}

void TestCuttingOrder::timeIsByTheSpeeds()
{
    Machine machine;
    machine.travel = 100.0;
    for (Machine::Process &process : machine.processes)
        process.speed = 10.0;
    const Contour square = *Contour::fromPolygon(rectangle(0, 0, 20, 20));
    const std::vector<ToolLine> lines =
        inCuttingOrder(sheetOf({partOf(regionOf(square), 1)}, {}, {{30, 40}}));
    const double before = lines.front().start().norm();
    const ToolWay way = wayAlong(lines, machine);
    QVERIFY(std::abs(way.cut - 80.0) < 1e-9);
    QVERIFY(std::abs(way.travel - before) < 1e-9 && before > 49.0);
    QVERIFY(std::abs(way.seconds - (8.0 + 0.01 * before)) < 1e-9);
}

FFF_TEST(TestCuttingOrder)
#include "tst_cutting_order.moc"
