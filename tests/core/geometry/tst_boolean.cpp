#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "core/geometry/boolean.h"
#include "core/geometry/clip_grid.h"
#include "core/geometry/halfplane_clip.h"
#include "tests/core/geometry/curve_distance.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;

namespace {

constexpr double kOnCurve = 1e-9; // mm, what subtract promises

std::vector<CubicBezier> segmentsOf(const Contour &contour)
{
    std::vector<CubicBezier> segments;
    for (int i = 0; i < contour.segmentCount(); ++i)
        segments.push_back(contour.segment(i));
    return segments;
}

bool isSame(const CubicBezier &a, const CubicBezier &b)
{
    return a.p0 == b.p0 && a.p1 == b.p1 && a.p2 == b.p2 && a.p3 == b.p3;
}

bool isSameUpToStart(const Contour &a, const Contour &b)
{
    auto first = segmentsOf(a);
    const auto second = segmentsOf(b);
    for (std::size_t i = 0; i < first.size(); ++i) {
        if (std::equal(first.begin(), first.end(), second.begin(), second.end(), isSame))
            return true;
        std::rotate(first.begin(), first.begin() + 1, first.end());
    }
    return false;
}

double curvedArea(const std::vector<CurvedRegion> &regions)
{
    double sum = 0.0;
    for (const CurvedRegion &r : regions) {
        sum += r.outer.signedArea();
        for (const Contour &hole : r.holes)
            sum += hole.signedArea();
    }
    return sum;
}

double chordArea(const std::vector<CurvedRegion> &regions)
{
    double sum = 0.0;
    for (const CurvedRegion &r : regions)
        sum += area(r.region);
    return sum;
}

double totalPerimeter(const std::vector<CurvedRegion> &regions)
{
    double sum = 0.0;
    for (const CurvedRegion &r : regions) {
        sum += perimeter(r.region.outer);
        for (const Polygon &hole : r.region.holes)
            sum += perimeter(hole);
    }
    return sum;
}

/// Empty when every boundary is wound the right way, its curves lie along its chords, and its
/// curves are pieces of the sources or straight edges of cuts.
QString whatIsWrong(const std::vector<CurvedRegion> &regions, const std::vector<Contour> &sources,
                    const std::vector<Polygon> &cuts, double chord)
{
    const auto boundary = [&](const Contour &contour, const Polygon &chords,
                              bool isHole) -> QString {
        if ((contour.signedArea() < 0.0) != isHole)
            return QStringLiteral("wound the wrong way");
        // Where a cut grazes a curve, it meets the chords somewhat before the curve.
        for (const Vec2 &p : contour.flatten(10.0 * chord).points) {
            if (distanceTo(p, chords) > 10.0 * chord)
                return QStringLiteral("the curve leaves its chords by %1")
                    .arg(distanceTo(p, chords));
        }
        for (const CubicBezier &segment : segmentsOf(contour)) {
            for (double t : {0.0, 0.31, 0.77}) {
                double nearest = std::numeric_limits<double>::infinity();
                for (const Contour &source : sources)
                    nearest = std::min(nearest, distanceTo(segment.at(t), source));
                for (const Polygon &cut : cuts)
                    nearest = std::min(nearest, distanceTo(segment.at(t), cut));
                if (nearest > chord)
                    return QStringLiteral("a point is off every source by %1").arg(nearest);
            }
        }
        return {};
    };
    for (const CurvedRegion &r : regions) {
        if (const QString wrong = boundary(r.outer, r.region.outer, false); !wrong.isEmpty())
            return wrong;
        for (std::size_t i = 0; i < r.holes.size(); ++i) {
            if (const QString wrong = boundary(r.holes[i], r.region.holes[i], true);
                !wrong.isEmpty())
                return QStringLiteral("hole: ") + wrong;
        }
    }
    return {};
}

} // namespace

