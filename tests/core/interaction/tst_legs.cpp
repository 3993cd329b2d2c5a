// A leg is drawn where it is seen: from the edge that the slit left by outwards. It is held all the
// same.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/analysis.h"
#include "core/interaction/stroke_words.h"
#include "tests/core/analysed.h"
#include "tests/core/interaction/desk.h"
#include "tests/test_program.h"

#include <random>

using namespace fff;
using namespace fff::test;

namespace {

/// Out of a plate of 200 x 120 mm over this point of its edge, 15 mm long; until the view has
/// turned.
void leave(Desk &desk, const Vec2 &edge, const Vec2 &way)
{
    desk.addPlate();
    desk.run("view.front");
    desk.wait(1000.0);
    const Vec2 from = edge - 15.0 * way, to = edge + 3.0 * way;
    desk.moveTo(desk.plate(from.x(), from.y()));
    desk.press(desk.cursor);
    desk.moveTo(desk.plate(to.x(), to.y()));
    desk.wait(kTurnTime + 100.0);
}

/// From where the hand is by these ways of the screen, with a tremor of 1.5 px.
void draw(Desk &desk, const std::vector<Vec2> &by, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> tremor(-1.5, 1.5);
    const Vec2 start = desk.cursor;
    Vec2 before = Vec2::Zero();
    for (const Vec2 &next : by) {
        for (int i = 1; i <= 12; ++i) {
            const Vec2 at = before + (next - before) * (i / 12.0);
            desk.send(PointerEvent::Type::Move, start + at + Vec2(tremor(random), tremor(random)));
        }
        before = next;
    }
    desk.release(desk.cursor);
}

} // namespace

class TestLegs : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aLegIsHeld_data();
    void aLegIsHeld();
    void whatIsDrawnOverItsSlitStays();
    void ctrlLeavesItFree();
    void aCircleThatIsTakenIsHeld();
    void halfWingsAreMirrored();
    void whatIsFarBesideIsSaidBeforeTheRelease();
};

void TestLegs::aLegIsHeld_data()
{
    QTest::addColumn<QPointF>("edge");
    QTest::addColumn<QPointF>("way");
    QTest::addColumn<bool>("isMirrored");
    QTest::addColumn<QList<QPointF>>("by");
    // Ways on the screen, where the slit leads down.
    const QList<QPointF> spread{{60, 60}, {90, 190}, {40, 195}, {5, 90}};
    const QList<QPointF> straight{{30, 20}, {35, 160}, {-30, 165}, {-32, 25}};
    const QList<QPointF> aside{{80, 20}, {85, 160}, {30, 165}, {25, 25}};
    const QPointF down(0, -1), right(1, 0);
    QTest::newRow("spread legs") << QPointF(-40, -60) << down << true << spread;
    QTest::newRow("one leg") << QPointF(-40, -60) << down << false << straight;
    QTest::newRow("a leg beside") << QPointF(30, -60) << down << false << aside;
    QTest::newRow("near a corner") << QPointF(-85, -60) << down << true << spread;
    QTest::newRow("upwards") << QPointF(20, 60) << QPointF(0, 1) << false
                             << QList<QPointF>{{30, -20}, {35, -120}, {-30, -125}, {-32, -25}};
    QTest::newRow("a tail") << QPointF(100, 10) << right << false
                            << QList<QPointF>{{20, 40}, {150, 60}, {160, -60}, {25, -40}};
}

void TestLegs::aLegIsHeld()
{
    QFETCH(const QPointF, edge);
    QFETCH(const QPointF, way);
    QFETCH(const bool, isMirrored);
    QFETCH(const QList<QPointF>, by);
    Desk desk;
    if (!isMirrored)
        desk.run("section.symmetry");
    leave(desk, {edge.x(), edge.y()}, {way.x(), way.y()});
    std::vector<Vec2> ways;
    for (const QPointF &one : by)
        ways.emplace_back(one.x(), one.y());
    draw(desk, ways, 7);
    QCOMPARE(desk.sections().size(), std::size_t(2));
    const Analysis analysis = analysed(desk.session.committed());
    QCOMPARE(analysis.assembly.joints.size(), std::size_t(1));
    QVERIFY(!analysis.grips.of(*analysis.assembly.joints.begin()).loose);
    QVERIFY(desk.hint() == hints::kHasNeck || desk.hint() == hints::kHasNeckAndIsCut);
    QCOMPARE(desk.sections()[1]->symmetry.has_value(), isMirrored);
    desk.run("edit.undo");
    QCOMPARE(desk.sections().size(), std::size_t(1));
}

