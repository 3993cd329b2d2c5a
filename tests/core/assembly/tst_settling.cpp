// Where things come to rest that do not stand as they were drawn.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/assembly/settling.h"
#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "tests/core/assembly/settle_oracle.h"
#include "tests/test_program.h"

#include <algorithm>
#include <numbers>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

/// Four feet, 100 × 80 apart, the first one shorter by so much.
std::vector<Vec3> table(double shorter)
{
    return {{-50, shorter, -40}, {50, 0, -40}, {50, 0, 40}, {-50, 0, 40}};
}

double angleBetween(const Vec3 &a, const Vec3 &b)
{
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

} // namespace

class TestSettling : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aTableWithAShortLegRocks();
    void manyFeetAreOnePlane();
    void whatIsOutsideRollsOntoTheNextFoot();
    void whatHangsBesideCatchesIt();
    void whatRollsTooFarFalls();
    void itTipsOverTheLastFaceOfItsHull();
    void roundFeetCountAsTheyAre();
    void aWheelDoesNotStand();
    void whatIsLowestCounts();
    void ofASlabItsUndermostPointsAreEnough();
    void itRestsAsItsEnergySays();
    void nothingIsBelowTheGround();
    void nothingRestsNowhere();
};

// Wrong: a table with one leg a little short falls over, or at a touch.
void TestSettling::aTableWithAShortLegRocks()
{
    for (const double shorter : {0.0, 0.04, 0.1, 0.5, 2.0}) {
        const auto rest = settle(table(shorter), {2, 60, 2});
        QVERIFY(rest);
        QCOMPARE(rest->lean, 0.0);
        QCOMPARE(rest->contacts.size(), std::size_t(4));
        // Over the front edge, 38 away, which all of its legs but the short one are beside.
        QVERIFY(std::abs(rest->tipAngle - std::atan(38.0 / 60.0)) < radians(0.5));
        const double arm = 2.0 * 50.0 * 80.0 / std::hypot(100.0, 80.0);
        const double expected = shorter > kGroundContact ? std::atan(shorter / arm) : 0.0;
        QVERIFY(std::abs(rest->rocking - expected) < 1e-9);
    }
    // One that is far too short is no foot.
    const auto rest = settle(table(20.0), {20, 60, 20});
    QVERIFY(rest);
    QCOMPARE(rest->contacts.size(), std::size_t(3));
}

// Wrong: a margin that hangs on which of many feet, level but for rounding, are looked at first.
void TestSettling::manyFeetAreOnePlane()
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> x(-50, 50), z(-40, 40), rounding(0.0, 1e-9);
    for (int round = 0; round < 20; ++round) {
        std::vector<Vec3> points = table(0.0);
        for (int foot = 0; foot < 500; ++foot)
            points.emplace_back(x(random), 0.0, z(random));
        if (round % 2 == 1)
            for (Vec3 &p : points)
                p.y() += rounding(random);
        std::shuffle(points.begin(), points.end(), random);
        const auto rest = settle(points, {2, 60, 2});
        QVERIFY(rest);
        QVERIFY(std::abs(rest->tipAngle - std::atan(38.0 / 60.0)) < 1e-7);
        QVERIFY(std::abs(rest->margin - 38.0) < 1e-6);
        QVERIFY(std::abs(rest->edge.z() - 40.0) < 1e-6 && std::abs(rest->edge.x() - 2.0) < 1e-6);
        QCOMPARE(rest->rocking, 0.0);
    }
}

