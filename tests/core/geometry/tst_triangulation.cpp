#include "core/geometry/sweep_triangulation.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <QTest>

using namespace fff;
using namespace fff::test;

namespace {

/// Sum of all triangles; -1 when one is not counter-clockwise.
double triangleArea(const Triangulation &t)
{
    double sum = 0.0;
    for (const auto &[a, b, c] : t.triangles) {
        const auto p = [&](int i) { return t.points[static_cast<std::size_t>(i)]; };
        const double area = 0.5 * cross(p(b) - p(a), p(c) - p(a));
        if (area < 0.0)
            return -1.0;
        sum += area;
    }
    return sum;
}

} // namespace

class TestTriangulation : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void trianglesFillTheRegion_data();
    void trianglesFillTheRegion();
    void holesStayOpen();
    void holeThatTouchesTheOutside();
    void holeThatSharesAnEdge();
    void plainRegionsNeedNoDelaunay();
    void touchingRegionsAreLeftToIt();
    void noSlivers();
    void nothingForNoArea_data();
    void nothingForNoArea();
};

void TestTriangulation::trianglesFillTheRegion_data()
{
    QTest::addColumn<int>("shape");
    const std::vector<NamedContour> shapes = simpleContours();
    for (std::size_t i = 0; i < shapes.size(); ++i)
        QTest::newRow(shapes[i].name) << static_cast<int>(i);
}

// Wrong: faces in the view would have gaps or reach over the edge.
void TestTriangulation::trianglesFillTheRegion()
{
    QFETCH(int, shape);
    const Polygon polygon =
        simpleContours()[static_cast<std::size_t>(shape)].contour.flatten(0.05).points;
    const double expected = std::abs(signedArea(polygon));
    QVERIFY(std::abs(triangleArea(*triangulate({polygon, {}})) - expected) <= 1e-9 * expected);
}

// Wrong: one could not see through a hole.
void TestTriangulation::holesStayOpen()
{
    const Region region{
        rectangleAt(0, 0, 40, 40),
        {circle({20, 20}, 8).reversed().flatten(0.05).points, rectangleAt(2, 2, 3, 3)}};
    QVERIFY(std::abs(triangleArea(*triangulate(region)) - area(region)) < 1e-9);
}

// Wrong: a slit that just reaches the contour would crash the view.
void TestTriangulation::holeThatTouchesTheOutside()
{
    const Region corner{rectangleAt(0, 0, 40, 40), {{{0, 20}, {10, 25}, {10, 15}}}};
    QVERIFY(std::abs(triangleArea(*triangulate(corner)) - area(corner)) < 1e-9);
}

// Wrong: the hole would be filled and the material left open, as the shared edge counts once only.
void TestTriangulation::holeThatSharesAnEdge()
{
    const Polygon square = rectangleAt(0, 0, 40, 40);
    const Region whole{square, {{{0, 0}, {0, 40}, {10, 40}, {10, 0}}}};
    QVERIFY(std::abs(triangleArea(*triangulate(whole)) - area(whole)) < 1e-9);
    const Region partly{square, {{{0, 10}, {0, 30}, {10, 30}, {10, 10}}}};
    QVERIFY(std::abs(triangleArea(*triangulate(partly)) - area(partly)) < 1e-9);
    const Region pair{
        square,
        {{{10, 10}, {10, 20}, {20, 20}, {20, 10}}, {{20, 10}, {20, 20}, {30, 20}, {30, 10}}}};
    QVERIFY(std::abs(triangleArea(*triangulate(pair)) - area(pair)) < 1e-9);
}

// Wrong: a drag waits for triangles; or the quick ones have gaps, lie over each other or leave a
// vertex out, so that a crack opens at the wall.
void TestTriangulation::plainRegionsNeedNoDelaunay()
{
    std::mt19937 random(20140929);
    for (int round = 0; round < 200; ++round) {
        Region region;
        region.outer = blob(random, 5 + round % 40, 40).flatten(0.01 + 0.001 * round).points;
        if (round % 3 > 0)
            region.holes.push_back(blob(random, 7, 12).reversed().flatten(0.02).points);
        if (round % 5 == 0) // along the axes, with much that is in line
            region = {comb(2 + round % 13).flatten(0.05).points, {}};
        if (signedArea(region.outer) < 0.0)
            std::reverse(region.outer.begin(), region.outer.end());
        for (Polygon &hole : region.holes)
            if (signedArea(hole) > 0.0)
                std::reverse(hole.begin(), hole.end());
        std::size_t vertices = region.outer.size();
        for (const Polygon &hole : region.holes)
            vertices += hole.size();
        const auto triangles = sweepTriangles(region);
        QVERIFY2(triangles.has_value(), qPrintable(QString::number(round)));
        QCOMPARE(triangles->points.size(), vertices);
        QCOMPARE(triangles->triangles.size(), vertices + 2 * region.holes.size() - 2);
        QVERIFY(std::abs(triangleArea(*triangles) - area(region)) <= 1e-9 * area(region));
    }
}

// Wrong: the sweep takes on what it cannot do.
void TestTriangulation::touchingRegionsAreLeftToIt()
{
    const Polygon square = rectangleAt(0, 0, 40, 40);
    QVERIFY(!sweepTriangles({square, {{{0, 20}, {10, 25}, {10, 15}}}})); // on an edge
    QVERIFY(!sweepTriangles({{{0, 0}, {20, -10}, {20, 10}, {0, 0}, {-20, 10}, {-20, -10}}, {}}));
    QVERIFY(!sweepTriangles({{{0, 0}, {40, 30}, {40, 0}, {0, 20}}, {}}));
    QVERIFY(!sweepTriangles({square, {{{1, 1}, {2, 2}}}}));
}

// Wrong: a triangle turns inside out when it is rounded to a float.
void TestTriangulation::noSlivers()
{
    // What is symmetric has vertices above each other but for rounding.
    const Region region{circle({0, 0}, 30).flatten(0.01).points,
                        {circle({0, 0}, 17).reversed().flatten(0.01).points}};
    const auto t = sweepTriangles(region);
    QVERIFY(t.has_value());
    for (const auto &[a, b, c] : t->triangles) {
        const auto p = [&](int i) { return t->points[static_cast<std::size_t>(i)]; };
        const double longest =
            std::max({(p(b) - p(a)).norm(), (p(c) - p(b)).norm(), (p(a) - p(c)).norm()});
        QVERIFY(cross(p(b) - p(a), p(c) - p(a)) > 1e-4 * longest);
    }
    QVERIFY(std::abs(triangleArea(*t) - area(region)) <= 1e-9 * area(region));
}

void TestTriangulation::nothingForNoArea_data()
{
    QTest::addColumn<std::vector<Vec2>>("polygon");
    QTest::newRow("no points") << Polygon{};
    QTest::newRow("one point") << Polygon{{1, 1}};
    QTest::newRow("a line") << Polygon{{0, 0}, {5, 5}, {10, 10}};
    QTest::newRow("the same point three times") << Polygon{{1, 1}, {1, 1}, {1, 1}};
}

// Wrong: a crash while a stroke has only begun.
void TestTriangulation::nothingForNoArea()
{
    QFETCH(std::vector<Vec2>, polygon);
    QVERIFY(triangulate({polygon, {}})->triangles.empty());
}

FFF_TEST(TestTriangulation)
#include "tst_triangulation.moc"
