#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/assembly/playback.h"
#include "tests/test_program.h"

using namespace fff;

namespace {

Box3 cube(const Vec3 &middle, double half = 5.0)
{
    Box3 box;
    box.extend(Vec3(middle - Vec3::Constant(half)));
    box.extend(Vec3(middle + Vec3::Constant(half)));
    return box;
}

AssemblyPlan planOf(std::vector<AssemblyStep> steps)
{
    return {AssemblyPlan::Verdict::Possible, std::move(steps), {}};
}

/// 0 is put down, 1 comes straight down, 2 comes round a corner.
Playback straightAndBent()
{
    return Playback(planOf({{{0}, {}, {}},
                            {{1}, {0}, {{-Vec3::UnitY(), 20.0}}},
                            {{2}, {0, 1}, {{Vec3::UnitX(), 30.0}, {-Vec3::UnitZ(), 10.0}}}}),
                    {cube({0, 0, 0}), cube({0, 8, 0}), cube({8, 0, 0})});
}

/// 0 stands; 1 and 2 are put together, crosswise to the way on which they come as one.
Playback group()
{
    return Playback(planOf({{{0}, {}, {}},
                            {{1}, {}, {}},
                            {{2}, {1}, {{Vec3::UnitX(), 60.0}}},
                            {{1, 2}, {0}, {{-Vec3::UnitY(), 12.0}}}}),
                    {cube({-30, 0, 0}), cube({0, 5, 0}), cube({8, 5, 0})});
}

} // namespace