// Wrong: "the slightest push tips it over" of a plate on its edge, beside which something hangs by
// half a millimetre.
void TestSettling::whatHangsBesideCatchesIt()
{
    for (const double hangs : {0.1, 0.3, 0.5, 1.0, 2.0}) {
        std::vector<Vec3> points;
        for (const double x : {-40.0, 40.0})
            for (const double z : {-1.5, 1.5}) {
                points.emplace_back(x, 0.0, z);
                points.emplace_back(z, hangs, x);
            }
        const auto rest = settle(points, {0, 30, 0});
        QVERIFY(rest);
        QCOMPARE(rest->lean, 0.0);
        const double rocks = std::atan(hangs / 38.5);
        QVERIFY(std::abs(rest->rocking - rocks) < kGroundContact / 38.5);
        // It stands on the far end of what hung, leaning, and the nearer edge of the plate.
        QVERIFY2(rest->tipAngle > radians(40.0) && rest->tipAngle < radians(54.0),
                 qPrintable(QString::number(degrees(rest->tipAngle))));
    }
    // Where it hangs too high nothing catches it.
    const auto rest = settle(
        {{-40, 0, -1.5}, {40, 0, -1.5}, {40, 0, 1.5}, {-40, 0, 1.5}, {0, 9, -40}, {0, 9, 40}},
        {0, 30, 0});
    QVERIFY(std::abs(rest->tipAngle - std::atan(1.5 / 30.0)) < 1e-9);
    QVERIFY(std::abs(rest->margin - 1.5) < 1e-9);
    QCOMPARE(rest->rocking, 0.0);
}

void TestSettling::whatIsOutsideRollsOntoTheNextFoot()
{
    const auto rest = settle(table(2.0), {-10, 60, -10});
    QVERIFY(rest);
    QVERIFY(rest->ground.up.x() > 0.0 && rest->ground.up.z() > 0.0); // it leans the other way
    // Over the diagonal, of which the short leg is 2 · 50 · 80 / √(100² + 80²) away.
    const double arm = 2.0 * 50.0 * 80.0 / std::hypot(100.0, 80.0);
    QVERIFY(std::abs(rest->lean - std::atan(2.0 / arm)) < 1e-9);
}

void TestSettling::whatRollsTooFarFalls()
{
    QVERIFY(!settle(table(20.0), {-10, 60, -10}));
    QVERIFY(settle(table(20.0), {10, 60, 10}));
    // Beside all of its feet there is nothing to stand on.
    QVERIFY(!settle(table(0.0), {70, 60, 0}));
}

// The way of least energy, found without any feet at all.
void TestSettling::itRestsAsItsEnergySays()
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> across(-80, 80), up(0, 20), centre(-40, 40);
    int stood = 0, fell = 0;
    for (int round = 0; round < 300; ++round) {
        std::vector<Vec3> points;
        for (int i = 0; i < 12; ++i)
            points.emplace_back(across(random), up(random), across(random));
        const Vec3 mass(centre(random), 60.0, centre(random));
        const auto rest = settle(points, mass);
        const SettleOracle oracle(points, mass);
        (rest ? stood : fell) += 1;
        if (!rest) {
            QVERIFY(oracle.lean() > kFarthestLean - radians(0.5));
            continue;
        }
        const Vec3 &ground = rest->ground.up;
        // As long as ways are short: what leans farther is lower by its own cosine, too.
        const double height = oracle.heightAt(ground.x() / ground.y(), ground.z() / ground.y());
        QVERIFY2(height / ground.y() <
                     oracle.height() / std::cos(oracle.lean()) + 2.0 * kGroundContact,
                 qPrintable(QStringLiteral("%1: leans %2, not %3")
                                .arg(round)
                                .arg(degrees(rest->lean))
                                .arg(degrees(oracle.lean()))));
    }
    QVERIFY(stood > 50 && fell > 30);
}

// By the faces of the points' hull, found by trying all planes, and the ways over its edges.
void TestSettling::itTipsOverTheLastFaceOfItsHull()
{
    std::mt19937 random(13);
    std::uniform_real_distribution<double> across(-80, 80), up(0, 9), centre(-25, 25);
    int stood = 0, rocked = 0;
    for (int round = 0; round < 300; ++round) {
        std::vector<Vec3> points;
        for (int i = 0; i < 10; ++i)
            points.emplace_back(across(random), up(random), across(random));
        const Vec3 mass(centre(random), 60.0, centre(random));
        const auto rest = settle(points, mass);
        if (!rest)
            continue;
        const HullOracle oracle(points, mass, kFarthestLean);
        const std::optional<double> tip = oracle.tipAngle(rest->ground.up);
        if (!tip)
            continue; // two faces that differ by less than what counts as touching
        ++stood;
        rocked += rest->rocking > 0.0 ? 1 : 0;
        QVERIFY2(std::abs(rest->tipAngle - *tip) < radians(0.2),
                 qPrintable(QStringLiteral("%1: tips past %2, not %3")
                                .arg(round)
                                .arg(degrees(rest->tipAngle))
                                .arg(degrees(*tip))));
        QVERIFY(std::abs(rest->margin) < 120.0);
    }
    QVERIFY2(stood > 100 && rocked > 20,
             qPrintable(QStringLiteral("%1 %2").arg(stood).arg(rocked)));
}

