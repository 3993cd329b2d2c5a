// Parts put elsewhere by hand: what may lie where, and where they snap to, as laws over squares,
// which are easy to judge, and over stars, which nobody would guess.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/base/units.h"
#include "core/fabrication/hand_placing.h"
#include "core/geometry/turning.h"
#include "tests/core/assembly/plates.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <cmath>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

constexpr double kNear = 0.02; // mm

Part partOf(const Polygon &outline)
{
    Part part;
    part.stock = StockId{1};
    part.outline.outer = polygonContour(outline);
    part.outline.region.outer = outline;
    return part;
}

Polygon starOf(int points, double radius)
{
    Polygon star;
    for (int i = 0; i < 2 * points; ++i) {
        const double r = i % 2 == 0 ? radius : 0.5 * radius;
        const double angle = radians(180.0 * i / points);
        star.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    return star;
}

/// The first part lies in the lower left, the second in the middle of a sheet of 300 by 200.
struct Table
{
    std::vector<Part> parts;
    Layout layout;
    LayoutOptions options; // margin 5, spacing 2

    explicit Table(const Polygon &outline)
    {
        parts = {partOf(outline), partOf(outline)};
        Sheet sheet{StockId{1}, {300.0, 200.0}, {}, 0};
        sheet.placements = {{0, Vec2::UnitX(), {40.0, 40.0}}, {1, Vec2::UnitX(), {150.0, 100.0}}};
        layout.sheets = {sheet, sheet};
        layout.sheets[1].placements.clear();
        layout.sheets[1].index = 1;
        Sheet other = layout.sheets[1];
        other.stock = StockId{2};
        layout.sheets.push_back(other);
    }
    HandPlacing hand() const { return {parts, layout, options, 0}; }
};

const Polygon kSquare = rectangle(-20, -20, 20, 20);

} // namespace

class TestHandPlacing : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatIsFreeIsSound_data();
    void whatIsFreeIsSound();
    void squaresSnap_data();
    void squaresSnap();
    void whatSnapsIsSound();
    void turnsKeepTheMiddle();
    void quarterTurnsAreExact();
};

void TestHandPlacing::whatIsFreeIsSound_data()
{
    QTest::addColumn<int>("sheet");
    QTest::addColumn<Vec2>("offset");
    QTest::addColumn<bool>("isSound");
    QTest::newRow("where it lies") << 0 << Vec2(40, 40) << true;
    QTest::newRow("on another sheet") << 1 << Vec2(150, 100) << true;
    QTest::newRow("in the corner") << 0 << Vec2(25, 25) << true;
    QTest::newRow("in the margin") << 0 << Vec2(24.9, 25) << false;
    QTest::newRow("off the sheet") << 0 << Vec2(-100, 25) << false;
    QTest::newRow("on the other one") << 0 << Vec2(150, 100) << false;
    QTest::newRow("half on it") << 0 << Vec2(120, 80) << false;
    QTest::newRow("at the spacing") << 0 << Vec2(108, 100) << true;
    QTest::newRow("nearer than the spacing") << 0 << Vec2(108.1, 100) << false;
    QTest::newRow("on a sheet of another stock") << 2 << Vec2(150, 100) << false;
    QTest::newRow("on no sheet") << 3 << Vec2(150, 100) << false;
    QTest::newRow("before the first") << -1 << Vec2(150, 100) << false;
    QTest::newRow("nowhere") << 0 << Vec2(std::nan(""), 100) << false;
}

void TestHandPlacing::whatIsFreeIsSound()
{
    QFETCH(int, sheet);
    QFETCH(Vec2, offset);
    QFETCH(bool, isSound);
    const Table table(kSquare);
    QCOMPARE(table.hand().isSound({sheet, Vec2::UnitX(), offset}), isSound);
}

void TestHandPlacing::squaresSnap_data()
{
    QTest::addColumn<Vec2>("offset");
    QTest::addColumn<Vec2>("snapped");
    QTest::newRow("away from all") << Vec2(80, 60) << Vec2(80, 60);
    QTest::newRow("to the edge") << Vec2(28, 60) << Vec2(25, 60);
    QTest::newRow("from the margin") << Vec2(21, 60) << Vec2(25, 60);
    QTest::newRow("into the corner") << Vec2(277, 178) << Vec2(275, 175);
    QTest::newRow("beside the other one") << Vec2(104, 96) << Vec2(108, 96);
    QTest::newRow("off the other one") << Vec2(111, 96) << Vec2(108, 96);
    QTest::newRow("above the other one") << Vec2(144, 145) << Vec2(144, 142);
    QTest::newRow("too deep in it") << Vec2(130, 96) << Vec2(130, 96);
}

void TestHandPlacing::squaresSnap()
{
    QFETCH(Vec2, offset);
    QFETCH(Vec2, snapped);
    const Table table(kSquare);
    const HandPlace place = table.hand().snapped({0, Vec2::UnitX(), offset}, 5.0);
    QVERIFY2((place.offset - snapped).norm() <= kNear,
             qPrintable(QStringLiteral("%1 %2").arg(place.offset.x()).arg(place.offset.y())));
}

// Wherever it is let go: it goes no farther than the reach along each axis, and what was moved is
// sound.
void TestHandPlacing::whatSnapsIsSound()
{
    const Table table(starOf(7, 30.0));
    const HandPlacing hand = table.hand();
    std::mt19937 random(5);
    std::uniform_real_distribution<double> x(0.0, 300.0), y(0.0, 200.0), angle(0.0, 7.0);
    int moved = 0;
    for (int i = 0; i < 300; ++i) {
        const double turn = angle(random);
        const HandPlace wished{0, {std::cos(turn), std::sin(turn)}, {x(random), y(random)}};
        const HandPlace place = hand.snapped(wished, 6.0);
        QCOMPARE(place.turn, wished.turn);
        if (place == wished)
            continue;
        ++moved;
        QVERIFY(hand.isSound(place));
        QVERIFY((place.offset - wished.offset).cwiseAbs().maxCoeff() <= 18.0);
    }
    QVERIFY(moved > 20);
}

void TestHandPlacing::turnsKeepTheMiddle()
{
    const Part part = partOf(rectangle(10, 0, 90, 20));
    const HandPlace place{0, Vec2::UnitX(), {30, 40}};
    for (const double angle : {15.0, 90.0, 133.0, 270.0}) {
        const HandPlace next =
            turnedInPlace(part, place, {std::cos(radians(angle)), std::sin(radians(angle))});
        const Box2 box = turnedBounds(part.outline.region.outer, next.turn);
        const Vec2 middle = 0.5 * (box.min + box.max) + next.offset;
        QVERIFY((middle - Vec2(80, 50)).norm() < 1e-9);
        QVERIFY(std::abs(next.turn.norm() - 1.0) < 1e-15);
    }
}

void TestHandPlacing::quarterTurnsAreExact()
{
    const Part part = partOf(kSquare);
    HandPlace place{0, Vec2::UnitX(), {30, 40}};
    for (int i = 0; i < 4; ++i)
        place = turnedInPlace(part, place, Vec2::UnitY());
    QCOMPARE(place.turn, Vec2(Vec2::UnitX()));
    QCOMPARE(place.offset, Vec2(30, 40));
}

FFF_TEST(TestHandPlacing)
#include "tst_hand_placing.moc"
