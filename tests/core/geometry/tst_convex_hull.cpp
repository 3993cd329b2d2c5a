#include "core/base/tolerances.h"
#include "core/geometry/convex_hull.h"
#include "core/geometry/turning.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <QTest>

#include <numbers>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

Polygon randomPoints(std::mt19937 &random, int count, double width, double height)
{
    std::uniform_real_distribution<double> x(-width, width), y(-height, height);
    Polygon points;
    for (int i = 0; i < count; ++i)
        points.emplace_back(x(random), y(random));
    return points;
}

Vec2 sizeAt(const Polygon &polygon, double angle)
{
    return turnedBounds(polygon, {std::cos(angle), std::sin(angle)}).size();
}

} // namespace

class TestConvexHull : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hullHoldsAllPointsAndNoOthers();
    void roughHullIsTheHullToRounding();
    void fewPoints();
    void distanceHasASide();
    void turnsAreTheBestOfAll();
    void fittingTurnIsFoundWhereThereIsOne_data();
    void fittingTurnIsFoundWhereThereIsOne();
    void rectangleFitsItself_data();
    void rectangleFitsItself();
    void nothingFitsNoRoom();
};

void TestConvexHull::hullHoldsAllPointsAndNoOthers()
{
    std::mt19937 random(3);
    for (const int count : {3, 10, 200}) {
        const Polygon points = randomPoints(random, count, 50, 20);
        const Polygon hull = convexHull(points);
        QVERIFY(signedArea(hull) > 0.0);
        for (const Vec2 &p : points)
            QVERIFY(locate(p, hull) != Side::Outside);
        for (const Vec2 &corner : hull)
            QVERIFY(std::find(points.begin(), points.end(), corner) != points.end());
    }
    for (const NamedContour &shape : simpleContours()) {
        const Polygon outline = shape.contour.flatten(kCutChord).points;
        const Polygon hull = convexHull(outline);
        for (const Vec2 &p : outline)
            QVERIFY2(locate(p, hull) != Side::Outside, shape.name);
    }
}

void TestConvexHull::roughHullIsTheHullToRounding()
{
    std::mt19937 random(4);
    for (int round = 0; round < 300; ++round) {
        const int count = std::uniform_int_distribution<int>(0, round % 3 == 0 ? 12 : 400)(random);
        Polygon points = randomPoints(random, count, 50, round % 5 == 0 ? 1e-7 : 20);
        if (round % 2 == 0) // in rows, as feet stand
            for (Vec2 &p : points)
                p.y() = std::round(0.1 * p.y());
        const Polygon exact = convexHull(points), rough = roughHull(points);
        for (const Vec2 &corner : rough)
            QVERIFY(std::find(points.begin(), points.end(), corner) != points.end());
        for (const Vec2 &corner : exact)
            QVERIFY2(signedDistance(rough, corner) > -1.5 * kClipGrid, QByteArray::number(round));
        QVERIFY(count == 0 || !outermost(points).empty());
    }
    // A grid of feet: few of them make its hull.
    Polygon grid;
    for (int i = 0; i < 50; ++i)
        for (int k = 0; k < 50; ++k)
            grid.emplace_back(i, k);
    QVERIFY(outermost(grid).size() <= 8);
    QCOMPARE(roughHull(grid).size(), 4U);
}

// Feet on one line, or one foot, have a support polygon too: one without an inside.
void TestConvexHull::fewPoints()
{
    QVERIFY(convexHull({}).empty());
    QCOMPARE(convexHull({{1, 2}, {1, 2}}).size(), 1U);
    QCOMPARE(convexHull({{0, 0}, {1, 1}, {2, 2}, {0.5, 0.5}}).size(), 2U);
    QCOMPARE(convexHull({{0, 0}, {2, 0}, {1, 0}, {1, 1}}).size(), 3U);
    QCOMPARE(signedDistance({}, {1, 2}), -std::numeric_limits<double>::infinity());
    QCOMPARE(signedDistance({{0, 0}}, {3, 4}), -5.0);
    QCOMPARE(signedDistance({{0, 0}, {2, 0}}, {1, 0}), -0.0);
}

void TestConvexHull::distanceHasASide()
{
    const Polygon square = rectangleAt(0, 0, 40, 40);
    QCOMPARE(signedDistance(square, {10, 20}), 10.0);
    QCOMPARE(signedDistance(square, {40, 20}), 0.0);
    Vec2 nearest;
    QCOMPARE(signedDistance(square, {43, 44}, &nearest), -5.0);
    QVERIFY(nearest == Vec2(40, 40));
}

