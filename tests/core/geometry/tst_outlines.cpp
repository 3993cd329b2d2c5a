// What lines of a drawing enclose. If this fails, a hole becomes a part of its own, or a drawing of
// many lines takes minutes.
#include "core/geometry/outlines.h"
#include "core/geometry/tangle.h"
#include "tests/test_program.h"

#include <QtTest/QtTest>
#include <cmath>
#include <random>

using namespace fff;

namespace {

struct Rectangle
{
    double left = 0.0, low = 0.0, right = 0.0, high = 0.0;

    bool has(const Rectangle &other) const
    {
        return left <= other.left && low <= other.low && right >= other.right && high >= other.high;
    }
    double area() const { return (right - left) * (high - low); }
};

CurvePath around(const Rectangle &r)
{
    return CurvePath::fromLine({{r.left, r.low},
                                {r.right, r.low},
                                {r.right, r.high},
                                {r.left, r.high},
                                {r.left, r.low}})
        .value();
}

/// Rectangles in each other by chance, on whole numbers so that many touch; none cross.
std::vector<Rectangle> rectanglesIn(const Rectangle &whole, std::mt19937 &random, int depth)
{
    std::vector<Rectangle> all{whole};
    if (depth == 0 || whole.right - whole.left < 4 || whole.high - whole.low < 4)
        return all;
    // Side by side, with gaps of 0 or 1 between them and to the outside.
    double at = whole.left + static_cast<double>(random() % 2);
    while (at + 2 <= whole.right) {
        const double wide = 2.0 + static_cast<double>(random() % 6);
        const Rectangle next{at, whole.low + static_cast<double>(random() % 2),
                             std::min(at + wide, whole.right),
                             whole.high - static_cast<double>(random() % 2)};
        if (next.area() < whole.area()) {
            const std::vector<Rectangle> more = rectanglesIn(next, random, depth - 1);
            all.insert(all.end(), more.begin(), more.end());
        }
        at = next.right + static_cast<double>(random() % 2);
    }
    return all;
}

/// A polygon's corners as a closed line.
CurvePath closed(Polygon corners)
{
    corners.push_back(corners.front());
    return CurvePath::fromLine(corners).value();
}

} // namespace

class TestOutlines : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nestingIsThatOfEveryPair_data();
    void nestingIsThatOfEveryPair();
    void ringsLieInEachOtherThousandsDeep();
    void whatOnlyLiesInTheBoxIsNotInside();
    void repeatedLinesCountOnce();
    void edgesAreJoinedInAnyOrder_data();
    void edgesAreJoinedInAnyOrder();
    void aLoopOfOneSegmentIsAnOutline();
    void tanglesAreLeftOut();
};

void TestOutlines::nestingIsThatOfEveryPair_data()
{
    QTest::addColumn<unsigned>("seed");
    for (unsigned seed = 1; seed <= 20; ++seed)
        QTest::addRow("seed %u", seed) << seed;
}

// Wrong: of rectangles in rectangles, some would be holes that are none.
void TestOutlines::nestingIsThatOfEveryPair()
{
    QFETCH(unsigned, seed);
    std::mt19937 random(seed);
    std::vector<Rectangle> rectangles = rectanglesIn({0, 0, 200, 60}, random, 5);
    std::shuffle(rectangles.begin(), rectangles.end(), random);
    int outer = 0, holes = 0;
    double area = 0.0;
    for (std::size_t i = 0; i < rectangles.size(); ++i) {
        std::size_t around = 0;
        for (std::size_t j = 0; j < rectangles.size(); ++j)
            around += i != j && rectangles[j].has(rectangles[i]) ? 1 : 0;
        (around % 2 == 0 ? outer : holes) += 1;
        area += around % 2 == 0 ? rectangles[i].area() : -rectangles[i].area();
    }
    std::vector<CurvePath> lines;
    for (const Rectangle &rectangle : rectangles)
        lines.push_back(around(rectangle));
    const std::vector<Outline> outlines = *outlinesOf(lines);
    QCOMPARE(static_cast<int>(outlines.size()), outer);
    double found = 0.0;
    int foundHoles = 0;
    for (const Outline &outline : outlines) {
        found += outline.outer.signedArea();
        for (const Contour &hole : outline.holes)
            found += hole.signedArea();
        foundHoles += static_cast<int>(outline.holes.size());
        for (std::size_t i = 0; i + 1 < outlines.size(); ++i)
            QVERIFY(outlines[i].outer.signedArea() >= outlines[i + 1].outer.signedArea());
    }
    QCOMPARE(foundHoles, holes);
    QVERIFY(std::abs(found - area) < 1e-6);
}