class TestBoolean : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void failureOfClipperIsAnError();
    void contourWithoutCutsComesBack_data();
    void contourWithoutCutsComesBack();
    void touchingContourFallsApart();
    void whatHangsByAPointFallsApart_data();
    void whatHangsByAPointFallsApart();
    void crossingsLieOnCurveAndCut_data();
    void crossingsLieOnCurveAndCut();
    void curvesAreKept();
    void slitAcrossMakesTwoParts();
    void holeStaysUnlessASlitOpensIt();
    void holesThatCrossAreCutOnTheirCurves();
    void cutsThatShareEdgesAndCorners_data();
    void cutsThatShareEdgesAndCorners();
    void cutEdgesInOneLineAreOne();
    void whatIsNoPolygonCutsNothing();
    void nothingIsLeftUnderACover();
    void turningEverythingTurnsTheResult();
    void randomCutsLeaveSoundRegions();
    void simpleContourIsNotCrossing_data();
    void simpleContourIsNotCrossing();
    void crossingContourIsResolved_data();
    void crossingContourIsResolved();
    void narrowLoopOfALongContour();
    void emptyContourIsAnError();
    void fiveHundredVerticesTwentySlits();
};

/// Clipper throws for coordinates beyond 2^62.
void TestBoolean::failureOfClipperIsAnError()
{
    constexpr std::int64_t far = std::int64_t(1) << 62;
    const GridRing huge = {{0, 0}, {far, 0}, {far, far}};
    const GridRing small = {{0, 0}, {9, 0}, {9, 9}};
    QCOMPARE(clip({huge}, Winding::NonZero, {}).error().code, ErrorCode::NotWorkedOut);
    QCOMPARE(clip({small}, Winding::NonZero, {huge}).error().code, ErrorCode::NotWorkedOut);
    QCOMPARE(clip({small}, Winding::NonZero, {})->size(), std::size_t(1));
}

void TestBoolean::contourWithoutCutsComesBack_data()
{
    QTest::addColumn<Contour>("contour");
    for (const NamedContour &shape : simpleContours()) {
        const QByteArray name(shape.name);
        if (!name.contains("touch") && !name.contains("twice") && !name.contains("below the grid"))
            QTest::newRow(shape.name) << shape.contour;
    }
}

// Wrong: sections without joints would lose or split curves when exported.
void TestBoolean::contourWithoutCutsComesBack()
{
    QFETCH(Contour, contour);
    const auto result = *subtract(contour, {}, {}, kCutChord);
    QCOMPARE(result.size(), 1U);
    QVERIFY(result[0].holes.empty());
    QVERIFY(isSameUpToStart(result[0].outer,
                            contour.signedArea() > 0.0 ? contour : contour.reversed()));
    QVERIFY(std::abs(area(result[0].region) - std::abs(contour.signedArea())) <=
            kCutChord * perimeter(result[0].region.outer));
}

// Wrong: two plates that hang together in one point would be one part.
void TestBoolean::touchingContourFallsApart()
{
    const Contour two =
        polygonContour({{0, 0}, {20, -10}, {20, 10}, {0, 0}, {-20, 10}, {-20, -10}});
    const auto result = *subtract(two, {}, {}, kCutChord);
    QCOMPARE(result.size(), 2U);
    QCOMPARE(curvedArea(result), 400.0);
    QCOMPARE(whatIsWrong(result, {two}, {}, kCutChord), QString());
}

void TestBoolean::whatHangsByAPointFallsApart_data()
{
    QTest::addColumn<double>("wall");
    QTest::addColumn<std::size_t>("pieces");
    QTest::newRow("on the corner") << 20.0 << std::size_t(2);
    QTest::newRow("a step of the grid off, which is rounding")
        << 20.0 + kClipGrid << std::size_t(2);
    QTest::newRow("the same on the other side") << 20.0 - kClipGrid << std::size_t(2);
    QTest::newRow("a web that stays") << 20.01 << std::size_t(1);
    QTest::newRow("parted by far") << 19.99 << std::size_t(2);
}

