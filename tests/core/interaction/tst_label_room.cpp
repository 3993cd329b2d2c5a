#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/interaction/label_room.h"
#include "tests/test_program.h"

#include <cmath>
#include <random>

using namespace fff;

namespace {

const Vec2 kView(600.0, 400.0);

bool areApart(const Box2 &a, const Box2 &b)
{
    return a.max.x() <= b.min.x() || b.max.x() <= a.min.x() || a.max.y() <= b.min.y() ||
           b.max.y() <= a.min.y();
}

} // namespace

class TestLabelRoom : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Words on words, or half beyond the edge, can both not be read.
    void noneLieOnAnother()
    {
        std::mt19937 random(20260726); // NOLINT
        std::uniform_real_distribution<double> across(-50.0, 650.0), along(-50.0, 450.0),
            width(20.0, 160.0);
        for (int round = 0; round < 20; ++round) {
            LabelRoom room(kView);
            std::vector<Box2> placed;
            for (int i = 0; i < 30; ++i) {
                const Vec2 size(width(random), 22.0);
                const auto box = room.placeFor({across(random), along(random)}, size);
                if (!box)
                    continue;
                QVERIFY((box->size() - size).norm() < 1e-9);
                QVERIFY((box->min.array() >= 0.0).all() &&
                        (box->max.array() <= kView.array()).all());
                for (const Box2 &other : placed)
                    QVERIFY(areApart(*box, other));
                placed.push_back(*box);
                room.take(*box);
            }
            QVERIFY(placed.size() > 15);
        }
    }

    /// Words that go further than they must are looked for.
    void noFreePlaceIsNearer()
    {
        std::mt19937 random(7); // NOLINT
        std::uniform_real_distribution<double> across(0.0, 600.0), along(0.0, 400.0);
        for (int round = 0; round < 10; ++round) {
            LabelRoom room(kView);
            for (int i = 0; i < 12; ++i) {
                const Vec2 at(across(random), along(random));
                room.take({at - Vec2(45.0, 20.0), at + Vec2(45.0, 20.0)});
            }
            const Vec2 wanted(across(random), along(random)), size(70.0, 22.0);
            const auto box = room.placeFor(wanted, size);
            QVERIFY(box);
            // All places of a grid, of which a way aside counts more.
            const auto way = [&](const Vec2 &middle) {
                return std::hypot(1.6 * (middle.x() - wanted.x()), middle.y() - wanted.y());
            };
            double least = 1e9;
            for (double x = 0.0; x <= 600.0; x += 2.0)
                for (double y = 0.0; y <= 400.0; y += 2.0) {
                    const Box2 there{Vec2(x, y) - 0.5 * size, Vec2(x, y) + 0.5 * size};
                    if (room.isFree(there))
                        least = std::min(least, way({x, y}));
                }
            // What stays free between two boxes is the slack.
            QVERIFY(way(box->center()) <= least + 2.0 * 1.6 * LabelRoom::kApart + 1e-9);
        }
    }

    /// Whoever looks near by only finds what one finds who looks everywhere, if it is near.
    void lookingNearByFindsTheSame()
    {
        std::mt19937 random(31); // NOLINT
        std::uniform_real_distribution<double> across(0.0, 600.0), along(0.0, 400.0);
        int near = 0, far = 0;
        for (int round = 0; round < 200; ++round) {
            LabelRoom room(kView);
            for (int i = 0; i < 60; ++i) {
                const Vec2 at(across(random), along(random));
                room.take({at - Vec2(30.0, 14.0), at + Vec2(30.0, 14.0)});
            }
            const Vec2 wanted(across(random), along(random)), size(70.0, 22.0);
            constexpr double kReach = 50.0;
            const auto all = room.placeFor(wanted, size);
            const auto some = room.placeFor(wanted, size, kReach);
            const auto way = [&](const Box2 &box) {
                return std::hypot(1.6 * (box.center().x() - wanted.x()),
                                  box.center().y() - wanted.y());
            };
            // What stays free between two boxes is the slack.
            constexpr double kSlack = 2.0 * 1.6 * LabelRoom::kApart;
            if (all && way(*all) <= kReach - kSlack) {
                QVERIFY(some && room.isFree(*some) && way(*some) <= way(*all) + kSlack);
                ++near;
            } else if (some) { // outside the view one looks from its edge on
                ++far;
                QVERIFY(all);
            }
        }
        QVERIFY(near > 50);
        QVERIFY(far < 100);
    }

    void whereItIsFreeNothingMoves()
    {
        LabelRoom room(kView);
        room.take({{0.0, 0.0}, {100.0, 100.0}});
        const auto box = room.placeFor({300.0, 200.0}, {80.0, 22.0});
        QVERIFY(box && (box->center() - Vec2(300.0, 200.0)).norm() < 1e-9);
    }

    /// Under a full view nothing is written over something else.
    void aFullViewHasNoPlace()
    {
        LabelRoom room(kView);
        room.take({{0.0, 0.0}, kView});
        QVERIFY(!room.placeFor({300.0, 200.0}, {80.0, 22.0}));
        LabelRoom narrow({60.0, 400.0});
        QVERIFY(!narrow.placeFor({30.0, 200.0}, {80.0, 22.0}));
    }

    /// An oblique line would else take the view from corner to corner.
    void aLineTakesWhatIsBesideIt()
    {
        LabelRoom room(kView);
        room.takeLine({100.0, 100.0}, {400.0, 300.0}, 3.0);
        QVERIFY(!room.isFree({{240.0, 190.0}, {260.0, 210.0}}));
        QVERIFY(room.isFree({{120.0, 270.0}, {200.0, 290.0}}));
        QVERIFY(room.isFree({{330.0, 120.0}, {390.0, 140.0}}));
    }
};

FFF_TEST(TestLabelRoom)
#include "tst_label_room.moc"