// Wrong: "tips past 16°" of a dinosaur that tips past 24°, as its toes have more faces than were
// looked at.
void TestSettling::roundFeetCountAsTheyAre()
{
    const auto feet = [](int each) {
        std::vector<Vec3> points;
        for (const Vec2 &foot : {Vec2(-50, -30), Vec2(50, -30), Vec2(0, 50)})
            for (int i = 0; i <= each; ++i)
                for (const double side : {-1.5, 1.5}) {
                    const double angle = radians(-30.0 + 60.0 * i / each);
                    points.emplace_back(foot.x() + 8.0 * std::sin(angle),
                                        8.0 - 8.0 * std::cos(angle), foot.y() + side);
                }
        return points;
    };
    double coarse = 0.0;
    for (const int each : {16, 64, 256}) {
        const auto rest = settle(feet(each), {3, 60, -2});
        QVERIFY(rest);
        QVERIFY(degrees(rest->tipAngle) > 15.0);
        if (each == 16)
            coarse = rest->tipAngle;
        QVERIFY2(std::abs(rest->tipAngle - coarse) < radians(0.5),
                 qPrintable(QStringLiteral("%1: %2, not %3")
                                .arg(each)
                                .arg(degrees(rest->tipAngle))
                                .arg(degrees(coarse))));
    }
}

// Wrong: "tips past 7°" of a disc on its rim: a few of its corners are within what counts as
// contact.
void TestSettling::aWheelDoesNotStand()
{
    for (const double radius : {1.0, 5.0, 50.0})
        for (const int corners : {60, 180, 720}) {
            std::vector<Vec3> points;
            for (int i = 0; i < corners; ++i)
                for (const double side : {-0.2 * radius, 0.2 * radius}) {
                    const double angle = 2.0 * std::numbers::pi * (i + 0.5) / corners;
                    points.emplace_back(radius * std::sin(angle), radius * (1.0 - std::cos(angle)),
                                        side);
                }
            const auto rest = settle(points, {0, radius, 0});
            QVERIFY(rest);
            const double expected = std::numbers::pi / corners; // half of what one side turns it
            QVERIFY2(std::abs(rest->tipAngle - expected) < 0.01 * expected,
                     qPrintable(QStringLiteral("%1 of %2: %3")
                                    .arg(corners)
                                    .arg(radius)
                                    .arg(degrees(rest->tipAngle))));
        }
}

// Wrong: "falls at a touch" of a thin plate with a wavy edge, whose lowest points lie between two
// that count as on the ground.
void TestSettling::whatIsLowestCounts()
{
    const std::vector<Vec3> points{
        {-60, 0.04, -0.05}, {-60, 0.04, 0.05}, {60, 0.04, -0.05}, {60, 0.04, 0.05}, {-20, 0, -0.05},
        {-20, 0, 0.05},     {20, 0, -0.05},    {20, 0, 0.05},     {0, 0.03, -40},   {0, 0.03, 40}};
    const auto rest = settle(points, {0, 30, 0});
    QVERIFY(rest);
    // Over the line from one end of the wavy edge to one end of what crosses it.
    const double away = 60.0 * 40.0 / std::hypot(60.0, 40.0);
    QVERIFY2(std::abs(rest->tipAngle - std::atan(away / 30.0)) < radians(0.3),
             qPrintable(QString::number(degrees(rest->tipAngle))));
}

