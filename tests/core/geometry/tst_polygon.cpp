#include "core/geometry/polygon.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <QTest>

using namespace fff;
using namespace fff::test;

class TestPolygon : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void areas();
    void locateInASquare_data();
    void locateInASquare();
    void windingDoesNotMatter();
    void holesAreOutside();
    void pointsBesideAnObliqueEdgeAreToldApart();
};

// Wrong: signs of areas decide which way a contour is turned.
void TestPolygon::areas()
{
    QCOMPARE(signedArea(rectangleAt(1, 1, 4, 3)), 12.0);
    QCOMPARE(signedArea(Polygon{}), 0.0);
    QCOMPARE(signedArea(Polygon{{1, 1}}), 0.0);
    Polygon clockwise = rectangleAt(1, 1, 4, 3);
    std::reverse(clockwise.begin(), clockwise.end());
    QCOMPARE(signedArea(clockwise), -12.0);
    QCOMPARE(area(Region{rectangleAt(0, 0, 10, 10), {rectangleAt(1, 1, 4, 3)}}), 88.0);
    QVERIFY(bounds(Polygon{}).isEmpty());
}

void TestPolygon::locateInASquare_data()
{
    QTest::addColumn<Vec2>("point");
    QTest::addColumn<int>("side");
    const auto row = [](const char *name, double x, double y, Side side) {
        QTest::newRow(name) << Vec2(x, y) << static_cast<int>(side);
    };
    row("the middle", 5, 5, Side::Inside);
    row("a corner", 10, 10, Side::Boundary);
    row("on a level edge", 3, 0, Side::Boundary);
    row("on an upright edge", 0, 3, Side::Boundary);
    row("level with the upper edge, outside", 12, 10, Side::Outside);
    row("level with the lower edge, outside", -2, 0, Side::Outside);
    row("just outside", 10.0000000001, 5, Side::Outside);
    row("just inside", 9.9999999999, 5, Side::Inside);
}

// Wrong: a slit would open on the wrong side where ends just touch.
void TestPolygon::locateInASquare()
{
    QFETCH(Vec2, point);
    QFETCH(int, side);
    QCOMPARE(static_cast<int>(locate(point, rectangleAt(0, 0, 10, 10))), side);
}

// Wrong: holes, which are clockwise, would not be found.
void TestPolygon::windingDoesNotMatter()
{
    std::mt19937 random(12);
    std::uniform_real_distribution<double> place(-45, 45);
    const Polygon polygon = blob(random, 9, 40).flatten(0.05).points;
    const Polygon reversed(polygon.rbegin(), polygon.rend());
    for (int i = 0; i < 200; ++i) {
        const Vec2 p(place(random), place(random));
        QVERIFY(locate(p, polygon) == locate(p, reversed));
    }
    for (const Vec2 &p : polygon)
        QVERIFY(locate(p, polygon) == Side::Boundary);
}

// Wrong: one could place a weight in the air.
void TestPolygon::holesAreOutside()
{
    const Region region{rectangleAt(0, 0, 10, 10), {rectangleAt(4, 4, 2, 2)}};
    QVERIFY(locate({5, 5}, region) == Side::Outside);
    QVERIFY(locate({4, 5}, region) == Side::Boundary);
    QVERIFY(locate({3, 5}, region) == Side::Inside);
    QVERIFY(locate({11, 5}, region) == Side::Outside);
}

// Wrong: rounding, not geometry, would decide.
void TestPolygon::pointsBesideAnObliqueEdgeAreToldApart()
{
    const Polygon triangle{{0, 0}, {3e5, 1e5}, {0, 1e5}};
    const double x = 123456.75, y = x / 3.0; // the last bit of y is rounded
    const double up = std::nextafter(y, 1e9), down = std::nextafter(y, -1e9);
    QVERIFY(locate({x, std::nextafter(up, 1e9)}, triangle) == Side::Inside);
    QVERIFY(locate({x, std::nextafter(down, -1e9)}, triangle) == Side::Outside);
}

FFF_TEST(TestPolygon)
#include "tst_polygon.moc"