/// A notch that comes from one side as far as the wall of a slit: what is above it and what is
/// below it hang together by the notch's corner.
void TestBoolean::whatHangsByAPointFallsApart()
{
    QFETCH(double, wall);
    QFETCH(std::size_t, pieces);
    for (const double degrees : {0.0, 30.0, 45.0, 77.0}) {
        const double c = std::cos(radians(degrees)), s = std::sin(radians(degrees));
        const auto turned = [&](Polygon polygon) {
            for (Vec2 &p : polygon)
                p = Vec2(c * p.x() - s * p.y(), s * p.x() + c * p.y());
            return polygon;
        };
        const Contour notched = polygonContour(
            turned({{0, 0}, {40, 0}, {40, 30}, {0, 30}, {0, 20}, {20, 15}, {0, 10}}));
        const Polygon slit = turned({{wall, -5}, {wall + 3, -5}, {wall + 3, 35}, {wall, 35}});
        const auto result = *subtract(notched, {}, {slit}, kCutChord);
        QCOMPARE(result.size(), pieces + 1);
        double area = 0.0;
        for (const CurvedRegion &piece : result)
            area += fff::area(piece.region);
        QVERIFY(std::abs(area - (40 * 30 - 0.5 * 20 * 10 - 3 * 30)) < 0.1);
    }
}

void TestBoolean::crossingsLieOnCurveAndCut_data()
{
    QTest::addColumn<Contour>("contour");
    QTest::addColumn<double>("angle");
    std::mt19937 random(7);
    QTest::newRow("upright slit in a circle") << circle({0, 0}, 30) << 0.0;
    QTest::newRow("oblique slit in a circle") << circle({0, 0}, 30) << 0.7;
    QTest::newRow("slit in a blob") << blob(random, 8, 40) << 1.9;
    QTest::newRow("slit in a blob of many segments") << blob(random, 80, 40) << -2.2;
    QTest::newRow("slit through a square's edge")
        << polygonContour(rectangleAt(-20, -20, 40, 40)) << 0.3;
    QTest::newRow("slit through a spiral") << spiral() << 1.0;
    QTest::newRow("slit in a clockwise circle") << circle({0, 0}, 30).reversed() << 0.2;
}

// Wrong: a slit's mouth would have a step, or the curve beside it would be bent.
void TestBoolean::crossingsLieOnCurveAndCut()
{
    QFETCH(Contour, contour);
    QFETCH(double, angle);
    const Vec2 along(-std::sin(angle), std::cos(angle));
    const Polygon cut = turnedRectangle(35.0 * along, 3.0, 60.0, angle);
    const auto result = *subtract(contour, {}, {cut}, kCutChord);
    QVERIFY(!result.empty());
    int onBoth = 0;
    for (const CurvedRegion &r : result) {
        for (const CubicBezier &segment : segmentsOf(r.outer)) {
            const double toCurve = distanceTo(segment.p0, contour);
            const double toCut = distanceTo(segment.p0, cut);
            QVERIFY2(std::min(toCurve, toCut) <= kOnCurve,
                     qPrintable(QString::number(std::min(toCurve, toCut))));
            onBoth += toCurve <= kOnCurve && toCut <= kOnCurve;
            const double middle =
                std::min(distanceTo(segment.at(0.5), contour), distanceTo(segment.at(0.5), cut));
            QVERIFY2(middle <= kOnCurve, qPrintable(QString::number(middle)));
        }
    }
    QVERIFY2(onBoth >= 2 && onBoth % 2 == 0, qPrintable(QString::number(onBoth)));
}

// Wrong: files would hold hundreds of little chords where one curve was drawn.
void TestBoolean::curvesAreKept()
{
    const Contour contour = circle({0, 0}, 30);
    const auto result = *subtract(contour, {}, {rectangleAt(-1.5, 10, 3, 40)}, kCutChord);
    QCOMPARE(result.size(), 1U);
    // Four quarters, of which the slit splits off the ends of two, and its three sides.
    QCOMPARE(result[0].outer.segmentCount(), 7);
    int whole = 0;
    for (const CubicBezier &segment : segmentsOf(result[0].outer)) {
        for (const CubicBezier &source : segmentsOf(contour))
            whole += isSame(segment, source);
    }
    QCOMPARE(whole, 2);
}

// Wrong: a section sawn through would be shown as one.
void TestBoolean::slitAcrossMakesTwoParts()
{
    const Contour plate = polygonContour(rectangleAt(0, 0, 40, 20));
    const auto result = *subtract(plate, {}, {rectangleAt(10, -5, 3, 30)}, kCutChord);
    QCOMPARE(result.size(), 2U);
    QCOMPARE(result[0].outer.signedArea(), 27.0 * 20.0);
    QCOMPARE(result[1].outer.signedArea(), 10.0 * 20.0);
    QCOMPARE(result[0].outer.segmentCount(), 4);
}