// Upright, oblique and lying ones, of few corners and of many: as all corners of both faces say.
void TestSettling::ofASlabItsUndermostPointsAreEnough()
{
    std::mt19937 random(31);
    std::uniform_real_distribution<double> unit(-1, 1);
    int resting = 0;
    for (int round = 0; round < 400; ++round) {
        const int corners = 3 + round % 40;
        Region region;
        for (int i = 0; i < corners; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / corners;
            region.outer.push_back((40.0 + 20.0 * unit(random)) *
                                   Vec2(std::cos(angle), std::sin(angle)));
        }
        Vec3 normal = Vec3(unit(random), unit(random), unit(random)).normalized();
        if (round % 3 == 0)
            normal = Vec3::UnitY();
        if (round % 3 == 1)
            normal = Vec3(normal.x(), 0.0, normal.z()).normalized();
        const Vec3 x = normal.cross(Vec3(0.3, 0.5, 0.81)).normalized();
        const Frame frame{Vec3(0, 50, 0), x, normal.cross(x)};
        const Slab slab{region, frame, 3.0};
        std::vector<Vec3> all;
        for (const Vec2 &corner : slab.region.outer)
            for (const double side : {-1.5, 1.5})
                all.push_back(slab.frame.toWorld(corner) + side * slab.frame.normal());
        const std::vector<Vec3> few = undermost(slab);
        QVERIFY(few.size() <= all.size());
        // With two feet beside it, so that upright ones stand, too.
        const double low =
            std::min_element(all.begin(), all.end(), [](const Vec3 &a, const Vec3 &b) {
                return a.y() < b.y();
            })->y();
        std::vector<Vec3> ofAll = all, ofFew = few;
        for (const Vec3 &foot : {Vec3(50, low + 0.2, 70), Vec3(-50, low, 70), Vec3(20, low, -70)}) {
            ofAll.push_back(foot);
            ofFew.push_back(foot);
        }
        const Vec3 centre(5.0 * unit(random), low + 40.0, 5.0 * unit(random));
        const auto expected = settle(ofAll, centre), found = settle(ofFew, centre);
        QCOMPARE(found.has_value(), expected.has_value());
        if (!expected)
            continue;
        ++resting;
        QVERIFY(std::abs(found->tipAngle - expected->tipAngle) < 1e-7);
        QVERIFY(std::abs(found->lean - expected->lean) < 1e-7);
        QVERIFY(std::abs(found->rocking - expected->rocking) < 1e-7);
        QVERIFY(std::abs(found->margin - expected->margin) < 1e-5);
    }
    QVERIFY2(resting > 200, QByteArray::number(resting));
}

void TestSettling::nothingIsBelowTheGround()
{
    std::mt19937 random(12);
    std::uniform_real_distribution<double> across(-80, 80), up(0, 6);
    for (int round = 0; round < 200; ++round) {
        std::vector<Vec3> points;
        for (int i = 0; i < 20; ++i)
            points.emplace_back(across(random), up(random), across(random));
        const auto rest = settle(points, {0, 50, 0});
        if (!rest)
            continue;
        QVERIFY(std::abs(rest->ground.up.norm() - 1.0) < 1e-12);
        QVERIFY(std::abs(angleBetween(rest->ground.up, Vec3::UnitY()) - rest->lean) < 1e-6);
        for (const Vec3 &p : points)
            QVERIFY(rest->ground.above(p) >= -1e-9);
        const Vec3 x = rest->ground.acrossX(), z = rest->ground.acrossZ();
        QVERIFY(std::abs(x.dot(rest->ground.up)) < 1e-12 && std::abs(z.dot(x)) < 1e-12);
        QVERIFY(z.cross(x).dot(rest->ground.up) > 0.999);
    }
}

void TestSettling::nothingRestsNowhere()
{
    QVERIFY(!settle({}, Vec3::Zero()));
    // On a point right below it, as an egg might.
    QVERIFY(settle({{0, 0, 0}, {50, 30, 0}}, {0, 40, 0}));
}

FFF_TEST(TestSettling)
#include "tst_settling.moc"
