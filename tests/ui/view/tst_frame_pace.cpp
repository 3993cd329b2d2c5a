#include <QTest> // first: moc cannot read some of the standard library before it

#include "tests/test_program.h"
#include "ui/view/frame_pace.h"

using namespace fff::ui;

namespace {

/// A machine that takes so long for each quality, and its clock.
struct Machine
{
    double full = 5.0, plain = 5.0, coarse = 5.0; // ms
    double now = 1000.0;
    FramePace pace = {};

    FrameQuality frame(bool moves)
    {
        const FrameQuality quality = pace.begin(now, moves);
        now += quality == FrameQuality::Full    ? full
               : quality == FrameQuality::Plain ? plain
                                                : coarse;
        pace.end(now);
        return quality;
    }
};

} // namespace

class TestFramePace : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aFastMachineAlwaysDrawsInFull();
    void aSlowMachineDrawsLessWhileMoving();
    void theFullPictureFollowsAfterARest();
    void whatDoesNotMoveStaysInFull();
    void aFasterSceneGetsBetterAgain();
};

void TestFramePace::aFastMachineAlwaysDrawsInFull()
{
    Machine machine;
    for (int i = 0; i < 50; ++i)
        QCOMPARE(machine.frame(true), FrameQuality::Full);
    QVERIFY(!machine.pace.restTime());
}

void TestFramePace::aSlowMachineDrawsLessWhileMoving()
{
    Machine machine{200.0, 80.0, 40.0};
    QCOMPARE(machine.frame(true), FrameQuality::Full); // nobody could know
    QCOMPARE(machine.frame(true), FrameQuality::Plain);
    QCOMPARE(machine.frame(true), FrameQuality::Coarse);
    QCOMPARE(machine.frame(true), FrameQuality::Coarse);
    Machine enough{200.0, 20.0, 10.0};
    enough.frame(true);
    for (int i = 0; i < 20; ++i)
        QCOMPARE(enough.frame(true), FrameQuality::Plain); // no flicker between two of them
}

void TestFramePace::theFullPictureFollowsAfterARest()
{
    Machine machine{200.0, 20.0, 10.0};
    machine.frame(true);
    machine.frame(true);
    const double moved = machine.now - 20.0;
    QCOMPARE(*machine.pace.restTime(), moved + FramePace::kRest);
    machine.now = moved + 100.0;
    QCOMPARE(machine.frame(false), FrameQuality::Plain); // hovering does not make it slow
    machine.now = moved + FramePace::kRest;
    QCOMPARE(machine.frame(false), FrameQuality::Full);
    QVERIFY(!machine.pace.restTime());
    QCOMPARE(machine.frame(true), FrameQuality::Plain);
}

void TestFramePace::whatDoesNotMoveStaysInFull()
{
    Machine machine{200.0, 20.0, 10.0};
    for (int i = 0; i < 5; ++i)
        QCOMPARE(machine.frame(false), FrameQuality::Full);
}

void TestFramePace::aFasterSceneGetsBetterAgain()
{
    Machine machine{200.0, 60.0, 40.0};
    for (int i = 0; i < 3; ++i)
        machine.frame(true);
    machine.full = machine.plain = machine.coarse = 2.0; // most of the model was hidden
    machine.frame(true);
    machine.frame(true);
    QCOMPARE(machine.frame(true), FrameQuality::Full);
}

FFF_TEST(TestFramePace)
#include "tst_frame_pace.moc"
