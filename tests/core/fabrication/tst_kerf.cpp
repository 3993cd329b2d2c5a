#include "core/base/tolerances.h"
#include "core/fabrication/kerf.h"
#include "core/geometry/offset.h"
#include "tests/core/assembly/plates.h"
#include "tests/core/fabrication/parts_of.h"
#include "tests/core/geometry/curve_distance.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <QTest>

using namespace fff;
using namespace fff::test;

namespace {

constexpr double kRounding = 1e-9; // mm

double totalArea(const CurvedRegion &region)
{
    double sum = region.outer.signedArea();
    for (const Contour &hole : region.holes)
        sum += hole.signedArea();
    return sum;
}

double distanceToBoundary(const Vec2 &point, const CurvedRegion &region)
{
    double nearest = distanceTo(point, region.outer);
    for (const Contour &hole : region.holes)
        nearest = std::min(nearest, distanceTo(point, hole));
    return nearest;
}

} // namespace

class TestKerf : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void noKerfChangesNothing();
    void aKerfOfNothingIsNone();
    void rectangleGrowsToARectangle();
    void holeShrinks();
    void slitNarrowsAndStaysSquare();
    void slitInACurveNarrows();
    void slitNarrowerThanTheKerfCloses();
    void circleStaysACircle();
    void pathKeepsItsDistance_data();
    void pathKeepsItsDistance();
    void spikeIsRoundedOff();
    void roomBehindANarrowMouthGetsAPath();
    void mitreGivesWayToWhatLiesBeside();
    void tipsTurnRoundOnCurves();
    void shortEdgesInACornerAreNotBittenInto();
    void everyPartTakesItsStocksKerf();
    void sectionsKeepWhatWasCompensatedLast();
};

// Wrong: "no kerf" would still reshape the file.
void TestKerf::noKerfChangesNothing()
{
    std::mt19937 random(3);
    const CurvedRegion region = regionOf(blob(random, 8, 30), {circle({0, 0}, 5)});
    const CurvedRegion same = *compensateKerf(region, 0.0);
    QVERIFY(same.outer == region.outer);
    QVERIFY(same.holes == region.holes);
}

// Wrong: a kerf that rounding swallows would be looked for until the person gives up.
void TestKerf::aKerfOfNothingIsNone()
{
    std::mt19937 random(3);
    const CurvedRegion region = regionOf(blob(random, 8, 30), {circle({0, 0}, 5)});
    for (const double kerf : {5e-324, 1e-300, 1e-13, 1e-6, 1e-4, 9e-4}) {
        const auto same = compensateKerf(region, kerf);
        QVERIFY(same && same->outer == region.outer);
        QVERIFY(growLoosely(region, 0.5 * kerf)->outer == region.outer);
    }
    for (const double kerf : {1.1e-3, 2e-3, 1e-2}) {
        const auto path = compensateKerf(region, kerf);
        QVERIFY(path && totalArea(*path) > totalArea(region));
    }
}

// Wrong: straight edges would get bends, corners would be rounded or beveled.
void TestKerf::rectangleGrowsToARectangle()
{
    const CurvedRegion grown =
        *compensateKerf(regionOf(polygonContour(rectangleAt(0, 0, 40, 20))), 0.2);
    QCOMPARE(grown.outer.segmentCount(), 4);
    QVERIFY(std::abs(totalArea(grown) - 40.2 * 20.2) < kRounding);
}

// Wrong: pegs would fall through holes that the laser made too wide.
void TestKerf::holeShrinks()
{
    const CurvedRegion grown =
        *compensateKerf(regionOf(polygonContour(rectangleAt(0, 0, 40, 40)),
                                 {polygonContour(rectangleAt(10, 10, 20, 5))}),
                        0.2);
    QCOMPARE(grown.holes.size(), 1U);
    QVERIFY(std::abs(grown.holes[0].signedArea() + 19.8 * 4.8) < kRounding);
    // One that is all kerf needs no cut.
    QVERIFY(compensateKerf(regionOf(polygonContour(rectangleAt(0, 0, 40, 40)),
                                    {polygonContour(rectangleAt(10, 10, 20, 0.15))}),
                           0.2)
                ->holes.empty());
}