void TestLegs::whatIsDrawnOverItsSlitStays()
{
    Desk desk;
    leave(desk, {-40, -60}, {0, -1});
    draw(desk, {{70, -20}, {60, -110}, {-60, -115}, {-70, 60}, {-10, 70}}, 3);
    QCOMPARE(desk.sections().size(), std::size_t(2));
    QVERIFY(!(desk.hint() == hints::kHasNeck));
}

void TestLegs::ctrlLeavesItFree()
{
    Desk desk;
    leave(desk, {100, 10}, {1, 0});
    const Vec2 start = desk.cursor;
    for (const Vec2 &by : {Vec2(20, 40), Vec2(150, 60), Vec2(160, -60), Vec2(25, -40)})
        desk.moveTo(start + by);
    const auto width = [&] {
        return desk.session.model().document.sections.back()->shape->bounds().size().maxCoeff();
    };
    const double withNeck = width();
    desk.moveTo(desk.cursor + Vec2(1, 0), {.control = true});
    QVERIFY(width() < withNeck - 20.0);
    desk.moveTo(desk.cursor - Vec2(1, 0));
    QVERIFY(std::abs(width() - withNeck) < 0.5);
    desk.release(desk.cursor, Button::Left, {.control = true});
    QCOMPARE(desk.sections().size(), std::size_t(2));
    QVERIFY(width() < withNeck - 20.0);
    QVERIFY(analysed(desk.session.committed()).assembly.joints.empty());
    QVERIFY(!(desk.hint() == hints::kHasNeck));
}

void TestLegs::aCircleThatIsTakenIsHeld()
{
    Desk desk;
    leave(desk, {100, 10}, {1, 0});
    std::vector<Vec2> by;
    for (int i = 1; i < 60; ++i) {
        const double angle = radians(180.0 - 6.0 * i);
        by.push_back(Vec2(100, 0) + 90.0 * Vec2(std::cos(angle), std::sin(angle)));
    }
    draw(desk, by, 5);
    QVERIFY(desk.interaction.hasOffer());
    const auto isHeld = [&] {
        const Analysis analysis = analysed(desk.session.committed());
        return analysis.assembly.joints.size() == 1 &&
               !analysis.grips.of(*analysis.assembly.joints.begin()).loose;
    };
    QVERIFY(isHeld());
    desk.interaction.takeOffer(desk.time);
    QCOMPARE(desk.session.history()->count(), 3);
    QVERIFY(isHeld());
}

// Wrong: who draws one half of a wide pair, from the slit out and back to it, has one arm.
void TestLegs::halfWingsAreMirrored()
{
    const std::vector<Vec2> down{{29, 20}, {209, -10}, {359, 20}, {359, 90}, {159, 70}, {0, 65}};
    const std::vector<Vec2> out{{29, 0}, {209, -30}, {359, 0}, {359, 70}, {159, 50}, {0, 45}};
    for (const std::vector<Vec2> &way : {down, out})
        for (const unsigned seed : {1u, 2u, 3u, 4u, 5u, 6u}) {
            Desk desk;
            leave(desk, {0, -60}, {0, -1});
            draw(desk, way, seed);
            QCOMPARE(desk.sections().size(), std::size_t(2));
            QVERIFY2(desk.sections()[1]->symmetry, qPrintable(QString::number(seed)));
        }
}

// Wrong: a leg that nothing will join looks like any other until it is there.
void TestLegs::whatIsFarBesideIsSaidBeforeTheRelease()
{
    Desk desk;
    desk.run("section.symmetry");
    leave(desk, {100, 10}, {1, 0});
    const auto isCued = [](const Desk &at) {
        const auto *label = at.interaction.overlay().drawn.find<sign::Label>();
        const auto *words = label ? std::get_if<Message>(&label->words) : nullptr;
        return words && words->text == hints::kNotJoinedYet;
    };
    const Vec2 start = desk.cursor;
    // Back to where it came to after its way there, which is no part of it.
    for (const Vec2 &by :
         {Vec2(40, 95), Vec2(40, 395), Vec2(340, 395), Vec2(340, 95), Vec2(45, 97)})
        desk.moveTo(start + by, {}, 40);
    QVERIFY(isCued(desk));
    desk.release(desk.cursor);
    QCOMPARE(desk.sections().size(), std::size_t(2));
    QCOMPARE(desk.hint(), hints::kNotJoined);
    QVERIFY(analysed(desk.session.committed()).assembly.joints.empty());

    Desk near;
    leave(near, {100, 10}, {1, 0});
    for (const Vec2 &by : {Vec2(20, 40), Vec2(150, 60), Vec2(160, -60), Vec2(25, -40)})
        near.moveTo(near.cursor + 0.5 * by);
    QVERIFY(!isCued(near));
}

FFF_TEST(TestLegs)
#include "tst_legs.moc"
