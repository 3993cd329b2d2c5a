// What Clipper and CGAL cannot do is an error, never an empty region.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/base/fault_point.h"
#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/geometry/halfplane_clip.h"
#include "core/geometry/line_clip.h"
#include "core/geometry/outlines.h"
#include "core/geometry/symmetrised.h"
#include "core/geometry/triangulation.h"
#include "core/model/mended_shape.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <functional>
#include <limits>

using namespace fff;
using namespace fff::test;

namespace {

using Call = std::function<std::optional<ErrorCode>()>;

template <class T>
std::optional<ErrorCode> codeOf(const Result<T> &result)
{
    return result ? std::nullopt : std::optional(result.error().code);
}

const Halfplane kUpper{{0, 0}, {0, 1}};

/// Touches itself in a cut without width, through the line y = 0: only a boolean tells what stays.
Contour touching()
{
    return polygonContour({{-20, -10}, {20, -10}, {20, 20}, {0, 20}, {0, -5}, {0, 20}, {-20, 20}});
}

} // namespace

class TestGeometryFaults : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyCallThatFailsSaysSo_data();
    void everyCallThatFailsSaysSo();
    void onlyTheWatchedCallFails();
    void pointsThatAreNowhereAreAnError();
    void whatIsKnownToBeAContourCannotFail();
    void shapesStayWithinTheirBounds();
    void aLoopOfOneCurveIsKept();
};

void TestGeometryFaults::everyCallThatFailsSaysSo_data()
{
    QTest::addColumn<Call>("call");
    const Contour disc = circle({0, 0}, 20), other = circle({15, 0}, 10);
    const auto row = [](const char *name, Call call) { QTest::newRow(name) << call; };
    row("subtract", [=] { return codeOf(subtract(disc, {}, {rectangleAt(-1, -1, 9, 9)}, 0.01)); });
    row("subtractContours", [=] { return codeOf(subtractContours(disc, {other}, {other}, 0.01)); });
    row("windingRegions", [=] {
        return codeOf(windingRegions({disc, other}, WindingRule::NonZero, 0.01));
    });
    row("resolveCrossings",
        [contour = figureEight()] { return codeOf(resolveCrossings(contour)); });
    row("clip at a line", [contour = touching()] { return codeOf(clip(contour, {}, kUpper)); });
    row("mirroredHalf", [=] { return codeOf(mirroredHalf(disc, {}, kUpper)); });
    row("repeatedSector", [=] { return codeOf(repeatedSector(disc, {}, {0, 0}, 3, 0.1)); });
    row("clippedLine", [=] {
        return codeOf(clippedLine({{-50, 0}, {50, 0}}, {disc.polygon(0.1), {}}));
    });
    row("triangulate", [=] { return codeOf(triangulate({disc.polygon(0.1), {}})); });
    row("makeMendedShape", [=] {
        std::vector<Warning> warnings;
        return codeOf(makeMendedShape({disc, {}}, {{other, {}}}, {}, warnings));
    });
    row("outlinesOf",
        [contour = figureEight()] { return codeOf(outlinesOf({CurvePath::around(contour)})); });
    row("a contour", [=] { return codeOf(Contour::fromPoints(disc.points())); });
}

// Wrong: a failure would be taken for a part of which nothing is left.
void TestGeometryFaults::everyCallThatFailsSaysSo()
{
    QFETCH(Call, call);
    std::array<int, kFaultPoints> calls{};
    {
        const FaultWatch watch;
        QVERIFY(!call());
        for (std::size_t kind = 0; kind < kFaultPoints; ++kind)
            calls[kind] = watch.calls(static_cast<FaultPoint>(kind));
    }
    QVERIFY(std::any_of(calls.begin(), calls.end(), [](int count) { return count > 0; }));
    for (std::size_t kind = 0; kind < kFaultPoints; ++kind) {
        for (int i = 0; i < calls[kind]; ++i) {
            const FaultWatch watch(static_cast<FaultPoint>(kind), i);
            QCOMPARE(call(), std::optional(ErrorCode::NotWorkedOut));
        }
    }
    QVERIFY(!call());
}

// Wrong: the tests of failures would show nothing, or the program would fail by itself.
void TestGeometryFaults::onlyTheWatchedCallFails()
{
    const Region region{circle({0, 0}, 20).polygon(0.1), {}};
    QVERIFY(!FaultWatch::isWatching());
    {
        const FaultWatch watch(FaultPoint::Triangles, 1);
        QVERIFY(triangulate(region));
        QVERIFY(!triangulate(region));
        QVERIFY(triangulate(region));
        QCOMPARE(watch.calls(FaultPoint::Triangles), 3);
        QCOMPARE(watch.calls(FaultPoint::Boolean), 0);
    }
    QVERIFY(!FaultWatch::isWatching());
}

// Wrong: numbers beyond the grid would be rounded to places that nobody drew.
void TestGeometryFaults::pointsThatAreNowhereAreAnError()
{
    const Contour plate = polygonContour(rectangleAt(0, 0, 40, 40));
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity(), 1e30}) {
        const Polygon nowhere{{10, 10}, {20, bad}, {20, 20}};
        QCOMPARE(codeOf(subtract(plate, {}, {nowhere}, 0.01)), std::optional(ErrorCode::NonFinite));
        QCOMPARE(codeOf(windingRegions({plate, Contour::ofPolygon(nowhere)}, WindingRule::Positive,
                                       0.01)),
                 std::optional(ErrorCode::NonFinite));
    }
}

// Wrong: a slit at the edge of what a document may hold would not be cut, and nobody would know.
void TestGeometryFaults::whatIsKnownToBeAContourCannotFail()
{
    const double edge = kMaxCoordinate;
    const Contour plate = polygonContour(rectangleAt(edge - 40, 0, 40, 40));
    const Polygon beyond = rectangleAt(edge - 10, 10, 20, 3);
    QVERIFY(!Contour::fromPolygon(beyond));
    const auto left = subtract(plate, {}, {beyond}, 0.01);
    QVERIFY(left);
    QCOMPARE(left->size(), std::size_t(1));
    QVERIFY(std::abs(left->front().outer.signedArea() - (1600.0 - 30.0)) < 1e-3);
}

// Wrong: a file would be written that cannot be read again.
void TestGeometryFaults::shapesStayWithinTheirBounds()
{
    const auto beyond =
        Shape::make(Contour::ofPolygon(rectangleAt(kMaxCoordinate - 10, 0, 40, 40)));
    QVERIFY(!beyond);
    QCOMPARE(beyond.error().code, ErrorCode::BadValue);
}

// Wrong: a loop that a single curve makes would come back as chords, or not at all.
void TestGeometryFaults::aLoopOfOneCurveIsKept()
{
    const Contour contour = Contour::ofSegments(
        {{{0, 0}, {60, 40}, {-50, 40}, {10, 0}}, CubicBezier::line({10, 0}, {0, 0})});
    const auto resolved = resolveCrossings(contour);
    QVERIFY(resolved);
    QVERIFY(resolved->wasCrossing);
    QCOMPARE(resolved->contour.segmentCount(), 2);
}

FFF_TEST(TestGeometryFaults)
#include "tst_geometry_faults.moc"
