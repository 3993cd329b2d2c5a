#include "core/assembly/slab.h"
#include "core/model/shape.h"
#include "tests/core/assembly/plates.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <QTest>

#include <random>

using namespace fff;
using namespace fff::test;

namespace {

/// The nearest point of a rectangular slab, by its three coordinates.
Vec3 nearestOfBox(const Vec3 &p, const Slab &slab)
{
    const Box2 box = bounds(slab.region.outer);
    const Vec2 local = slab.frame.toLocal(p).cwiseMax(box.min).cwiseMin(box.max);
    const double half = 0.5 * slab.thickness;
    return slab.frame.toWorld(local) +
           std::clamp(slab.frame.height(p), -half, half) * slab.frame.normal();
}

/// Between two boxes, by going to and fro between their nearest points (J. von Neumann 1950).
double distanceByProjections(const Slab &a, const Slab &b)
{
    Vec3 onA = a.frame.origin, onB = b.frame.origin;
    for (int i = 0; i < 20000; ++i) {
        onB = nearestOfBox(onA, b);
        onA = nearestOfBox(onB, a);
    }
    return (onA - onB).norm();
}

Frame anywhere(std::mt19937 &random, double reach)
{
    std::uniform_real_distribution<double> u(-1.0, 1.0);
    const auto vector = [&] { return Vec3(u(random), u(random), u(random)); };
    return makeFrame(reach * vector(), vector(), vector()).value();
}

} // namespace

class TestSlab : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void distances_data();
    void distances();
    void whatMeetsIsNotApart();
    void distanceIsThatOfBoxes();
    void distanceHasNoSides();
    void holesCount();
    void limitIsKept();
};

void TestSlab::distances_data()
{
    QTest::addColumn<Frame>("frame");
    QTest::addColumn<double>("distance");
    // The other slab: 40 x 40 x 3 in the front plane, from the origin to the right and up.
    QTest::newRow("face to face") << front(13) << 10.0;
    QTest::newRow("touching faces") << front(3) << 0.0;
    QTest::newRow("one in the other") << front(1) << 0.0;
    QTest::newRow("the same place") << front() << 0.0;
    QTest::newRow("beside each other") << Frame{{47, 0, 0}, Vec3::UnitX(), Vec3::UnitY()} << 7.0;
    QTest::newRow("corner to corner") << Frame{{43, 44, 0}, Vec3::UnitX(), Vec3::UnitY()} << 5.0;
    QTest::newRow("an edge before a face")
        << Frame{{20, 0, 15}, Vec3::UnitZ(), Vec3::UnitY()} << 13.5;
    QTest::newRow("a plate through a face")
        << Frame{{20, 10, -20}, Vec3::UnitZ(), Vec3::UnitY()} << 0.0;
    QTest::newRow("a corner over the middle of a face")
        << Frame{{20, 20, 11.5}, Vec3(1, 0, 2).normalized(), Vec3(-2, 5, 1).normalized()} << -1.0;
}

void TestSlab::distances()
{
    QFETCH(Frame, frame);
    QFETCH(double, distance);
    const Region plate{rectangle(0, 0, 40, 40), {}};
    const Frame still = front();
    const Slab a{plate, still, 3.0}, b{plate, frame, 3.0};
    const Nearest found = nearestPoints(a, b);
    if (distance < 0.0)
        distance = distanceByProjections(a, b);
    QVERIFY2(std::abs(found.distance - distance) < 1e-6,
             qPrintable(QStringLiteral("%1 instead of %2").arg(found.distance).arg(distance)));
    QVERIFY(std::abs((found.onA - found.onB).norm() - found.distance) < 1e-9);
    QVERIFY((nearestOfBox(found.onA, a) - found.onA).norm() < 1e-6);
    QVERIFY((nearestOfBox(found.onB, b) - found.onB).norm() < 1e-6);
}

// Rectangles so near that most go through each other, and by edges alone.
void TestSlab::whatMeetsIsNotApart()
{
    std::mt19937 random(5);
    int met = 0;
    for (int round = 0; round < 200; ++round) {
        const Region one{rectangle(-30, -10, 30, 10), {}}, two{rectangle(-5, -40, 5, 40), {}};
        const Frame frameA = anywhere(random, 25), frameB = anywhere(random, 25);
        const Slab a{one, frameA, 4.0}, b{two, frameB, 2.0};
        if (distanceByProjections(a, b) > 1e-7)
            continue;
        ++met;
        const double found = nearestPoints(a, b).distance;
        QVERIFY2(found == 0.0, qPrintable(QStringLiteral("%1: %2").arg(round).arg(found)));
    }
    QVERIFY(met > 30);
}

// Rectangles anywhere, by another method.
void TestSlab::distanceIsThatOfBoxes()
{
    constexpr unsigned kSeed = 17;
    std::mt19937 random(kSeed);
    int apart = 0;
    for (int round = 0; round < 60; ++round) {
        const Region one{rectangle(-30, -10, 30, 10), {}}, two{rectangle(-5, -40, 5, 40), {}};
        const Frame frameA = anywhere(random, 60), frameB = anywhere(random, 60);
        const Slab a{one, frameA, 4.0}, b{two, frameB, 2.0};
        const double expected = distanceByProjections(a, b), found = nearestPoints(a, b).distance;
        apart += expected > 1.0 ? 1 : 0;
        QVERIFY2(found <= expected + 1e-9 && found > expected - 0.02,
                 qPrintable(QStringLiteral("seed %1, round %2: %3 instead of %4")
                                .arg(kSeed)
                                .arg(round)
                                .arg(found)
                                .arg(expected)));
    }
    QVERIFY(apart > 20 && apart < 60);
}

void TestSlab::distanceHasNoSides()
{
    std::mt19937 random(23);
    for (int round = 0; round < 20; ++round) {
        const Region one{blob(random, 8, 30).flatten(0.05).points, {}},
            two{comb(4).flatten(0.05).points, {}};
        const Frame frameA = anywhere(random, 70), frameB = anywhere(random, 70);
        const Slab a{one, frameA, 4.0}, b{two, frameB, 2.0};
        QVERIFY(std::abs(nearestPoints(a, b).distance - nearestPoints(b, a).distance) < 1e-9);
    }
}

// A stick through a hole touches nothing.
void TestSlab::holesCount()
{
    const Region plate{rectangle(-20, -20, 20, 20), {{{-10, -10}, {-10, 10}, {10, 10}, {10, -10}}}};
    const Region stick{rectangle(-30, -2, 30, 2), {}};
    const Frame flat = front(), across{Vec3::Zero(), Vec3::UnitZ(), Vec3::UnitY()};
    QVERIFY(std::abs(nearestPoints({plate, flat, 3.0}, {stick, across, 3.0}).distance - 8.0) <
            1e-9);
}

void TestSlab::limitIsKept()
{
    const Region plate{rectangle(0, 0, 40, 40), {}};
    const Frame one = front(), two = front(13);
    QVERIFY(std::isinf(nearestPoints({plate, one, 3.0}, {plate, two, 3.0}, 9.9).distance));
    QCOMPARE(nearestPoints({plate, one, 3.0}, {plate, two, 3.0}, 10.1).distance, 10.0);
    QCOMPARE(distanceBetween(boundsOf({plate, one, 3.0}), boundsOf({plate, two, 3.0})), 10.0);
}

FFF_TEST(TestSlab)
#include "tst_slab.moc"
