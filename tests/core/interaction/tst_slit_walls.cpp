// A slit that is pressed near an edge and leaves almost along it: it says so before the release,
// and one key moves it in.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/analysis.h"
#include "core/interaction/offer_words.h"
#include "tests/core/analysed.h"
#include "tests/core/interaction/desk.h"
#include "tests/test_program.h"

#include <cmath>

using namespace fff;
using namespace fff::test;

namespace {

/// What is said where the slit leaves; empty: nothing.
Text doubt(const Desk &desk)
{
    for (const Sign &sign : desk.interaction.overlay().drawn)
        if (const auto *label = std::get_if<sign::Label>(&sign))
            if (label->role == SignRole::Doubt)
                return std::get<Message>(label->words).text;
    return {};
}

/// Out of a plate of 200 x 120 mm to the right, so far from its upper edge, mm; until the view has
/// turned.
void leave(Desk &desk, double beside)
{
    desk.addPlate();
    desk.run("view.front");
    desk.wait(1000.0);
    const Vec2 from = desk.plate(40.0, 60.0 - beside), to = desk.plate(106.0, 60.0 - beside);
    desk.moveTo(from);
    desk.press(from);
    desk.moveTo(to);
    desk.wait(kTurnTime + 100.0);
}

void drawRound(Desk &desk)
{
    const Vec2 from = desk.cursor;
    for (const Vec2 &by : {Vec2(60, 60), Vec2(160, 90), Vec2(160, -90), Vec2(-140, -90),
                           Vec2(-140, 80), Vec2(-20, 60)})
        desk.moveTo(from + by);
}

std::optional<LooseSlit> looseOf(const Desk &desk)
{
    const Analysis analysis = analysed(desk.session.committed());
    return analysis.grips.of(*analysis.assembly.joints.begin()).loose;
}

} // namespace

class TestSlitWalls : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void saysSoBeforeItLeaves();
    void saysNothingOfAGoodSlit();
    void keyMovesItInWhileItIsDrawn();
    void isOfferedAfterwards();
    void whatWouldSawItThroughIsNotMovedIn();
    void nowhereToMoveIt();
    void verdictIsThatOfTheChecks_data();
    void verdictIsThatOfTheChecks();
};

void TestSlitWalls::saysSoBeforeItLeaves()
{
    Desk desk;
    desk.addPlate();
    desk.run("view.front");
    desk.wait(1000.0);
    desk.press(desk.plate(40.0, 59.0));
    desk.moveTo(desk.plate(90.0, 59.0));
    QCOMPARE(doubt(desk), hints::kOneWall);
    QVERIFY(!desk.interaction.hasOffer());
    desk.moveTo(desk.plate(60.0, 20.0)); // the hand turned away from it
    QVERIFY(doubt(desk) == Text());
    desk.moveTo(desk.plate(90.0, 59.0));
    desk.moveTo(desk.plate(106.0, 59.0));
    QCOMPARE(doubt(desk), hints::kOneWallOffer);
    QVERIFY(desk.interaction.hasOffer() && desk.commands.isEnabled("section.takeOffer"));
}

void TestSlitWalls::saysNothingOfAGoodSlit()
{
    Desk desk;
    leave(desk, 20.0);
    QVERIFY(doubt(desk) == Text() && !desk.interaction.hasOffer());
}

void TestSlitWalls::keyMovesItInWhileItIsDrawn()
{
    Desk desk;
    leave(desk, 1.0);
    QCOMPARE(doubt(desk), hints::kOneWallOffer);
    desk.run("section.takeOffer");
    QVERIFY(desk.interaction.hasGesture());
    QVERIFY(doubt(desk) == Text() && desk.interaction.hasOffer()); // to put it back
    desk.run("section.takeOffer");
    QCOMPARE(doubt(desk), hints::kOneWallOffer);
    desk.run("section.takeOffer");
    drawRound(desk);
    desk.release(desk.cursor);
    QCOMPARE(desk.sections().size(), std::size_t(2));
    QVERIFY(!looseOf(desk));
    const Section &made = *desk.sections()[1];
    // In the slit's direction it is where it was drawn, beside it as far in as walls want.
    QVERIFY(made.parent->slitFrom.y() < 60.0 - 1.5 - 3.0 && made.parent->slitFrom.y() > 40.0);
    QVERIFY(std::abs(made.parent->slitFrom.x() - 40.0) < 0.5);
    QVERIFY(std::abs(made.parent->slitTo.x() - 100.0) < 1e-6);
    QVERIFY(std::abs(made.frame.height(desk.sections()[0]->frame.toWorld(made.parent->slitFrom))) <
            1e-9);
}

