#include "core/base/tolerances.h"
#include "core/geometry/contour.h"
#include "core/model/section.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <QTest>

#include <thread>

using namespace fff;
using namespace fff::test;

class TestShape : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void contourTurnsCounterClockwiseAndHolesClockwise();
    void withoutAreaThereIsNoShape_data();
    void withoutAreaThereIsNoShape();
    void momentsAreThoseOfTheCurves();
    void regionFollowsTheCurves();
    void sameCurvesAreEqualShapes();
    void derivedValuesAreMadeOnceFromAnyThread();
    void worldBoundsHoldTheSection();
};

// Wrong: inside and outside would be mixed up everywhere else.
void TestShape::contourTurnsCounterClockwiseAndHolesClockwise()
{
    for (const bool reversed : {false, true}) {
        const Contour outer = circle({0, 0}, 20), hole = circle({5, 0}, 5);
        const auto shape =
            Shape::make(reversed ? outer.reversed() : outer, {reversed ? hole : hole.reversed()});
        QVERIFY(shape);
        QVERIFY((*shape)->contour().signedArea() > 0.0);
        QVERIFY((*shape)->holes()[0].signedArea() < 0.0);
    }
}

void TestShape::withoutAreaThereIsNoShape_data()
{
    QTest::addColumn<std::vector<Contour>>("contours");
    const auto row = [](const char *name, const std::vector<Contour> &contours) {
        QTest::newRow(name) << contours;
    };
    row("nothing", {Contour()});
    row("a line", {polygonContour({{0, 0}, {10, 10}, {20, 20}})});
    row("a speck of dust", {polygonContour(rectangleAt(0, 0, 0.02, 0.02))});
    row("a hole as large as the contour", {circle({0, 0}, 10), circle({0, 0}, 10)});
}

// Wrong: a section that weighs nothing or less would get into the analysis.
void TestShape::withoutAreaThereIsNoShape()
{
    QFETCH(std::vector<Contour>, contours);
    const auto shape = Shape::make(contours.front(), {contours.begin() + 1, contours.end()});
    QVERIFY(!shape);
    QVERIFY(shape.error().code == ErrorCode::EmptyContour);
}

// Wrong: the mass would depend on how finely something was drawn.
void TestShape::momentsAreThoseOfTheCurves()
{
    const ShapePointer ring = *Shape::make(circle({10, 0}, 20), {circle({10, 0}, 10)});
    const double expected = circle({0, 0}, 20).signedArea() - circle({0, 0}, 10).signedArea();
    QVERIFY(std::abs(ring->area() - expected) < 1e-9);
    QVERIFY((ring->centroid() - Vec2(10, 0)).norm() < 1e-9);
    QCOMPARE(ring->controlPointCount(), 24);
}

// Wrong: what is cut would not be what was drawn.
void TestShape::regionFollowsTheCurves()
{
    const ShapePointer ring = *Shape::make(circle({10, 0}, 20), {circle({10, 0}, 10)});
    QCOMPARE(ring->region().holes.size(), 1U);
    QVERIFY(std::abs(area(ring->region()) - ring->area()) < kCutChord * 200.0);
    QVERIFY((ring->bounds().size() - Vec2(40, 40)).norm() < 2.0 * kCutChord + 0.02);
    QVERIFY(ring->flatten(1.0).outer.size() < ring->region().outer.size());
    QCOMPARE(&ring->region(), &ring->region());
}

// Wrong: a file that was saved and read again would seem changed.
void TestShape::sameCurvesAreEqualShapes()
{
    const ShapePointer a = *Shape::make(circle({0, 0}, 20)), b = *Shape::make(circle({0, 0}, 20));
    QVERIFY(*a == *b);
    QVERIFY(!(*a == **Shape::make(circle({0, 0}, 21))));
    QVERIFY(!(*a == **Shape::make(circle({0, 0}, 20), {circle({0, 0}, 5)})));
}

// Wrong: a job and the window would race for one shape's triangles.
void TestShape::derivedValuesAreMadeOnceFromAnyThread()
{
    const ShapePointer shape = *Shape::make(circle({0, 0}, 20));
    std::vector<const Triangulation *> seen(4);
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < seen.size(); ++i)
        threads.emplace_back([&, i] { seen[i] = &*shape->triangulation(); });
    for (std::thread &thread : threads)
        thread.join();
    for (const Triangulation *t : seen) {
        QCOMPARE(t, seen[0]);
        QVERIFY(!t->triangles.empty());
    }
}

// Wrong: the camera would not show all, the sweep for joints would miss some.
void TestShape::worldBoundsHoldTheSection()
{
    const ShapePointer shape = *Shape::make(circle({0, 0}, 20));
    const Frame frame = *makeFrame({5, 6, 7}, {1, 1, 0}, {0, 1, 1});
    const Box3 box = worldBounds(*shape, frame);
    for (const Vec2 &p : shape->region().outer) {
        const Vec3 world = frame.toWorld(p);
        QVERIFY((world.array() >= box.min.array() - 1e-9).all());
        QVERIFY((world.array() <= box.max.array() + 1e-9).all());
    }
}

FFF_TEST(TestShape)
#include "tst_shape.moc"