// No angle of a thousand may do better than the turn that is called the best.
void TestConvexHull::turnsAreTheBestOfAll()
{
    std::mt19937 random(11);
    std::vector<Polygon> polygons{rectangleAt(3, 4, 50, 10),
                                  {{0, 0}, {100, 0}, {0, 1}},
                                  turnedRectangle({0, 0}, 120, 8, 0.7)};
    for (int round = 0; round < 40; ++round)
        polygons.push_back(randomPoints(random, 3 + round % 20, 60, 5 + round));
    for (const NamedContour &shape : simpleContours())
        polygons.push_back(shape.contour.flatten(kCutChord).points);
    for (const Polygon &points : polygons) {
        const Polygon hull = convexHull(points);
        const Turns turns = findTurns(hull);
        const Vec2 smallest = turnedBounds(hull, turns.smallest).size(),
                   lowest = turnedBounds(hull, turns.lowest).size();
        QVERIFY(std::abs(turns.smallest.norm() - 1.0) < 1e-12);
        QVERIFY(smallest.x() >= smallest.y() - 1e-9 && lowest.x() >= lowest.y() - 1e-9);
        for (int i = 0; i < 1000; ++i) {
            const Vec2 size = sizeAt(hull, std::numbers::pi * i / 1000);
            QVERIFY(size.x() * size.y() > smallest.x() * smallest.y() * (1.0 - 1e-9));
            QVERIFY(size.minCoeff() > lowest.y() * (1.0 - 1e-9));
        }
    }
}

void TestConvexHull::fittingTurnIsFoundWhereThereIsOne_data()
{
    QTest::addColumn<Vec2>("room");
    QTest::newRow("a square") << Vec2(80, 80);
    QTest::newRow("a wide room") << Vec2(110, 60);
    QTest::newRow("a high room") << Vec2(60, 110);
    QTest::newRow("a narrow room") << Vec2(150, 12);
}

// A part would be called too large that a person can lay on the sheet by turning it.
void TestConvexHull::fittingTurnIsFoundWhereThereIsOne()
{
    QFETCH(Vec2, room);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> extent(2.0, 75.0);
    int count = 0;
    for (int round = 0; round < 150; ++round) {
        const double width = extent(random), height = round % 2 ? extent(random) : 3.0;
        const Polygon hull = convexHull(randomPoints(random, 4 + round % 9, width, height));
        const std::optional<Vec2> fitting = findFittingTurn(hull, room);
        // By how much the best of many angles fits; between two of them it may do better by little.
        constexpr int kAngles = 1500;
        double slack = -std::numeric_limits<double>::infinity();
        for (int i = 0; i < kAngles; ++i)
            slack =
                std::max(slack, (room - sizeAt(hull, std::numbers::pi * i / kAngles)).minCoeff());
        const double between = 160.0 * std::numbers::pi / kAngles;
        if (slack > 0.0)
            QVERIFY(fitting.has_value());
        if (slack < -between)
            QVERIFY(!fitting.has_value());
        if (fitting) {
            ++count;
            QVERIFY((room - turnedBounds(hull, *fitting).size()).minCoeff() > -2e-6);
        }
    }
    QVERIFY(count > 20 && count < 150);
}

void TestConvexHull::rectangleFitsItself_data()
{
    QTest::addColumn<double>("angle");
    for (const double angle : {0.0, 0.3, 0.25 * std::numbers::pi, 1.2, 2.0})
        QTest::newRow(qPrintable(QStringLiteral("drawn at %1 rad").arg(angle))) << angle;
}

// The room is exactly the part: only one angle does, which rounding must not lose.
void TestConvexHull::rectangleFitsItself()
{
    QFETCH(double, angle);
    const Polygon part = turnedRectangle({300, 200}, 120, 50, angle);
    QVERIFY(findFittingTurn(part, {120, 50}).has_value());
    QVERIFY(findFittingTurn(part, {50, 120}).has_value());
    QVERIFY(!findFittingTurn(part, {119.999, 50}).has_value());
    QVERIFY(!findFittingTurn(part, {120, 49.999}).has_value());
}

void TestConvexHull::nothingFitsNoRoom()
{
    const Polygon part = rectangleAt(0, 0, 3, 2);
    QVERIFY(!findFittingTurn(part, {0, 0}).has_value());
    QVERIFY(!findFittingTurn(part, {-5, 100}).has_value());
}

FFF_TEST(TestConvexHull)
#include "tst_convex_hull.moc"
