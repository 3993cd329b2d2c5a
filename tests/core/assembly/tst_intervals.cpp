#include "core/assembly/crossing.h"
#include "core/assembly/intervals.h"
#include "core/assembly/rings_near.h"
#include "tests/core/assembly/many_corners.h"
#include "tests/test_program.h"

#include <QTest>

#include <numbers>
#include <random>

using namespace fff;
using namespace fff::test;

using Spans = std::vector<std::pair<double, double>>;

class TestIntervals : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void horizontalLine_data();
    void horizontalLine();
    void agreesWithPointLocation();
    void shapesAnswerAsTheirRegions();
    void edgesOfAStripAnswerAsTheirRegion();
    void fewCornersAreNearALine();
    void mouthReach_data();
    void mouthReach();
    void axisLiesInBothPlanes();
    void nearlyParallelPlanesHaveNoAxis();
    void meetingPairsAreThoseOfBruteForce();
};

void TestIntervals::horizontalLine_data()
{
    QTest::addColumn<Region>("region");
    QTest::addColumn<double>("height");
    QTest::addColumn<Spans>("expected");

    const Region square{rectangle(0, 0, 10, 10), {}};
    const Region ring{rectangle(0, 0, 10, 10), {rectangle(3, 3, 7, 7)}};
    const Region comb{{{0, 0},
                       {9, 0},
                       {9, 6},
                       {7, 6},
                       {7, 2},
                       {6, 2},
                       {6, 6},
                       {3, 6},
                       {3, 2},
                       {2, 2},
                       {2, 6},
                       {0, 6}},
                      {}};
    const Region diamond{{{0, 0}, {5, -5}, {10, 0}, {5, 5}}, {}};
    const Region hourglass{{{0, 0}, {4, 0}, {2, 3}, {4, 6}, {0, 6}, {1, 3}}, {}};
    QTest::newRow("through a square") << square << 5.0 << Spans{{0, 10}};
    QTest::newRow("beside a square") << square << 11.0 << Spans{};
    QTest::newRow("along the lower edge is not inside") << square << 0.0 << Spans{};
    QTest::newRow("along the upper edge is not inside") << square << 10.0 << Spans{};
    QTest::newRow("a hole splits") << ring << 5.0 << Spans{{0, 3}, {7, 10}};
    QTest::newRow("along a hole's lower edge the material below does not count")
        << ring << 3.0 << Spans{{0, 3}, {7, 10}};
    QTest::newRow("every tooth of a comb") << comb << 4.0 << Spans{{0, 2}, {3, 6}, {7, 9}};
    QTest::newRow("along the bottoms of the comb's gaps")
        << comb << 2.0 << Spans{{0, 2}, {3, 6}, {7, 9}};
    QTest::newRow("through two corners") << diamond << 0.0 << Spans{{0, 10}};
    QTest::newRow("touching one corner") << diamond << 5.0 << Spans{};
    QTest::newRow("through inward corners") << hourglass << 3.0 << Spans{{1, 2}};
}

// Wrong intervals mean slits at places where nothing crosses, or none where something does.
void TestIntervals::horizontalLine()
{
    QFETCH(Region, region);
    QFETCH(double, height);
    QFETCH(Spans, expected);
    // Either direction, and either winding of the contour, must give the same stretches.
    for (const double sign : {1.0, -1.0}) {
        for (const bool isReversed : {false, true}) {
            Region copy = region;
            if (isReversed)
                std::reverse(copy.outer.begin(), copy.outer.end());
            const PlaneLine line{{0, height}, {sign, 0}};
            std::vector<Interval> found = intervalsOn(line, copy);
            QCOMPARE(found.size(), expected.size());
            if (sign < 0)
                std::reverse(found.begin(), found.end());
            for (std::size_t i = 0; i < found.size(); ++i) {
                const auto [from, to] =
                    std::minmax({sign * found[i].from.at, sign * found[i].to.at});
                QCOMPARE(from, expected[i].first);
                QCOMPARE(to, expected[i].second);
            }
        }
    }
}

