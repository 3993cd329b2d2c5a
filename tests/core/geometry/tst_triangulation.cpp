#include "core/geometry/triangulation.h"
#include "tests/core/shapes.h"

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
    QVERIFY(std::abs(triangleArea(triangulate({polygon, {}})) - expected) <= 1e-9 * expected);
}

// Wrong: one could not see through a hole.
void TestTriangulation::holesStayOpen()
{
    const Region region{
        rectangleAt(0, 0, 40, 40),
        {circle({20, 20}, 8).reversed().flatten(0.05).points, rectangleAt(2, 2, 3, 3)}};
    QVERIFY(std::abs(triangleArea(triangulate(region)) - area(region)) < 1e-9);
}

// Wrong: a slit that just reaches the contour would crash the view.
void TestTriangulation::holeThatTouchesTheOutside()
{
    const Region corner{rectangleAt(0, 0, 40, 40), {{{0, 20}, {10, 25}, {10, 15}}}};
    QVERIFY(std::abs(triangleArea(triangulate(corner)) - area(corner)) < 1e-9);
}

// Wrong: the hole would be filled and the material left open, as the shared edge counts once only.
void TestTriangulation::holeThatSharesAnEdge()
{
    const Polygon square = rectangleAt(0, 0, 40, 40);
    const Region whole{square, {{{0, 0}, {0, 40}, {10, 40}, {10, 0}}}};
    QVERIFY(std::abs(triangleArea(triangulate(whole)) - area(whole)) < 1e-9);
    const Region partly{square, {{{0, 10}, {0, 30}, {10, 30}, {10, 10}}}};
    QVERIFY(std::abs(triangleArea(triangulate(partly)) - area(partly)) < 1e-9);
    const Region pair{
        square,
        {{{10, 10}, {10, 20}, {20, 20}, {20, 10}}, {{20, 10}, {20, 20}, {30, 20}, {30, 10}}}};
    QVERIFY(std::abs(triangleArea(triangulate(pair)) - area(pair)) < 1e-9);
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
    QVERIFY(triangulate({polygon, {}}).triangles.empty());
}

QTEST_GUILESS_MAIN(TestTriangulation)
#include "tst_triangulation.moc"
