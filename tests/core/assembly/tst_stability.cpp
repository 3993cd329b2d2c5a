#include "core/assembly/stability.h"
#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "core/geometry/convex_hull.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

/// Upright in a plane through `at`, turned about the vertical.
Frame upright(double turn, const Vec3 &at = Vec3::Zero())
{
    Frame frame = turned(turn);
    frame.origin = at;
    return frame;
}

Region regionOf(const Polygon &outer)
{
    return {outer, {}};
}

/// How deep the point lies in the hull of the others (negative: outside), by plain arithmetic: in
/// every direction, how far they reach beyond it. 36,000 directions: good to 0.02 mm here.
double depthByDirections(const std::vector<Vec2> &points, const Vec2 &point)
{
    double depth = std::numeric_limits<double>::infinity();
    constexpr int kDirections = 36000;
    for (int i = 0; i < kDirections; ++i) {
        const double a = 2.0 * std::numbers::pi * i / kDirections;
        const Vec2 d(std::cos(a), std::sin(a));
        double reach = -std::numeric_limits<double>::infinity();
        for (const Vec2 &p : points)
            reach = std::max(reach, d.dot(p - point));
        depth = std::min(depth, reach);
    }
    return depth;
}

} // namespace

class TestStability : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void plateStandsOnItsWholeEdge();
    void heights_data();
    void heights();
    void aFootThatIsALittleLowIsAFoot_data();
    void aFootThatIsALittleLowIsAFoot();
    void marginIsTheDepthInTheHull();
};

// A plate taken for its mid-plane would stand on a line and fall.
void TestStability::plateStandsOnItsWholeEdge()
{
    const Region plate = regionOf(rectangle(-80, 0, 80, 60));
    const Frame frame = front();
    const GroundContact contact = groundContact({{plate, frame, 6.0}});
    QCOMPARE(contact.stretches, 1);
    const Stability found = stability(contact, {0, 30, 0}, 6.0, 160.0);
    QCOMPARE(found.standing, Standing::Stands);
    QVERIFY(std::abs(found.margin - 3.0) < 1e-9);
    QVERIFY(std::abs(found.tipAngle - std::atan(3.0 / 30.0)) < 1e-9); // c22: 5.7 degrees
    QVERIFY(std::abs(signedArea(found.support) - 160.0 * 6.0) < 1e-6);
}

void TestStability::heights_data()
{
    QTest::addColumn<double>("height"); // of a plate's lower edge
    QTest::addColumn<int>("standing");
    QTest::newRow("on the ground") << 0.0 << int(Standing::Stands);
    QTest::newRow("just within the tolerance above") << 0.049 << int(Standing::Stands);
    QTest::newRow("just beyond it") << 0.051 << int(Standing::NoContact);
    QTest::newRow("a hand's breadth above") << 100.0 << int(Standing::NoContact);
    QTest::newRow("sunk as FlatFab sinks its models") << -0.127 << int(Standing::Stands);
    QTest::newRow("just within the tolerance below") << -0.049 << int(Standing::Stands);
    QTest::newRow("deeper, but not in the ground") << -0.051 << int(Standing::Stands);
    QTest::newRow("just not in the ground") << -0.199 << int(Standing::Stands);
    QTest::newRow("just in the ground") << -0.201 << int(Standing::BelowGround);
    QTest::newRow("below the ground") << -0.3 << int(Standing::BelowGround);
    QTest::newRow("half below the ground") << -30.0 << int(Standing::BelowGround);
}

// A model that hangs in the air or is sunk in the ground must not be said to stand.
void TestStability::heights()
{
    QFETCH(double, height);
    QFETCH(int, standing);
    const Region plate = regionOf(rectangle(-80, height, 80, height + 60));
    const Frame a = front(-40), b = front(40);
    const GroundContact contact = groundContact({{plate, a, 6.0}, {plate, b, 6.0}});
    const Stability found = stability(contact, {0, height + 30, 0}, 6.0, 160.0);
    QCOMPARE(int(found.standing), standing);
    QCOMPARE(found.height, height);
    QCOMPARE(found.contacts, found.standing == Standing::Stands ? 2 : 0);
}

void TestStability::aFootThatIsALittleLowIsAFoot_data()
{
    QTest::addColumn<double>("height"); // of one of two feet, the other is on the ground
    QTest::addColumn<int>("contacts");
    QTest::newRow("too high to touch") << 0.051 << 1;
    QTest::newRow("a little high") << 0.049 << 2;
    QTest::newRow("a little low") << -0.049 << 2;
    QTest::newRow("lower") << -0.051 << 2;
    QTest::newRow("as low as a foot may be") << -0.199 << 2;
    QTest::newRow("in the ground, where nothing stands") << -0.201 << 0;
}

// Wrong: what stands on all its feet falls over because one was drawn a tenth of a millimetre
// deeper.
void TestStability::aFootThatIsALittleLowIsAFoot()
{
    QFETCH(double, height);
    QFETCH(int, contacts);
    const Region plate = regionOf(rectangle(-80, 0, 80, 60));
    const Region other = regionOf(rectangle(-80, height, 80, 60));
    const Frame a = front(-40), b = front(40);
    const Stability found =
        stability(groundContact({{plate, a, 6.0}, {other, b, 6.0}}), {0, 30, 0}, 6.0, 160.0);
    QCOMPARE(found.contacts, contacts);
    QCOMPARE(found.standing, contacts == 2   ? Standing::Stands
                             : contacts == 1 ? Standing::Topples
                                             : Standing::BelowGround);
}

// The margin by brute force: how deep the point lies under every direction's farthest contact.
void TestStability::marginIsTheDepthInTheHull()
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-100, 100), angle(0, std::numbers::pi);
    for (int round = 0; round < 20; ++round) {
        std::vector<Frame> frames;
        for (int i = 0; i < 4; ++i)
            frames.push_back(upright(angle(random), {place(random), 0, place(random)}));
        const Region foot = regionOf(rectangle(-5, 0, 5, 60));
        std::vector<Slab> slabs;
        std::vector<Vec2> corners;
        for (const Frame &frame : frames) {
            slabs.push_back({foot, frame, 3.0});
            for (const double x : {-5.0, 5.0})
                for (const double side : {-1.5, 1.5}) {
                    const Vec3 p = frame.toWorld({x, 0}) + side * frame.normal();
                    corners.emplace_back(p.x(), p.z());
                }
        }
        const Vec3 centre(place(random), 80, place(random));
        const Stability found = stability(groundContact(slabs), centre, 3.0, 200.0);
        const double depth = depthByDirections(corners, {centre.x(), centre.z()});
        QVERIFY2(std::abs(found.margin - depth) < 0.02,
                 qPrintable(QStringLiteral("%1 %2").arg(found.margin).arg(depth)));
        QCOMPARE(found.standing, depth > 0.0 ? Standing::Stands : Standing::Topples);
    }
}

FFF_TEST(TestStability)
#include "tst_stability.moc"