// Wrong: joints would be loose by the kerf, or stand on rounded bottoms.
void TestKerf::slitNarrowsAndStaysSquare()
{
    const CurvedRegion region =
        regionOf(polygonContour(rectangleAt(0, 0, 40, 40)), {}, {rectangleAt(18.5, 20, 3, 30)});
    const CurvedRegion grown = *compensateKerf(region, 0.2);
    QCOMPARE(grown.outer.segmentCount(), 8);
    // The bottom moves with the upper edge: the slit is as deep as before.
    QVERIFY(std::abs(totalArea(grown) - (40.2 * 40.2 - 2.8 * 20.0)) < kRounding);
    for (int i = 0; i < 8; ++i) {
        const CubicBezier s = grown.outer.segment(i);
        QVERIFY(s.isStraight(kClipGrid));
        QVERIFY((s.p3 - s.p0).cwiseAbs().minCoeff() < kRounding);
    }
}

// Wrong: where a slit meets a curve, its walls would not be parallel any more.
void TestKerf::slitInACurveNarrows()
{
    const CurvedRegion region = regionOf(circle({0, 0}, 30), {}, {rectangleAt(-1.5, 0, 3, 40)});
    const CurvedRegion grown = *compensateKerf(region, 0.2);
    double walls = 0.0;
    for (int i = 0; i < grown.outer.segmentCount(); ++i) {
        const CubicBezier s = grown.outer.segment(i);
        if (s.isStraight(kClipGrid) && (s.p3 - s.p0).norm() > 20.0) {
            walls += 1.0;
            QVERIFY(std::abs(std::abs(s.p0.x()) - 1.4) < kRounding);
            QVERIFY(std::abs(std::abs(s.p3.x()) - 1.4) < kRounding);
        }
    }
    QCOMPARE(walls, 2.0);
}

// Wrong: a path that crosses itself, or a part in two.
void TestKerf::slitNarrowerThanTheKerfCloses()
{
    const CurvedRegion region =
        regionOf(polygonContour(rectangleAt(0, 0, 40, 40)), {}, {rectangleAt(20, 20, 0.1, 30)});
    const CurvedRegion grown = *compensateKerf(region, 0.2);
    QVERIFY(std::abs(totalArea(grown) - 40.2 * 40.2) < 1e-3);
    QVERIFY(!resolveCrossings(grown.outer)->wasCrossing);
}

// Wrong: curves would come out as hundreds of chords.
void TestKerf::circleStaysACircle()
{
    const CurvedRegion grown = *compensateKerf(regionOf(circle({5, 5}, 30)), 0.3);
    QVERIFY(grown.outer.segmentCount() <= 8);
    for (int i = 0; i < grown.outer.segmentCount(); ++i) {
        for (double t : {0.0, 0.3, 0.6})
            QVERIFY(std::abs((grown.outer.segment(i).at(t) - Vec2(5, 5)).norm() - 30.15) < 0.011);
    }
}

void TestKerf::pathKeepsItsDistance_data()
{
    QTest::addColumn<int>("shape");
    QTest::addColumn<double>("kerf");
    const std::vector<NamedContour> shapes = simpleContours();
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const QByteArray name(shapes[i].name);
        QTest::addRow("%s, laser", shapes[i].name) << static_cast<int>(i) << 0.2;
        QTest::addRow("%s, router", shapes[i].name) << static_cast<int>(i) << 3.0;
    }
}

