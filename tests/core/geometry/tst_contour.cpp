#include "core/base/tolerances.h"
#include "core/geometry/contour.h"
#include "tests/core/geometry/curve_distance.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <QTest>

using namespace fff;
using namespace fff::test;

class TestContour : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void badPointsAreRefused_data();
    void badPointsAreRefused();
    void segmentsCloseTheChain();
    void segmentsGoInAndComeOut();
    void reversedTwiceIsTheSame();
    void areaOfKnownShapes();
    void flattenTellsWhereEachPointIsFrom_data();
    void flattenTellsWhereEachPointIsFrom();
    void flattenLeavesOutRepeatedPoints();
    void chordsReversedAreThoseOfTheContourReversed();
};

void TestContour::badPointsAreRefused_data()
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    QTest::addColumn<std::vector<Vec2>>("points");
    QTest::addColumn<int>("error");
    QTest::newRow("none") << std::vector<Vec2>{} << static_cast<int>(ErrorCode::BadContour);
    QTest::newRow("one segment") << std::vector<Vec2>(3, Vec2(0, 0))
                                 << static_cast<int>(ErrorCode::BadContour);
    QTest::newRow("no multiple of three")
        << std::vector<Vec2>(7, Vec2(0, 0)) << static_cast<int>(ErrorCode::BadContour);
    QTest::newRow("not a number") << std::vector<Vec2>(6, Vec2(0, nan))
                                  << static_cast<int>(ErrorCode::NonFinite);
    QTest::newRow("two kilometres away")
        << std::vector<Vec2>(6, Vec2(0, 2e6)) << static_cast<int>(ErrorCode::BadValue);
}

// Wrong: a broken file would get into a document.
void TestContour::badPointsAreRefused()
{
    QFETCH(std::vector<Vec2>, points);
    QFETCH(int, error);
    const auto contour = Contour::fromPoints(points);
    QVERIFY(!contour);
    QCOMPARE(static_cast<int>(contour.error().code), error);
}

// Wrong: a gap between the last segment and the first.
void TestContour::segmentsCloseTheChain()
{
    for (const NamedContour &shape : simpleContours()) {
        const Contour &c = shape.contour;
        for (int i = 0; i < c.segmentCount(); ++i)
            QVERIFY(c.segment(i).p3 == c.segment((i + 1) % c.segmentCount()).p0);
    }
}

// Wrong: what is taken apart and put together would differ.
void TestContour::segmentsGoInAndComeOut()
{
    for (const NamedContour &shape : simpleContours()) {
        std::vector<CubicBezier> segments;
        for (int i = 0; i < shape.contour.segmentCount(); ++i)
            segments.push_back(shape.contour.segment(i));
        QVERIFY(Contour::fromSegments(segments).value() == shape.contour);
    }
}

// Wrong: turning a hole round would move it.
void TestContour::reversedTwiceIsTheSame()
{
    for (const NamedContour &shape : simpleContours()) {
        QVERIFY(shape.contour.reversed().reversed() == shape.contour);
        QVERIFY(std::abs(shape.contour.reversed().signedArea() + shape.contour.signedArea()) <=
                1e-12 * std::abs(shape.contour.signedArea()) + 1e-3 * kMinArea);
    }
    QVERIFY(Contour().reversed() == Contour());
}

// Wrong: weight and cost would be wrong from the start.
void TestContour::areaOfKnownShapes()
{
    QCOMPARE(polygonContour(rectangleAt(3, 4, 40, 20)).signedArea(), 800.0);
    QCOMPARE(polygonContour(rectangleAt(3, 4, 40, 20)).reversed().signedArea(), -800.0);
    const double disc = circle({7, 8}, 10).signedArea();
    QVERIFY(std::abs(disc - std::numbers::pi * 100.0) < 0.1);
}

void TestContour::flattenTellsWhereEachPointIsFrom_data()
{
    QTest::addColumn<int>("shape");
    const std::vector<NamedContour> shapes = simpleContours();
    for (std::size_t i = 0; i < shapes.size(); ++i)
        QTest::newRow(shapes[i].name) << static_cast<int>(i);
}

// Wrong: the booleans could not give the curves back.
void TestContour::flattenTellsWhereEachPointIsFrom()
{
    QFETCH(int, shape);
    const Contour contour = simpleContours()[static_cast<std::size_t>(shape)].contour;
    const Polyline polyline = contour.flatten(kDrawChord);
    QCOMPARE(polyline.points.size(), polyline.origins.size());
    for (std::size_t i = 0; i < polyline.points.size(); ++i) {
        const CurvePoint &origin = polyline.origins[i];
        QVERIFY(contour.segment(origin.segment).at(origin.t) == polyline.points[i]);
        QVERIFY(origin.t >= 0.0 && origin.t < 1.0);
        if (i > 0) {
            const CurvePoint &before = polyline.origins[i - 1];
            QVERIFY(std::pair(before.segment, before.t) < std::pair(origin.segment, origin.t));
            QVERIFY(polyline.points[i] != polyline.points[i - 1]);
        }
    }
    for (int i = 0; i < contour.segmentCount(); ++i) {
        for (double t : {0.0, 0.3, 0.7})
            QVERIFY(distanceTo(contour.segment(i).at(t), polyline.points) <= kDrawChord);
    }
}

// Wrong: triangulations and booleans would meet edges without length.
void TestContour::flattenLeavesOutRepeatedPoints()
{
    const Contour contour =
        polygonContour({{0, 0}, {0, 0}, {10, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}});
    QCOMPARE(contour.flatten(kCutChord).points.size(), 4U);
}

// Wrong: a slit would be cut into another segment of a contour that was drawn clockwise.
void TestContour::chordsReversedAreThoseOfTheContourReversed()
{
    for (const NamedContour &shape : simpleContours()) {
        const Contour back = shape.contour.reversed();
        const Polyline chords = shape.contour.flatten(kCutChord);
        const Polyline turned = reversed(chords, shape.contour.segmentCount());
        QCOMPARE(turned.points.size(), chords.points.size());
        QCOMPARE(turned.origins.front(), (CurvePoint{0, 0.0}));
        for (std::size_t i = 0; i < turned.points.size(); ++i) {
            const CurvePoint &origin = turned.origins[i];
            QVERIFY2((back.segment(origin.segment).at(origin.t) - turned.points[i]).norm() < 1e-9,
                     shape.name);
            QVERIFY(i == 0 || origin.segment > turned.origins[i - 1].segment ||
                    (origin.segment == turned.origins[i - 1].segment &&
                     origin.t > turned.origins[i - 1].t));
        }
    }
}

FFF_TEST(TestContour)
#include "tst_contour.moc"
