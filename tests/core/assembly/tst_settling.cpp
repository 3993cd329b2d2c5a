// Where things come to rest that do not stand as they were drawn.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/assembly/settling.h"
#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "tests/core/assembly/settle_oracle.h"
#include "tests/test_program.h"

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
    void whatIsOutsideRollsOntoTheNextFoot();
    void whatRollsTooFarFalls();
    void itRestsAsItsEnergySays();
    void nothingIsBelowTheGround();
    void nothingRestsNowhere();
};

// Wrong: a table with one leg a tenth too short falls over.
void TestSettling::aTableWithAShortLegRocks()
{
    for (const double shorter : {0.0, 0.04, 0.1, 0.5}) {
        const auto rest = settle(table(shorter), {2, 60, 2});
        QVERIFY(rest);
        QCOMPARE(rest->lean, 0.0);
        QCOMPARE(rest->contacts.size(), std::size_t(4));
    }
    // Two millimetres are more than rocking.
    QCOMPARE(settle(table(2.0), {2, 60, 2})->contacts.size(), std::size_t(3));
}

void TestSettling::whatIsOutsideRollsOntoTheNextFoot()
{
    const auto rest = settle(table(2.0), {-10, 60, -10});
    QVERIFY(rest);
    QCOMPARE(rest->contacts.size(), std::size_t(4)); // it rocks back onto the one that lifts
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