// If midpoints of stretches and of gaps were not inside and outside, the pairing of crossings is
// off.
void TestIntervals::agreesWithPointLocation()
{
    std::mt19937_64 random(20141);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int round = 0; round < 200; ++round) {
        Polygon star;
        for (int i = 0; i < 40; ++i) {
            const double angle = 2 * std::numbers::pi * i / 40, radius = 30 + 25 * unit(random);
            star.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
        }
        const Region region{star, {rectangle(-2, -2, 2, 2)}};
        const double angle = 4 * unit(random);
        const PlaneLine line{{20 * unit(random), 20 * unit(random)},
                             {std::cos(angle), std::sin(angle)}};
        const auto intervals = intervalsOn(line, region);
        for (std::size_t i = 0; i < intervals.size(); ++i) {
            const double middle = 0.5 * (intervals[i].from.at + intervals[i].to.at);
            QCOMPARE(locate(line.at(middle), region), Side::Inside);
            if (i > 0) {
                const double gap = 0.5 * (intervals[i - 1].to.at + intervals[i].from.at);
                QCOMPARE(locate(line.at(gap), region), Side::Outside);
            }
        }
    }
}

// Wrong: ribs on a long spine would have other slits than on a short one.
void TestIntervals::shapesAnswerAsTheirRegions()
{
    std::mt19937_64 random(411);
    int found = 0;
    for (const ShapePointer &shape :
         {spineOf(300), jaggedDisc(random, 500), jaggedDisc(random, 2000)}) {
        for (const PlaneLine &line : linesAcross(random, *shape)) {
            const auto all = intervalsOn(line, shape->region());
            const auto ours = intervalsOn(line, *shape);
            QCOMPARE(ours.size(), all.size());
            for (std::size_t i = 0; i < all.size(); ++i) {
                for (const auto &[a, b] :
                     {std::pair(&ours[i].from, &all[i].from), std::pair(&ours[i].to, &all[i].to)}) {
                    QVERIFY(a->at == b->at);
                    QCOMPARE(a->ring, b->ring);
                    QCOMPARE(a->edge, b->edge);
                }
                ++found;
            }
        }
    }
    QVERIFY(found > 300);
}

// Wrong: a slit would hold another depth for what lies beside its walls.
void TestIntervals::edgesOfAStripAnswerAsTheirRegion()
{
    std::mt19937_64 random(412);
    std::uniform_real_distribution<double> place(-1.0, 1.0);
    constexpr double kHalf = 4.0;
    int found = 0, throughCorners = 0;
    IntervalMemory memory;
    for (const ShapePointer &shape :
         {spineOf(300), jaggedDisc(random, 500), jaggedDisc(random, 2000)}) {
        for (const PlaneLine &axis : linesAcross(random, *shape)) {
            std::vector<LineEdge> edges;
            for (const PolygonTree &ring : shape->boundaries().rings())
                ring.visitIn(LineStrip(axis.point, axis.direction, kHalf + 0.01),
                             [&](const Vec2 &a, const Vec2 &b) {
                                 edges.push_back({a, b});
                             });
            for (const double beside : {0.0, kHalf, -kHalf, kHalf * place(random)}) {
                const PlaneLine line{axis.point + beside * perpendicular(axis.direction),
                                     axis.direction};
                const auto all = intervalsOn(line, shape->region());
                const auto ours = intervalsOn(line, edges, memory);
                if (!ours) {
                    ++throughCorners;
                    continue;
                }
                QCOMPARE(ours->size(), all.size());
                for (std::size_t i = 0; i < all.size(); ++i) {
                    QVERIFY((*ours)[i].from.at == all[i].from.at);
                    QVERIFY((*ours)[i].to.at == all[i].to.at);
                    ++found;
                }
            }
        }
    }
    QVERIFY(found > 1000 && throughCorners > 10);
}

