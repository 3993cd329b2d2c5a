// What the search sees of two shapes: whether they meet and how far one has to slide.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/nesting/collision.h"
#include "core/nesting/poles.h"
#include "tests/core/nesting/nesting_oracle.h"
#include "tests/core/nesting/nesting_problems.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;
using nest::Axis;
using nest::Posed;

namespace {

Posed posed(const Region &outline)
{
    Posed result;
    nest::pose(outline, {}, Vec2::UnitX(), result);
    return result;
}

double sharedArea(const Region &a, const Region &b, const Vec2 &by)
{
    return oracleArea(lyingRings(a, Vec2::UnitX(), by), lyingRings(b, Vec2::UnitX(), Vec2::Zero()),
                      ClipperLib::ctIntersection);
}

} // namespace

class TestCollision : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void meetsWhereAreaIsShared();
    void sharedExtremes();
    void discsAreInside();
    void slidesOutAndBack();
    void holesAreRoom();
};

// Wrong: the search would take an overlap for a free place.
void TestCollision::meetsWhereAreaIsShared()
{
    constexpr unsigned kSeed = 11;
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<double> away(-60.0, 60.0);
    const std::vector<nest::Piece> pieces = stars(kSeed, 12, nest::Turning::None);
    int met = 0;
    for (int i = 0; i < 1000; ++i) {
        const Region &a = pieces[random() % pieces.size()].outline;
        const Region &b = pieces[random() % pieces.size()].outline;
        const Vec2 by(away(random), away(random));
        nest::Steps steps = 0;
        const bool isMeeting = nest::collide(posed(a), posed(b), by, steps);
        const double area = sharedArea(a, b, by);
        met += isMeeting ? 1 : 0;
        if (area > 1e-3)
            QVERIFY2(isMeeting, qPrintable(QStringLiteral("seed %1, pair %2").arg(kSeed).arg(i)));
        if (isMeeting)
            QVERIFY2(area > 0.0, qPrintable(QStringLiteral("seed %1, pair %2").arg(kSeed).arg(i)));
    }
    QVERIFY(met > 100);
}

// Wrong: an edge along the side of what both boxes share would be looked past by rounding.
void TestCollision::sharedExtremes()
{
    const Posed square = posed({{{-10, 10}, {-10, 0}, {1e-5, 0}, {1e-5, 10}}, {}});
    const Posed tip = posed({{{1e-5, 14}, {0, 14.000012}, {-12.00002, 7}, {0, -1.2e-5}}, {}});
    nest::Steps steps = 0;
    QVERIFY(nest::collide(square, tip, {-10.8507102, 3.99624}, steps));
}

void TestCollision::discsAreInside()
{
    for (const nest::Piece &piece : stars(5, 20, nest::Turning::None)) {
        const std::vector<nest::Pole> poles = nest::polesOf(piece.outline);
        QVERIFY(!poles.empty());
        const OracleRings rings = lyingRings(piece.outline, Vec2::UnitX(), Vec2::Zero());
        for (std::size_t i = 0; i < poles.size(); ++i) {
            QVERIFY(locate(poles[i].center, piece.outline) == Side::Inside);
            QVERIFY(oracleDistance({{poles[i].center}}, rings) >= poles[i].radius - 1e-9);
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY((poles[i].center - poles[j].center).norm() >=
                        poles[i].radius + poles[j].radius - 1e-9);
        }
    }
}

// Wrong: pieces would not lie as close as they can.
void TestCollision::slidesOutAndBack()
{
    constexpr unsigned kSeed = 3;
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<double> away(-30.0, 30.0);
    const std::vector<nest::Piece> pieces = stars(kSeed, 8, nest::Turning::None);
    nest::Steps steps = 0;
    for (int i = 0; i < 300; ++i) {
        const Posed a = posed(pieces[random() % pieces.size()].outline);
        const Posed b = posed(pieces[random() % pieces.size()].outline);
        for (const Axis axis : {Axis::X, Axis::Y}) {
            const Vec2 along = axis == Axis::X ? Vec2(Vec2::UnitX()) : Vec2(Vec2::UnitY());
            const Vec2 by(away(random), away(random));
            const double way = nest::wayOut(a, b, by, axis, steps);
            QVERIFY(!nest::collide(a, b, by + (way + 1e-9) * along, steps));
            if (way > 1e-6) {
                QVERIFY(nest::collide(a, b, by + (way - 1e-6) * along, steps));
                QVERIFY(nest::wayDown(a, b, by + (way + 1.0) * along, axis, 0.5, steps) <= 0.5);
            }
            const double down = nest::wayDown(a, b, by + 200.0 * along, axis, 150.0, steps);
            QVERIFY(!nest::collide(a, b, by + (200.0 - down + 1e-6) * along, steps));
            if (down < 150.0)
                QVERIFY(nest::collide(a, b, by + (200.0 - down - 1e-6) * along, steps));
        }
    }
}

void TestCollision::holesAreRoom()
{
    Region ring{box(0, 0, 100, 100), {{{10, 10}, {10, 90}, {90, 90}, {90, 10}}}};
    const Posed outer = posed(ring), inner = posed({box(0, 0, 20, 20), {}});
    nest::Steps steps = 0;
    QVERIFY(!nest::collide(inner, outer, {40, 40}, steps));
    QVERIFY(!nest::collide(outer, inner, {-40, -40}, steps));
    QVERIFY(nest::collide(inner, outer, {0, 40}, steps));
    QVERIFY(std::abs(nest::wayOut(inner, outer, {5, 40}, Axis::X, steps) - 5.0) < 1e-6);
    QVERIFY(std::abs(nest::wayOut(inner, outer, {75, 40}, Axis::X, steps) - 25.0) < 1e-6);
}

FFF_TEST(TestCollision)
#include "tst_collision.moc"