class tst_playback : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    /// Else the slider and the sentence beside it would speak of different steps.
    void timeIsCountedInSteps()
    {
        const Playback playback = straightAndBent();
        QCOMPARE(playback.stepAt(-1.0), -1);
        QCOMPARE(playback.stepAt(0.0), -1);
        QCOMPARE(playback.stepAt(0.01), 0);
        QCOMPARE(playback.stepAt(1.0), 0);
        QCOMPARE(playback.stepAt(1.01), 1);
        QCOMPARE(playback.stepAt(3.0), 2);
        QCOMPARE(playback.stepAt(99.0), 2);
        for (const PartPlace &place : playback.at(0.0))
            QVERIFY(!place.isThere);
    }

    /// Else what is played would not be what was planned.
    void distancesAreThePlans()
    {
        const Playback playback = straightAndBent();
        QVERIFY(!playback.lastDirection(0));
        QCOMPARE(playback.way(0).size(), std::size_t(1));
        QCOMPARE(playback.before(1)[1].offset, Vec3(0, 20, 0));
        QCOMPARE(playback.before(2)[2].offset, Vec3(-30, 0, 10));
        QCOMPARE(*playback.lastDirection(2), Vec3(-Vec3::UnitZ()));
        QCOMPARE(playback.at(3.0)[2].offset, Vec3(Vec3::Zero()));
    }

    /// A corner that is cut would take the part through others.
    void bentWaysGoRoundTheirCorner()
    {
        const Playback playback = straightAndBent();
        double reached = 0.0;
        for (int i = 1; i <= 200; ++i) {
            const Vec3 at = playback.at(2.0 + i / 200.0)[2].offset;
            const bool isOnFirst = std::abs(at.z() - 10.0) < 1e-9,
                       isOnLast = std::abs(at.x()) < 1e-9;
            QVERIFY(isOnFirst || isOnLast);
            QCOMPARE(at.y(), 0.0);
            const double gone = at.x() + 30.0 + 10.0 - at.z();
            QVERIFY(gone >= reached - 1e-9);
            reached = gone;
        }
        QCOMPARE(reached, 40.0);
    }

    /// Else what is under way could not be told from what stands.
    void onlyTheStepsOwnPartsMove()
    {
        const Playback playback = straightAndBent();
        const std::vector<PartPlace> during = playback.at(1.5), after = playback.at(2.0);
        QVERIFY(!during[0].isMoving && during[1].isMoving && !during[2].isMoving);
        QVERIFY(during[1].offset.y() > 0.0 && during[1].offset.y() < 20.0);
        QVERIFY(after[1].isMoving);
        QCOMPARE(after[1].offset, Vec3(Vec3::Zero()));
        QVERIFY(!during[2].isThere);
    }

    /// Else a part would go through those that stand there already.
    void groupsArePutTogetherAside()
    {
        const Playback playback = group();
        // 2 comes from (−60, 0, 0), which is where 0 stands: they are put together higher up.
        const Vec3 aside = playback.way(3).front();
        QCOMPARE(aside.x(), 0.0);
        QVERIFY(aside.y() > 12.0 - 1e-9);
        for (int i = 1; i <= 100; ++i) {
            const std::vector<PartPlace> places = playback.at(2.0 + i / 100.0);
            const Vec3 at = Vec3(8, 5, 0) + places[2].offset;
            QVERIFY2(at.y() - 5.0 >= 5.0 - 1e-9, "in what stands there");
            QCOMPARE(places[1].offset, aside);
        }
        QCOMPARE(playback.at(3.0)[2].offset, aside);
        QVERIFY(playback.at(3.5)[1].isMoving && playback.at(3.5)[2].isMoving);
        QCOMPARE(playback.at(3.5)[1].offset, playback.at(3.5)[2].offset);
        for (const PartPlace &place : playback.at(4.0))
            QCOMPARE(place.offset, Vec3(Vec3::Zero()));
    }

    /// A group that is torn apart would hide what belongs together.
    void drawnApartGroupsKeepTogether()
    {
        const Playback playback = group();
        const auto whole = playback.at(4.0, 1.0), half = playback.at(4.0, 0.5);
        const Vec3 inner = whole[2].offset - whole[1].offset;
        QVERIFY(inner.x() <= -60.0); // as 2 came to 1, and clear of it
        QCOMPARE(inner.y(), 0.0);
        QVERIFY(whole[1].offset.y() >= 12.0);
        QCOMPARE(whole[0].offset, Vec3(Vec3::Zero()));
        for (std::size_t i = 0; i < whole.size(); ++i)
            QVERIFY((half[i].offset - 0.5 * whole[i].offset).norm() < 1e-9);
    }

    /// Else the camera leaves out parts that wait aside, or those that are drawn apart.
    void allThatIsEverShownIsInReach()
    {
        const std::vector<std::pair<Playback, std::vector<Box3>>> all{
            {straightAndBent(), {cube({0, 0, 0}), cube({0, 8, 0}), cube({8, 0, 0})}},
            {group(), {cube({-30, 0, 0}), cube({0, 5, 0}), cube({8, 5, 0})}}};
        for (const auto &[playback, boxes] : all) {
            for (const double drawnApart : {0.0, 0.5, 1.0}) {
                Box3 seen;
                for (int i = 1; i <= 400 * playback.stepCount(); ++i) {
                    const auto places = playback.at(i / 400.0, drawnApart);
                    for (std::size_t p = 0; p < places.size(); ++p)
                        if (places[p].isThere) {
                            seen.extend(Vec3(boxes[p].min + places[p].offset));
                            seen.extend(Vec3(boxes[p].max + places[p].offset));
                        }
                }
                const Box3 reach = playback.reach(drawnApart);
                QVERIFY((reach.min - seen.min).norm() < 1e-9);
                QVERIFY((reach.max - seen.max).norm() < 1e-9);
            }
        }
    }

    /// Of a plan that is none nothing may be shown.
    void withoutAPlanNothingIsThere()
    {
        AssemblyPlan plan = planOf({{{0}, {}, {}}});
        plan.verdict = AssemblyPlan::Verdict::NotFound;
        const Playback playback(plan, {cube({0, 0, 0})});
        QCOMPARE(playback.stepCount(), 0);
        QVERIFY(!playback.at(1.0)[0].isThere);
        QVERIFY(playback.reach().isEmpty());
    }
};

FFF_TEST(tst_playback)
#include "tst_playback.moc"