// Wrong: a slit that runs into a hole would leave the hole closed, or lose it.
void TestBoolean::holeStaysUnlessASlitOpensIt()
{
    const Contour plate = polygonContour(rectangleAt(0, 0, 60, 40));
    const Contour hole = circle({30, 20}, 10);
    const auto closed = *subtract(plate, {hole}, {}, kCutChord);
    QCOMPARE(closed.size(), 1U);
    QCOMPARE(closed[0].holes.size(), 1U);
    QVERIFY(isSameUpToStart(closed[0].holes[0], hole.reversed()));
    const auto open = *subtract(plate, {hole}, {rectangleAt(28, 25, 4, 20)}, kCutChord);
    QCOMPARE(open.size(), 1U);
    QVERIFY(open[0].holes.empty());
    QCOMPARE(whatIsWrong(open, {plate, hole}, {rectangleAt(28, 25, 4, 20)}, kCutChord), QString());
}

// Wrong: where two drawn curves cross, the corner would be off them by the chords' error.
void TestBoolean::holesThatCrossAreCutOnTheirCurves()
{
    const Contour plate = circle({0, 0}, 30);
    const std::vector<Contour> holes{circle({-4, 1}, 9), circle({6, 0}, 8).reversed(),
                                     circle({0, 28}, 6)};
    const auto result = *subtract(plate, holes, {}, kCutChord);
    QCOMPARE(result.size(), 1U);
    QCOMPARE(result[0].holes.size(), 1U);
    std::vector<Contour> all = holes;
    all.push_back(plate);
    for (const Contour &boundary : {result[0].outer, result[0].holes[0]}) {
        for (const CubicBezier &segment : segmentsOf(boundary)) {
            for (double t : {0.0, 0.5}) {
                double nearest = 1.0;
                for (const Contour &source : all)
                    nearest = std::min(nearest, distanceTo(segment.at(t), source));
                QVERIFY2(nearest <= kOnCurve, qPrintable(QString::number(nearest)));
            }
        }
    }
}

void TestBoolean::cutsThatShareEdgesAndCorners_data()
{
    QTest::addColumn<Polygon>("cut");
    QTest::addColumn<double>("expected");
    QTest::newRow("a cut with its side in the contour") << rectangleAt(0, 10, 5, 10) << 1550.0;
    QTest::newRow("a cut with two sides in the contour") << rectangleAt(0, 0, 5, 10) << 1550.0;
    QTest::newRow("a cut that touches from outside") << rectangleAt(-5, 10, 5, 10) << 1600.0;
    QTest::newRow("a cut that touches in a corner")
        << Polygon{{-5, 20}, {0, 15}, {-5, 10}} << 1600.0;
    QTest::newRow("a cut from corner to corner") << Polygon{{0, 0}, {40, 40}, {0, 40}} << 800.0;
    QTest::newRow("a cut with a corner in the contour")
        << Polygon{{0, 20}, {10, 15}, {10, 25}} << 1550.0;
    QTest::newRow("a cut through two corners")
        << Polygon{{-1, -1}, {1, -1}, {41, 39}, {41, 41}, {39, 41}, {-1, 1}} << 1444.0;
    QTest::newRow("a cut half a grid step off the side")
        << rectangleAt(0.5 * kClipGrid, 10, 5, 10) << 1550.0;
    QTest::newRow("a clockwise cut") << Polygon{{10, 10}, {10, 20}, {15, 20}, {15, 10}} << 1550.0;
    QTest::newRow("a cut wider than high above the whole")
        << rectangleAt(-10, 30, 100, 3) << 1480.0;
    QTest::newRow("a cut without area") << Polygon{{-1, 20}, {41, 20}} << 1600.0;
}

// Wrong: slits that end exactly at an edge, as grids and repeats make them, would break the part.
void TestBoolean::cutsThatShareEdgesAndCorners()
{
    QFETCH(Polygon, cut);
    QFETCH(double, expected);
    const Contour square = polygonContour(rectangleAt(0, 0, 40, 40));
    const auto result = *subtract(square, {}, {cut}, kCutChord);
    QVERIFY2(std::abs(curvedArea(result) - expected) < 1e-3,
             qPrintable(QString::number(curvedArea(result), 'g', 12)));
    QVERIFY(std::abs(curvedArea(result) - chordArea(result)) < 1e-3);
    QCOMPARE(whatIsWrong(result, {square}, {cut}, kCutChord), QString());
}