// Wrong: somewhere the machine would take off more or less than half the kerf.
void TestKerf::pathKeepsItsDistance()
{
    QFETCH(int, shape);
    QFETCH(double, kerf);
    const Contour contour = simpleContours()[static_cast<std::size_t>(shape)].contour;
    const Vec2 middle = contour.bounds().center();
    const CurvedRegion region =
        regionOf(contour, {}, {turnedRectangle(middle + Vec2(20, 20), 4.0, 30.0, -0.8)});
    const CurvedRegion grown = *compensateKerf(region, kerf);
    QVERIFY(!resolveCrossings(grown.outer)->wasCrossing);
    QVERIFY(totalArea(grown) > totalArea(region));
    double nearest = kerf;
    const auto check = [&](const Contour &boundary) {
        for (int i = 0; i < boundary.segmentCount(); ++i) {
            for (double t : {0.01, 0.5, 0.8})
                nearest = std::min(nearest, distanceToBoundary(boundary.segment(i).at(t), region));
        }
    };
    check(grown.outer);
    for (const Contour &hole : grown.holes)
        check(hole);
    QVERIFY2(nearest >= 0.5 * kerf - 2.0 * kOffsetError, qPrintable(QString::number(nearest)));
    // Nor farther than a mitre reaches: every corner of the path is near the region.
    for (const Vec2 &p : grown.outer.flatten(kDrawChord).points)
        QVERIFY(distanceToBoundary(p, region) <= 2.6 * 0.5 * kerf);
}

// Wrong: a path that runs far off the part at every sharp tip, or cuts it off.
void TestKerf::spikeIsRoundedOff()
{
    const CurvedRegion grown =
        *compensateKerf(regionOf(polygonContour({{0, 0}, {100, -1}, {100, 1}})), 0.2);
    double left = 0.0;
    for (const Vec2 &p : grown.outer.points())
        left = std::min(left, p.x());
    QVERIFY(left <= -0.1 + kRounding);
    QVERIFY(left >= -0.11); // a handle of the arc
    double nearest = 1.0;
    for (const Vec2 &p : grown.outer.polygon(1e-4))
        nearest = std::min(nearest, p.norm());
    QVERIFY(std::abs(nearest - 0.1) < 1e-3);
}

// Wrong: a room that the tool does not come into from outside would stay full.
void TestKerf::roomBehindANarrowMouthGetsAPath()
{
    // A slit of 0.1 mm that leads to a square of 10 mm.
    const CurvedRegion region = regionOf(polygonContour({{0, 0},
                                                         {40, 0},
                                                         {40, 40},
                                                         {20.1, 40},
                                                         {20.1, 20},
                                                         {25, 20},
                                                         {25, 10},
                                                         {15, 10},
                                                         {15, 20},
                                                         {20, 20},
                                                         {20, 40},
                                                         {0, 40}}));
    const CurvedRegion grown = *compensateKerf(region, 0.2);
    QCOMPARE(grown.holes.size(), 1U);
    // Its corners beside the mouth are convex ones of the part, 0.1 mm apart.
    QVERIFY(std::abs(-grown.holes[0].signedArea() - 9.8 * 9.8) < 0.05);
    QVERIFY(std::abs(grown.outer.signedArea() - 40.2 * 40.2) < kRounding);
}

// Wrong: a mitre would close the way for the tool between a corner and what is opposite.
void TestKerf::mitreGivesWayToWhatLiesBeside()
{
    // A tip of 60° stands 0.25 mm before a wall: the tool of 0.2 mm goes between them, a mitre of
    // 0.2 mm would touch the path along the wall.
    const CurvedRegion region =
        regionOf(polygonContour({{0, 0}, {40, 0}, {40, 40}, {0, 40}}),
                 {polygonContour(
                      {{10, 10}, {20, 10}, {20, 19.75}, {25.63, 10}, {30, 10}, {30, 20}, {10, 20}})
                      .reversed()});
    const CurvedRegion grown = *compensateKerf(region, 0.2);
    QCOMPARE(grown.holes.size(), 1U);
    bool hasArc = false;
    for (int i = 0; i < grown.holes[0].segmentCount(); ++i)
        hasArc = hasArc || !grown.holes[0].segment(i).isStraight(kClipGrid);
    QVERIFY(hasArc);
}