void TestOutlines::ringsLieInEachOtherThousandsDeep()
{
    constexpr int kRings = 5'000;
    std::vector<CurvePath> lines;
    for (int i = 0; i < kRings; ++i) {
        const double inset = 0.02 * ((i * 7'919) % kRings); // in no order
        lines.push_back(around({inset, inset, 500.0 - inset, 400.0 - inset}));
    }
    const std::vector<Outline> outlines = *outlinesOf(lines);
    QCOMPARE(outlines.size(), std::size_t(kRings / 2));
    for (const Outline &outline : outlines)
        QCOMPARE(outline.holes.size(), std::size_t(1));
    QVERIFY(!outlines.front().isInHole);
    for (std::size_t i = 1; i < outlines.size(); ++i)
        QVERIFY(outlines[i].isInHole);
}

// Wrong: what stands in the corner of an L would be a hole of it.
void TestOutlines::whatOnlyLiesInTheBoxIsNotInside()
{
    const CurvePath corner = closed({{0, 0}, {50, 0}, {50, 10}, {10, 10}, {10, 50}, {0, 50}});
    const CurvePath larger = closed({{-5, -5}, {60, -5}, {60, -1}, {-1, -1}, {-1, 60}, {-5, 60}});
    const std::vector<Outline> outlines =
        *outlinesOf({around({20, 20, 30, 30}), corner, larger, around({2, 2, 8, 8})});
    QCOMPARE(outlines.size(), std::size_t(3));
    for (const Outline &outline : outlines)
        QCOMPARE(outline.holes.size(),
                 std::size_t(std::abs(outline.outer.signedArea() - 900.0) < 1e-6 ? 1 : 0));
}

void TestOutlines::repeatedLinesCountOnce()
{
    std::vector<CurvePath> lines(500, around({0, 0, 10, 10}));
    lines.push_back(around({2, 2, 4, 4}));
    const std::vector<Outline> outlines = *outlinesOf(lines);
    QCOMPARE(outlines.size(), std::size_t(1));
    QCOMPARE(outlines.front().holes.size(), std::size_t(1));
}

void TestOutlines::edgesAreJoinedInAnyOrder_data()
{
    QTest::addColumn<unsigned>("seed"); // 0: forwards, 1: backwards
    QTest::newRow("as they follow each other") << 0u;
    QTest::newRow("the other way") << 1u;
    QTest::newRow("mixed up") << 2u;
    QTest::newRow("mixed up otherwise") << 3u;
}

// Wrong: a plan whose edges are lines of their own would come as thousands of lines.
void TestOutlines::edgesAreJoinedInAnyOrder()
{
    QFETCH(unsigned, seed);
    constexpr int kEdges = 2'000;
    const auto corner = [](int i) {
        const double angle = 2.0 * M_PI * (i % kEdges) / kEdges;
        return Vec2(1'000.0 * std::cos(angle), 1'000.0 * std::sin(angle));
    };
    std::vector<CurvePath> lines;
    std::mt19937 random(seed);
    for (int i = 0; i < kEdges; ++i) {
        const bool isTurned = seed > 1 && random() % 2 == 0;
        lines.push_back(CurvePath::fromLine(isTurned ? Polygon{corner(i + 1), corner(i)}
                                                     : Polygon{corner(i), corner(i + 1)})
                            .value());
    }
    if (seed == 1)
        std::reverse(lines.begin(), lines.end());
    if (seed > 1)
        std::shuffle(lines.begin(), lines.end(), random);
    const std::vector<CurvePath> whole = joined(lines, kDrawnGap);
    QCOMPARE(whole.size(), std::size_t(1));
    QVERIFY(whole.front().isClosed());
    QCOMPARE(whole.front().segmentCount(), kEdges);
    const double area = 0.5 * kEdges * 1e6 * std::sin(2.0 * M_PI / kEdges);
    QVERIFY(std::abs(outlinesOf(whole)->front().outer.signedArea() - area) < 1e-3);
}

// Wrong: a drop of a single curve would be left out.
void TestOutlines::aLoopOfOneSegmentIsAnOutline()
{
    const Result<CurvePath> drop = CurvePath::fromPoints({{0, 0}, {40, 40}, {-40, 40}, {0, 0}});
    QVERIFY(drop && drop->isClosed());
    const auto outlines = outlinesOf({*drop});
    QCOMPARE(outlines->size(), std::size_t(1));
    // 3 |p1 x p2| / 10 (1 + 2) / 2 of a loop from the origin.
    QVERIFY(std::abs(outlines->front().outer.signedArea() - 480.0) < 1e-6);
}

// Wrong: a path of places at random would keep the program busy for hours.
void TestOutlines::tanglesAreLeftOut()
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(0.0, 1'000.0);
    Polygon corners(40'000);
    for (Vec2 &corner : corners)
        corner = {place(random), place(random)};
    const std::vector<CurvePath> lines{closed(corners), around({0, 0, 10, 10})};
    QVERIFY(largestTangle(lines) > kMostCrossingWork);
    QCOMPARE(outlinesOf(lines)->size(), std::size_t(1));
    // A quarter of them would still be a minute.
    corners.resize(10'000);
    QVERIFY(largestTangle({closed(corners)}) > kMostCrossingWork);
    corners.resize(40'000);
    // As many corners of what does not cross itself are nothing.
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const double angle =
            2.0 * M_PI * static_cast<double>(i) / static_cast<double>(corners.size());
        corners[i] = (i % 2 == 0 ? 900.0 : 1'000.0) * Vec2(std::cos(angle), std::sin(angle));
    }
    QVERIFY(largestTangle({closed(corners)}) <= kMostCrossingWork);
    QCOMPARE(outlinesOf({closed(corners)})->size(), std::size_t(1));
}

FFF_TEST(TestOutlines)
#include "tst_outlines.moc"