// Wrong: two slits side by side would leave needless corners on their common bottom.
void TestBoolean::cutEdgesInOneLineAreOne()
{
    const Contour plate = polygonContour(rectangleAt(0, 0, 40, 20));
    const auto result =
        *subtract(plate, {}, {rectangleAt(10, 8, 3, 20), rectangleAt(12, 8, 3, 20)}, kCutChord);
    QCOMPARE(result.size(), 1U);
    QCOMPARE(result[0].outer.segmentCount(), 8);
    QCOMPARE(result[0].outer.signedArea(), 800.0 - 60.0);
}

// Wrong: a degenerate slit would take the whole section away or crash.
void TestBoolean::whatIsNoPolygonCutsNothing()
{
    const Contour plate = circle({0, 0}, 20);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto result = *subtract(plate, {}, {{}, {{1, 1}}, {{0, 0}, {0, 0}, {0, 0}}}, kCutChord);
    QCOMPARE(result.size(), 1U);
    QVERIFY(isSameUpToStart(result[0].outer, plate));
    QVERIFY(!subtract(plate, {}, {{{nan, 0}, {1, 0}, {1, 1}}}, kCutChord));
}

// Wrong: a part of no area would be sent to the machine.
void TestBoolean::nothingIsLeftUnderACover()
{
    QVERIFY(subtract(circle({0, 0}, 20), {}, {rectangleAt(-30, -30, 60, 60)}, kCutChord)->empty());
    QVERIFY(subtract(circle({0, 0}, 20), {circle({0, 0}, 20)}, {}, kCutChord)->empty());
    QVERIFY(subtract(Contour(), {}, {}, kCutChord)->empty());
}

// Wrong: the same model turned would be cut differently.
void TestBoolean::turningEverythingTurnsTheResult()
{
    std::mt19937 random(99);
    const Contour contour = blob(random, 12, 40);
    const Polygon cut = turnedRectangle({20, 20}, 3.0, 50.0, -0.8);
    const double expected = curvedArea(*subtract(contour, {}, {cut}, kCutChord));
    for (double angle : {0.1, 1.0, 2.0, std::numbers::pi / 2.0}) {
        const auto turn = [&](const Vec2 &p) {
            return Vec2(std::cos(angle) * p + std::sin(angle) * perpendicular(p) + Vec2(300, -70));
        };
        std::vector<Vec2> points;
        for (const Vec2 &p : contour.points())
            points.push_back(turn(p));
        Polygon turnedCut;
        for (const Vec2 &p : cut)
            turnedCut.push_back(turn(p));
        const Contour turned = Contour::fromPoints(points).value();
        QVERIFY(std::abs(curvedArea(*subtract(turned, {}, {turnedCut}, kCutChord)) - expected) <
                1e-6 * expected);
    }
}

// Wrong: some constellation of slits would tear a boundary open or bend its curves.
void TestBoolean::randomCutsLeaveSoundRegions()
{
    constexpr unsigned kSeed = 4711;
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<double> place(-50.0, 50.0), size(0.05, 60.0), turn(0.0, 3.2);
    const std::vector<NamedContour> contours = simpleContours();
    for (int round = 0; round < 60; ++round) {
        const NamedContour &shape = contours[static_cast<std::size_t>(round) % contours.size()];
        const Vec2 middle = shape.contour.bounds().center();
        std::vector<Polygon> cuts;
        for (int i = 0; i <= round % 7; ++i) {
            // Some snap to the shape's own points, where things are degenerate.
            Vec2 at = middle + Vec2(place(random), place(random));
            if (i % 3 == 1)
                at = shape.contour.points()[3 * (static_cast<std::size_t>(round) %
                                                 (shape.contour.points().size() / 3))];
            cuts.push_back(i % 2 ? turnedRectangle(at, 3.0, size(random), 0.0)
                                 : turnedRectangle(at, size(random), size(random), turn(random)));
        }
        const auto result = *subtract(shape.contour, {}, cuts, kCutChord);
        const QString wrong = whatIsWrong(result, {shape.contour}, cuts, kCutChord);
        const double gap = std::abs(curvedArea(result) - chordArea(result));
        if (!wrong.isEmpty() || gap > kCutChord * totalPerimeter(result))
            QFAIL(qPrintable(QStringLiteral("seed %1 round %2 (%3): %4, area off by %5")
                                 .arg(kSeed)
                                 .arg(round)
                                 .arg(QLatin1String(shape.name), wrong)
                                 .arg(gap)));
    }
}