// Wrong: a bite where two curves meet in a tip, however fine.
void TestKerf::tipsTurnRoundOnCurves()
{
    for (const double bend : {-0.3, -0.001, 0.0}) {
        const Contour leaf =
            Contour::fromPoints(
                {{0, 0}, {20, -8}, {40, 0.0 + bend}, {60, 0}, {40, 0.002 - bend}, {20, 8}})
                .value();
        const auto grown = compensateKerf(CurvedRegion{leaf, {}, {leaf.polygon(0.01), {}}}, 0.5);
        QVERIFY(grown);
        // Round the tip, a quarter of a millimetre off it.
        for (const Vec2 &p : grown->outer.polygon(1e-4))
            QVERIFY((p - Vec2(60, 0)).norm() > 0.245);
    }
}

// Wrong: the path would cut a concave corner straight where edges are shorter than the kerf.
void TestKerf::shortEdgesInACornerAreNotBittenInto()
{
    Polygon polygon{{0, 0}, {40, 0}, {40, 40}};
    // A concave corner of 0.2 mm, in steps of 0.01 mm, with teeth of 0.05 mm.
    for (int i = 0; i <= 20; ++i)
        polygon.push_back({20.2 - 0.01 * i, 40 - 0.5 * i - (i % 2 == 0 ? 0.0 : 0.05)});
    polygon.push_back({0, 30});
    const CurvedRegion region = regionOf(polygonContour(polygon));
    for (const double kerf : {0.05, 0.2, 0.5, 3.0}) {
        const CurvedRegion grown = *compensateKerf(region, kerf);
        double nearest = kerf;
        for (const Vec2 &p : grown.outer.polygon(1e-3))
            nearest = std::min(nearest, distanceTo(p, region.region.outer));
        QVERIFY(nearest > 0.5 * kerf - 0.005);
    }
}

// Wrong: plywood would be cut with acrylic's kerf.
void TestKerf::everyPartTakesItsStocksKerf()
{
    Model model = twoSections(polygonShape(rectangle(0, 0, 40, 40)), front(0),
                              polygonShape(rectangle(0, 0, 40, 40)), front(100));
    Stock acrylic = flatfabAcrylic();
    acrylic.kerf = 1.0;
    model.document = *addStock(model.document, acrylic);
    model.document = *setSectionStock(model.document, model.document.sections[1]->id,
                                      model.document.currentStock);
    const Assembly assembly = assemble(model);
    const auto cuts = cutsOf(model, assembly);
    const Bodies bodies = bodiesOf(model, cuts);
    const std::vector<Part> parts =
        *compensateKerf(makeParts(model, assembly, bodies), model, bodies);
    QVERIFY(std::abs(totalArea(parts[0].outline) - 40.2 * 40.2) < kRounding);
    QVERIFY(std::abs(totalArea(parts[1].outline) - 41.0 * 41.0) < kRounding);
}

// Wrong: a part would get the outline of another, or that of a kerf set before.
void TestKerf::sectionsKeepWhatWasCompensatedLast()
{
    const CutSection cut({regionOf(polygonContour(rectangleAt(0, 0, 40, 40))),
                          regionOf(polygonContour(rectangleAt(60, 0, 20, 20)))});
    const auto first = *cut.compensated(0.2);
    QCOMPARE(first->size(), 2U);
    QVERIFY(std::abs(totalArea((*first)[0]) - 40.2 * 40.2) < kRounding);
    QVERIFY(std::abs(totalArea((*first)[1]) - 20.2 * 20.2) < kRounding);
    QCOMPARE(*cut.compensated(0.2), first);
    QVERIFY(std::abs(totalArea((**cut.compensated(1.0))[1]) - 21.0 * 21.0) < kRounding);
}

FFF_TEST(TestKerf)
#include "tst_kerf.moc"
