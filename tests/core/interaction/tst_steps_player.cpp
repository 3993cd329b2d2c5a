#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/interaction/steps_player.h"
#include "core/interaction/steps_tool.h"
#include "core/interaction/view_fit.h"
#include "core/session/session.h"
#include "core/session/session_host.h"
#include "tests/core/assembly/known_models.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;

namespace {

constexpr double kStep = StepsPlayer::kStepTime, kGo = StepsPlayer::kGoTime;

PointerEvent pointer(PointerEvent::Type type, const Vec2 &at, double time)
{
    PointerEvent event;
    event.type = type;
    event.button = Button::Left;
    event.position = at;
    event.time = time;
    return event;
}

} // namespace

class tst_steps_player : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    /// By the clock of the events alone: frames that come late change nothing.
    void playingGoesByTheClock()
    {
        StepsPlayer often(4), seldom(4);
        often.play(1000.0);
        seldom.play(1000.0);
        for (double now = 1000.0; now < 1000.0 + 2.5 * kStep; now += 7.0)
            often.advance(now);
        often.advance(1000.0 + 2.5 * kStep);
        seldom.advance(1000.0 + 2.5 * kStep);
        QCOMPARE(often.time(), 2.5);
        QCOMPARE(seldom.time(), 2.5);
        QVERIFY(often.isPlaying());
        often.advance(1000.0 + 9.0 * kStep);
        QCOMPARE(often.time(), 4.0);
        QVERIFY(!often.isMoving()); // else frames would be drawn for ever
        often.play(0.0);
        QCOMPARE(often.time(), 0.0); // from the beginning again
    }

    /// Each key is one step, also when it comes while the view is still on its way.
    void everyKeyIsOneStep()
    {
        StepsPlayer player(5);
        player.next(0.0);
        player.advance(0.5 * kGo);
        QCOMPARE(player.time(), 0.5);
        player.next(0.5 * kGo);
        player.advance(1.5 * kGo);
        QCOMPARE(player.time(), 2.0);
        QVERIFY(!player.isMoving());
        player.previous(2.0 * kGo);
        player.advance(3.0 * kGo);
        QCOMPARE(player.time(), 1.0);
        player.jumpTo(2.4);
        player.next(0.0);
        player.advance(kGo);
        QCOMPARE(player.time(), 3.0);
        player.jumpTo(2.4);
        player.previous(0.0);
        player.advance(kGo);
        QCOMPARE(player.time(), 2.0);
    }

    /// Before the first step and behind the last one nothing is.
    void itStaysWithinTheSteps()
    {
        StepsPlayer player(2);
        player.previous(0.0);
        player.advance(kGo);
        QCOMPARE(player.time(), 0.0);
        player.jumpTo(7.0);
        QCOMPARE(player.time(), 2.0);
        player.next(0.0);
        player.advance(kGo);
        QCOMPARE(player.time(), 2.0);
        StepsPlayer nothing(0);
        nothing.play(0.0);
        QVERIFY(!nothing.isMoving());
        QCOMPARE(nothing.time(), 0.0);
    }

    /// Whoever wants less motion sees whole steps only.
    void withoutMotionItJumps()
    {
        StepsPlayer player(3, true);
        player.next(0.0);
        QCOMPARE(player.time(), 1.0);
        QVERIFY(!player.isMoving());
        player.play(0.0);
        for (double now = 0.0; now < 3.0 * kStep; now += 11.0) {
            player.advance(now);
            QCOMPARE(player.time(), std::floor(player.time()));
        }
        QCOMPARE(player.time(), 3.0);
    }

    /// Backwards one sees the same places as forwards.
    void backwardsIsTheSameWay()
    {
        StepsPlayer forth(3), back(3);
        back.jumpTo(2.0);
        forth.jumpTo(1.0);
        forth.next(0.0);
        back.previous(0.0);
        for (double now = 0.0; now <= kGo; now += kGo / 16.0) {
            forth.advance(now);
            back.advance(kGo - now > 0.0 ? now : kGo);
            QVERIFY(std::abs((forth.time() - 1.0) - (2.0 - back.time())) < 1e-9);
        }
    }

    /// While the steps are shown nothing is drawn, chosen or changed, but the view is turned.
    void theViewIsTurnedAndNothingIsDrawn()
    {
        Session session;
        SessionHost host(session);
        Interaction interaction(host);
        host.attach(interaction);
        interaction.setViewport({800.0, 600.0});
        session.reset(combModel(2));
        Camera camera;
        orientationOfView("iso1", camera.orientation);
        interaction.setCamera(fitted(camera, session.committed().bounds(), {800.0, 600.0}));
        interaction.pickUp(std::make_unique<StepsTool>(std::make_shared<StepsPlayer>(3)), 0.0);
        const Document before = session.committed().document;
        const Camera seen = interaction.camera();

        // On a section and over its edge: without the tool it would be a stroke.
        double time = 100.0;
        interaction.handle(pointer(PointerEvent::Type::Press, {400.0, 300.0}, time));
        for (int i = 1; i <= 20; ++i)
            interaction.handle(pointer(PointerEvent::Type::Move, {400.0 + 8.0 * i, 300.0}, ++time));
        QVERIFY(!interaction.overlay().find<sign::Slit>() &&
                !interaction.overlay().find<sign::Stroke>());
        interaction.handle(pointer(PointerEvent::Type::Release, {560.0, 300.0}, ++time));
        QVERIFY(!(interaction.camera() == seen));
        QVERIFY(interaction.tool());
        interaction.goBack(++time, 0.0);
        QVERIFY(interaction.camera() == seen);

        // A click chooses nothing, not even with Ctrl.
        for (const bool control : {false, true}) {
            PointerEvent press = pointer(PointerEvent::Type::Press, {400.0, 300.0}, ++time);
            press.modifiers.control = control;
            interaction.handle(press);
            PointerEvent release = pointer(PointerEvent::Type::Release, {400.0, 300.0}, ++time);
            release.modifiers.control = control;
            interaction.handle(release);
            QVERIFY(interaction.selection().empty());
        }
        QVERIFY(session.committed().document.isSame(before));
        QCOMPARE(session.history()->count(), 0);
        QCOMPARE(interaction.hint().words.text, hints::kShowSteps);
        QVERIFY(interaction.escape(++time));
        QVERIFY(!interaction.tool());
    }

    /// Steps of another model are no use, and a person wants to know why they went.
    void anEditClosesTheSteps()
    {
        Session session;
        SessionHost host(session);
        Interaction interaction(host);
        host.attach(interaction);
        session.reset(combModel(2));
        interaction.pickUp(std::make_unique<StepsTool>(std::make_shared<StepsPlayer>(3)), 0.0);
        session.commit(QStringLiteral("Add"), combModel(3));
        QVERIFY(!interaction.tool());
        QCOMPARE(interaction.hint().words.text, hints::kStepsClosed);
    }
};

FFF_TEST(tst_steps_player)
#include "tests/told.h"
#include "tst_steps_player.moc"