void TestBoolean::simpleContourIsNotCrossing_data()
{
    QTest::addColumn<Contour>("contour");
    for (const NamedContour &shape : simpleContours())
        QTest::newRow(shape.name) << shape.contour;
}

// Wrong: reading a file would change contours that nothing is wrong with.
void TestBoolean::simpleContourIsNotCrossing()
{
    QFETCH(Contour, contour);
    const auto resolved = resolveCrossings(contour);
    QVERIFY(resolved);
    QVERIFY(!resolved->wasCrossing);
    QVERIFY(resolved->contour == contour);
}

void TestBoolean::crossingContourIsResolved_data()
{
    QTest::addColumn<Contour>("contour");
    for (const NamedContour &shape : crossingContours())
        QTest::newRow(shape.name) << shape.contour;
}

// Wrong: a contour that crosses itself would be cut as it is, and fall apart on the machine.
void TestBoolean::crossingContourIsResolved()
{
    QFETCH(Contour, contour);
    const auto resolved = resolveCrossings(contour);
    QVERIFY(resolved);
    QVERIFY(resolved->wasCrossing);
    QVERIFY(resolved->contour.signedArea() > kMinArea);
    for (const CubicBezier &segment : segmentsOf(resolved->contour))
        QVERIFY(distanceTo(segment.at(0.5), contour) <= kOnCurve);
    const auto again = resolveCrossings(resolved->contour);
    QVERIFY(again);
    QVERIFY(!again->wasCrossing);
}

// Wrong: of what is hundreds of metres long a narrow loop was taken for rounding, and crossed once
// all but its place was cut away.
void TestBoolean::narrowLoopOfALongContour()
{
    const auto resolved = resolveCrossings(polygonContour(
        {{-50, -250000}, {50, 25}, {50, -25}, {-50, -25}, {-50, 83000}, {-83000, -332000}}));
    QVERIFY(resolved);
    QVERIFY(resolved->wasCrossing);
    const auto above = clip(resolved->contour, {}, {Vec2(0, -80), Vec2::UnitY()});
    QVERIFY(above && !above->empty());
    QVERIFY(isPlain(above->front().outer, {}, kCutChord));
}

// Wrong: a line would become a section.
void TestBoolean::emptyContourIsAnError()
{
    const auto line = resolveCrossings(polygonContour({{0, 0}, {10, 0}, {20, 0}}));
    QVERIFY(!line);
    QVERIFY(line.error().code == ErrorCode::EmptyContour);
    QVERIFY(!resolveCrossings(Contour()));
    QVERIFY(!resolveCrossings(polygonContour(rectangleAt(0, 0, 0.01, 0.01))));
}

// Wrong: dragging a section would stutter. Also the law that slits apart from each other take
// their own areas.
void TestBoolean::fiveHundredVerticesTwentySlits()
{
    std::mt19937 random(5);
    const Contour contour = blob(random, 20, 200);
    // A chord tolerance that gives about 500 vertices.
    const double chord = 0.05;
    std::vector<Polygon> cuts;
    for (int i = 0; i < 20; ++i)
        cuts.push_back(rectangleAt(-100 + 10.0 * i, 30, 3, 400));
    const auto vertices = contour.flatten(chord).points.size();
    qInfo() << "vertices" << vertices;
    std::vector<CurvedRegion> result;
    QBENCHMARK
    {
        result = *subtract(contour, {}, cuts, chord);
    }
    QCOMPARE(result.size(), 1U);
    QCOMPARE(whatIsWrong(result, {contour}, cuts, chord), QString());
}

FFF_TEST(TestBoolean)
#include "tst_boolean.moc"