void TestSlitWalls::isOfferedAfterwards()
{
    Desk desk;
    leave(desk, 1.0);
    drawRound(desk);
    desk.release(desk.cursor);
    QCOMPARE(desk.sections().size(), std::size_t(2));
    QVERIFY(looseOf(desk) && looseOf(desk)->why == NoGrip::OneWall);
    QVERIFY(desk.interaction.hasOffer());
    const int steps = desk.steps();
    const Document before = desk.session.committed().document;
    desk.run("section.takeOffer");
    QCOMPARE(desk.steps(), steps + 1);
    QCOMPARE(desk.sections().size(), std::size_t(2));
    QVERIFY(!looseOf(desk) && !desk.interaction.hasOffer());
    desk.run("edit.undo");
    QVERIFY(desk.session.committed().document == before);
}

// Wrong: a stroke along the edge, moved in, saws the section in two without a word.
void TestSlitWalls::whatWouldSawItThroughIsNotMovedIn()
{
    for (const bool isTaken : {false, true}) {
        Desk desk;
        desk.addPlate();
        desk.run("view.front");
        desk.wait(1000.0);
        const Vec2 from = desk.plate(88.0, 59.0), to = desk.plate(106.0, 59.0);
        desk.moveTo(from);
        desk.press(from);
        desk.moveTo(to);
        desk.wait(kTurnTime + 100.0);
        QCOMPARE(doubt(desk), hints::kOneWallOffer);
        if (isTaken)
            desk.run("section.takeOffer");
        // A plate that goes along all of the edge.
        const Frame canvas = desk.interaction.overlay().find<sign::Capsule>()->canvas;
        const auto on = [&](double x, double y) { return desk.screen(canvas.toWorld(Vec2(x, y))); };
        for (const Vec2 &p :
             {on(30, 10), on(30, 40), on(-180, 40), on(-180, -40), on(30, -40), on(30, -5)})
            desk.moveTo(p);
        desk.release(desk.cursor);
        QCOMPARE(desk.sections().size(), std::size_t(2));
        QVERIFY(!desk.interaction.hasOffer());
        const Section &made = *desk.sections()[1];
        QVERIFY2(std::abs(made.parent->slitTo.y() - 59.0) < 1.0,
                 qPrintable(QString::number(made.parent->slitTo.y())));
        if (isTaken)
            QCOMPARE(desk.hint(), hints::kNotMovedIn);
    }
}

/// A strip that is no wider than slit and walls: it is said, nothing is promised.
void TestSlitWalls::nowhereToMoveIt()
{
    Desk desk;
    desk.addPlate(0.0, {100, 2.5});
    desk.run("view.front");
    desk.wait(1000.0);
    desk.press(desk.plate(40.0, 1.5));
    desk.moveTo(desk.plate(106.0, 1.5));
    QCOMPARE(doubt(desk), hints::kOneWall);
    QVERIFY(!desk.interaction.hasOffer());
}

void TestSlitWalls::verdictIsThatOfTheChecks_data()
{
    QTest::addColumn<double>("beside");
    for (const double beside : {0.3, 0.8, 1.3, 1.5, 1.6, 1.8, 2.5, 4.0, 8.0})
        QTest::newRow(qPrintable(QString::number(beside))) << beside;
}

/// What is said before there is a section is what the checks find once there is.
void TestSlitWalls::verdictIsThatOfTheChecks()
{
    QFETCH(double, beside);
    Desk desk;
    leave(desk, beside);
    const bool isDoubted = !(doubt(desk) == Text());
    drawRound(desk);
    desk.release(desk.cursor);
    QCOMPARE(desk.sections().size(), std::size_t(2));
    QCOMPARE(looseOf(desk) && looseOf(desk)->why == NoGrip::OneWall, isDoubted);
    QCOMPARE(isDoubted, beside < 1.55);
}

FFF_TEST(TestSlitWalls)
#include "tst_slit_walls.moc"
