// How deep two sections are in each other. If this fails, a note of half a millimetre stands beside
// sections of which one would have to be cut through.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/assembly/overlap_depth.h"
#include "core/assembly/solid.h"
#include "core/base/tolerances.h"
#include "core/geometry/triangulation.h"
#include "tests/core/assembly/plates.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

struct Board
{
    Board(Polygon outline, const Frame &placed, double thickness)
        : region{std::move(outline), {}}, frame(placed),
          solid(makeSolid(triangulate(region).value(), frame, thickness))
    {
    }
    /// Outside by so much at the most, mm.
    bool has(const Vec3 &p) const
    {
        constexpr double kRounding = 1e-6;
        return std::abs(frame.height(p)) <= solid.half + kRounding &&
               locate(frame.toLocal(p), region) != Side::Outside;
    }

    Region region;
    Frame frame;
    Solid solid;
};

double depthOf(const Board &a, const Board &b)
{
    const auto overlap = overlapOf(a.solid, b.solid, kTouchingDepth);
    return overlap ? overlap->depth : 0.0;
}

Polygon star(int points, double inner, double outer)
{
    Polygon polygon;
    for (int i = 0; i < 2 * points; ++i) {
        const double angle = std::numbers::pi * i / points;
        polygon.push_back((i % 2 ? inner : outer) * Vec2(std::cos(angle), std::sin(angle)));
    }
    return polygon;
}

} // namespace

class TestOverlapDepth : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void boards_data();
    void boards();
    void tipsThatCross();
    void heldFromTwoSides();
    void anywhere();
};

void TestOverlapDepth::boards_data()
{
    QTest::addColumn<Frame>("frame"); // of a board of 40 x 20 beside one that lies at the origin
    QTest::addColumn<double>("depth");
    const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
    QTest::newRow("side by side") << Frame{{40, 0, 0}, x, y} << 0.0;
    QTest::newRow("side by side, 2 mm in") << Frame{{38, 0, 0}, x, y} << 2.0;
    QTest::newRow("side by side, all in") << Frame{{2, 1, 0}, x, y} << 3.0;
    QTest::newRow("on top") << Frame{{2, 1, 3}, x, y} << 0.0;
    QTest::newRow("on top, 1.2 mm in") << Frame{{2, 1, 1.8}, x, y} << 1.2;
    QTest::newRow("an edge on a face") << Frame{{0, 0, 11.5}, x, z} << 0.0;
    QTest::newRow("an edge in a face") << Frame{{0, 0, 11.2}, x, z} << 0.3;
    QTest::newRow("a corner in a corner") << Frame{{39, 19, 0}, x, y} << 1.0;
    QTest::newRow("across near the end") << Frame{{19, 0, 0}, y, z} << 2.5;
}

void TestOverlapDepth::boards()
{
    QFETCH(const Frame, frame);
    QFETCH(const double, depth);
    const Board still(rectangle(-20, -10, 20, 10), {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()},
                      3.0);
    const Board other(rectangle(-20, -10, 20, 10), frame, 3.0);
    for (const double found : {depthOf(still, other), depthOf(other, still)})
        QVERIFY2(std::abs(found - depth) < 0.01, qPrintable(QString::number(found)));
}

// Many thin triangles in a round tip, none of which is as deep as all of them.
void TestOverlapDepth::tipsThatCross()
{
    Polygon tip{{-6, -45}, {6, -45}};
    for (int i = 0; i <= 32; ++i) {
        const double angle = std::numbers::pi * i / 32;
        tip.emplace_back(6.0 * std::cos(angle), 6.0 * std::sin(angle) - 6.0);
    }
    for (const double half : {10.0, 16.5, 25.0, 35.0}) {
        const double sine = std::sin(half / 57.29577951), cosine = std::cos(half / 57.29577951);
        const Board left(tip, {Vec3::Zero(), Vec3::UnitZ(), {sine, -cosine, 0}}, 3.0);
        const Board right(tip, {Vec3::Zero(), Vec3::UnitZ(), {-sine, -cosine, 0}}, 3.0);
        const double depth = depthOf(left, right);
        QVERIFY2(depth > 1.5 && depth < 3.2, qPrintable(QString::number(depth)));
    }
}

// Wrong: what is pressed into a groove a little too tight would have to come all the way out.
void TestOverlapDepth::heldFromTwoSides()
{
    const Polygon groove{{-30, -20}, {30, -20},  {30, 20},   {1.4, 20},
                         {1.4, -5},  {-1.4, -5}, {-1.4, 20}, {-30, 20}};
    const Board host(groove, {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()}, 3.0);
    const Board guest(rectangle(-15, -5, 15, 30), {Vec3::Zero(), Vec3::UnitZ(), Vec3::UnitY()},
                      3.0);
    const double depth = depthOf(host, guest);
    QVERIFY2(std::abs(depth - 0.1) < 0.01, qPrintable(QString::number(depth)));
}

// Of points anywhere that are in both boards: no room of them is thinner by more than their
// distances than what is told, and none thicker.
void TestOverlapDepth::anywhere()
{
    std::mt19937 random(31);
    std::uniform_real_distribution<double> u(-1.0, 1.0);
    const auto vector = [&] { return Vec3(u(random), u(random), u(random)); };
    std::vector<Vec3> ways;
    for (int i = 0; i < 400; ++i)
        ways.push_back(vector().normalized());
    int compared = 0;
    for (int round = 0; round < 400 && compared < 30; ++round) {
        const auto frame = [&] { return makeFrame(22.0 * vector(), vector(), vector()).value(); };
        const bool isConvex = round % 2 == 0;
        const Board a(rectangle(-20, -8, 20, 8), frame(), 3.0);
        const Board b(isConvex ? rectangle(-6, -25, 6, 25) : star(5, 6.0, 22.0), frame(), 4.0);
        const auto overlap = overlapOf(a.solid, b.solid, kTouchingDepth);
        if (!overlap || overlap->depth < 0.5)
            continue;
        ++compared;
        QVERIFY(a.has(overlap->at) && b.has(overlap->at));
        std::vector<Vec3> shared;
        for (int i = 0; i < 60000; ++i) {
            const Vec3 p = a.frame.toWorld(Vec2(20.0 * u(random), 8.0 * u(random))) +
                           1.5 * u(random) * a.frame.normal();
            if (b.has(p))
                shared.push_back(p);
        }
        double width = std::numeric_limits<double>::infinity();
        for (const Vec3 &way : ways) {
            Extent extent;
            for (const Vec3 &p : shared) {
                extent.min = std::min(extent.min, way.dot(p));
                extent.max = std::max(extent.max, way.dot(p));
            }
            width = std::min(width, extent.max - extent.min);
        }
        // A star may meet the board in two rooms, which the points take for one.
        if (isConvex)
            QVERIFY2(overlap->depth > 0.95 * width - 0.3,
                     qPrintable(QStringLiteral("%1 of %2").arg(overlap->depth).arg(width)));
    }
    QCOMPARE(compared, 30);
}

FFF_TEST(TestOverlapDepth)
#include "tst_overlap_depth.moc"