// Wrong: slits would cost the square of what a spine is long.
void TestIntervals::fewCornersAreNearALine()
{
    for (const int corners : {500, 5000, 50000}) {
        const ShapePointer spine = spineOf(corners);
        for (const double x : {5.0, 3000.0, 4996.0}) {
            const PlaneLine line{{x, 0.0}, Vec2::UnitY()};
            const RingsNear near(line, *spine, 2.0);
            QVERIFY(near.region().outer.size() <= 150);
            QCOMPARE(intervalsOn(line, near.region()).size(), std::size_t(1));
        }
    }
}

void TestIntervals::mouthReach_data()
{
    QTest::addColumn<Region>("region");
    QTest::addColumn<double>("halfWidth");
    QTest::addColumn<double>("expected");

    QTest::newRow("a square edge") << Region{rectangle(-20, 0, 20, 10), {}} << 1.5 << 10.0;
    QTest::newRow("an oblique edge rises by the half width")
        << Region{{{-20, -20}, {20, -20}, {20, 30}, {-20, -10}}, {}} << 2.0 << 12.0;
    QTest::newRow("a narrow tip lies within the strip")
        << Region{{{-20, 0}, {20, 0}, {0.5, 5}, {0, 40}, {-0.5, 5}}, {}} << 3.0 << 40.0;
    QTest::newRow("a notch in the edge")
        << Region{{{-20, 0}, {20, 0}, {20, 10}, {1, 10}, {0, 4}, {-1, 10}, {-20, 10}}, {}} << 2.0
        << 10.0;
}

// A slit shorter than this leaves a corner standing at its mouth and nothing slides in.
void TestIntervals::mouthReach()
{
    QFETCH(Region, region);
    QFETCH(double, halfWidth);
    QFETCH(double, expected);
    const PlaneLine line{{0, 0}, {0, 1}};
    const auto intervals = intervalsOn(line, region);
    QVERIFY(!intervals.empty());
    QCOMPARE(fff::mouthReach(line, region, intervals.back().to, halfWidth, 1.0, 1), expected);
}

void TestIntervals::axisLiesInBothPlanes()
{
    const Frame a = *makeFrame({10, 20, 30}, {1, 0.2, 0.3}, {0, 1, 0.1});
    const Frame b = *makeFrame({-5, 8, 2}, {0.1, 0, 1}, {0.5, 1, 0});
    const auto axis = intersectionAxis(a, b);
    QVERIFY(axis);
    for (const double s : {-300.0, 0.0, 300.0}) {
        QVERIFY(std::abs(a.height(axis->at(s))) < 1e-10);
        QVERIFY(std::abs(b.height(axis->at(s))) < 1e-10);
    }
}

void TestIntervals::nearlyParallelPlanesHaveNoAxis()
{
    QVERIFY(!intersectionAxis(front(), front(5)));
    QVERIFY(!intersectionAxis(front(), turned(0.1)));
    QVERIFY(intersectionAxis(front(), turned(0.2)));
}

// The sweep must not lose a pair: a lost pair is a joint without slits.
void TestIntervals::meetingPairsAreThoseOfBruteForce()
{
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<Box3> boxes;
    for (int i = 0; i < 120; ++i) {
        const Vec3 corner(100 * unit(random), 40 * unit(random), 40 * unit(random));
        Box3 box;
        box.extend(corner);
        box.extend(corner + Vec3(15 * unit(random), 15 * unit(random), 15 * unit(random)));
        boxes.push_back(box);
    }
    std::vector<std::pair<int, int>> expected;
    for (int i = 0; i < 120; ++i)
        for (int j = i + 1; j < 120; ++j)
            if (boxes[i].intersects(boxes[j]))
                expected.emplace_back(i, j);
    QVERIFY(!expected.empty());
    QVERIFY(meetingPairs(boxes) == expected);
}

FFF_TEST(TestIntervals)
#include "tst_intervals.moc"
