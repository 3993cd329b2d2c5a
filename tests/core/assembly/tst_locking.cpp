#include "core/assembly/assembly.h"
#include "core/assembly/locking.h"
#include "core/assembly/nonnegative_fit.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"

#include <QTest>

#include <Eigen/Geometry>

#include <cmath>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

constexpr int kRest = RigidContact::kAtRest;

/// A cube of 2 mm about the origin, pressed by a point on each side of its faces' middles so that
/// no turn is left: two a face, along one of its edges.
std::vector<RigidContact> boxedIn(int thing, int other, double gap = 0.0)
{
    std::vector<RigidContact> contacts;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {1.0, -1.0})
            for (const double along : {1.0, -1.0}) {
                Contact contact;
                contact.at[axis] = side;
                contact.at[(axis + 1) % 3] = along;
                contact.normal = Vec3::Zero();
                contact.normal[axis] = -side;
                contact.gap = gap;
                contacts.push_back({thing, other, contact});
            }
    return contacts;
}

std::vector<RigidContact> both(std::vector<RigidContact> a, const std::vector<RigidContact> &b)
{
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// Of each thing whether any of its numbers can change by more than the limit.
std::vector<char> movable(const std::vector<RigidContact> &contacts, int things,
                          const Looseness &looseness)
{
    const std::vector<Pivot> pivots = pivotsOf(contacts, things);
    const Locking locking(contacts, pivots);
    std::vector<char> movable(pivots.size(), 0);
    for (Eigen::Index number = 0; number < 6 * things; ++number)
        for (const double way : {1.0, -1.0})
            if (locking.motionAlong(number, way, looseness))
                movable[static_cast<std::size_t>(number / 6)] = 1;
    return movable;
}

Bodies bodiesOf(const Model &model)
{
    CutCache cache;
    const Assembly assembly = assemble(model);
    std::vector<CutSectionPointer> cuts;
    for (std::size_t i = 0; i < model.sectionCount(); ++i)
        cuts.push_back(cutSection(model.section(i)->shape, assembly.slits[i], cache));
    return fff::bodiesOf(model, cuts);
}

} // namespace

class TestLocking : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void distancesFromACone();
    void whatIsBoxedInIsHeld();
    void everyContactThatIsNeededIsNeeded();
    void gapsAreWays();
    void nearestMotionKeepsGaps();
    void whatIsTooDeepIsTakenOut();
    void whatPressesOnlyEachOtherIsFree();
    void oneHoldsTheOther();
    void turnedIsTheSame();
    void platesInEachOthersSlits();
};

// Wrong: a sum that takes a column less than zero times, or one that could be nearer.
void TestLocking::distancesFromACone()
{
    std::mt19937 random(5);
    const auto number = [&] { return static_cast<double>(random()) / 2147483647.5 - 1.0; };
    for (int round = 0; round < 200; ++round) {
        // In the plane the nearest point lies on a column, or the target is between two.
        Eigen::MatrixXd columns(2, 4);
        for (Eigen::Index i = 0; i < columns.size(); ++i)
            columns(i) = number();
        const Eigen::VectorXd target = Eigen::Vector2d(number(), number());
        double wanted = target.norm();
        for (Eigen::Index i = 0; i < 4; ++i) {
            const Eigen::VectorXd one = columns.col(i);
            const double times = std::max(0.0, one.dot(target) / one.squaredNorm());
            wanted = std::min(wanted, (target - times * one).norm());
            for (Eigen::Index k = 0; k < i; ++k) {
                Eigen::Matrix2d two;
                two << columns.col(i), columns.col(k);
                const Eigen::Vector2d share = two.inverse() * Eigen::Vector2d(target);
                if (share.minCoeff() >= 0.0)
                    wanted = 0.0;
            }
        }
        QVERIFY(std::abs(distanceFromCone(columns, target) - wanted) < 1e-9);
    }
}

void TestLocking::whatIsBoxedInIsHeld()
{
    QCOMPARE(movable(boxedIn(0, kRest), 1, {}), std::vector<char>{0});
    QCOMPARE(movable({}, 2, {}), (std::vector<char>{1, 1}));
}

// Seven points hold a rigid thing and no six do.
void TestLocking::everyContactThatIsNeededIsNeeded()
{
    std::vector<RigidContact> contacts = boxedIn(0, kRest);
    for (std::size_t i = 0; i < contacts.size();) {
        std::vector<RigidContact> fewer = contacts;
        fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
        if (movable(fewer, 1, {}).front())
            ++i;
        else
            contacts = std::move(fewer);
    }
    QVERIFY(contacts.size() >= 7);
    QVERIFY(!movable(contacts, 1, {}).front());
}

void TestLocking::gapsAreWays()
{
    // By shifts it comes as far as the gap; turned, its farthest contacts, √2 of its edges' half
    // away, come farther.
    for (const double gap : {0.1, 0.2, 0.3})
        for (const double limit : {0.05, 0.15, 0.25, 0.35, 0.5}) {
            const bool isFree = movable(boxedIn(0, kRest, gap), 1, {0.0, limit}).front() != 0;
            if (limit < gap)
                QVERIFY(isFree);
            if (limit > 2.0 * gap)
                QVERIFY(!isFree);
            QCOMPARE(movable(boxedIn(0, kRest), 1, {gap, limit}).front() != 0, isFree);
        }
}

// Wrong: a motion that goes into something, or one that could be nearer to what is wanted.
void TestLocking::nearestMotionKeepsGaps()
{
    std::mt19937 random(9);
    const auto number = [&] { return static_cast<double>(random()) / 2147483647.5 - 1.0; };
    const std::vector<RigidContact> all = boxedIn(0, kRest, 0.05);
    for (int round = 0; round < 100; ++round) {
        std::vector<RigidContact> contacts = all;
        contacts.resize(3 + random() % 10);
        const std::vector<Pivot> pivots{{Vec3::Zero(), 1.5}};
        const auto least = [&](const Motion &motion) {
            double gap = 1e9;
            for (const RigidContact &touch : contacts) {
                const Vec3 by = motion.head<3>() +
                                Vec3(motion.tail<3>()).cross(touch.contact.at) / pivots[0].radius;
                gap = std::min(gap, touch.contact.gap + touch.contact.normal.dot(by));
            }
            return gap;
        };
        Motion wanted(6);
        for (Eigen::Index i = 0; i < 6; ++i)
            wanted[i] = 0.2 * number();
        const std::optional<Motion> motion = Locking(contacts, pivots).nearestMotion(wanted);
        QVERIFY(motion && least(*motion) > -1e-6);
        if (least(wanted) > 0.0)
            QVERIFY((*motion - wanted).norm() < 1e-6);
        for (int other = 0; other < 50; ++other) {
            Motion near = *motion;
            for (Eigen::Index i = 0; i < 6; ++i)
                near[i] += 0.02 * number();
            if (least(near) >= 0.0)
                QVERIFY((near - wanted).norm() > (*motion - wanted).norm() - 1e-6);
        }
    }
}

void TestLocking::whatIsTooDeepIsTakenOut()
{
    Contact floor;
    floor.normal = Vec3::UnitY();
    floor.gap = -0.05;
    const std::vector<RigidContact> contacts{{0, kRest, floor, 0.02}};
    const std::vector<Pivot> pivots(1);
    const std::optional<Motion> motion = Locking(contacts, pivots).nearestMotion(Motion::Zero(6));
    QVERIFY(motion && (Vec3(motion->head<3>()) - Vec3(0, 0.03, 0)).norm() < 1e-9);
    // Nothing gives way on the other side.
    std::vector<RigidContact> both = contacts;
    both.push_back(both.front());
    both.back().contact.normal = -Vec3::UnitY();
    QVERIFY(!Locking(both, pivots).nearestMotion(Motion::Zero(6)));
}

// Wrong: what is caught by something that comes along is held.
void TestLocking::whatPressesOnlyEachOtherIsFree()
{
    QCOMPARE(movable(boxedIn(0, 1), 2, {}), (std::vector<char>{1, 1}));
    // Shut in, but for one side.
    std::vector<RigidContact> open = boxedIn(1, kRest);
    std::erase_if(open, [](const RigidContact &touch) { return touch.contact.normal.x() < 0.0; });
    QCOMPARE(movable(both(boxedIn(0, 1), open), 2, {}), (std::vector<char>{1, 1}));
}

void TestLocking::oneHoldsTheOther()
{
    QCOMPARE(movable(both(boxedIn(0, 1), boxedIn(1, kRest)), 2, {}), (std::vector<char>{0, 0}));
    // Which of two names comes first does not matter.
    std::vector<RigidContact> back = boxedIn(0, 1);
    for (RigidContact &touch : back) {
        std::swap(touch.thing, touch.other);
        touch.contact.normal = -touch.contact.normal;
    }
    QCOMPARE(movable(both(back, boxedIn(1, kRest)), 2, {}), (std::vector<char>{0, 0}));
    QCOMPARE(movable(both(boxedIn(0, kRest), boxedIn(2, 1)), 3, {}), (std::vector<char>{0, 1, 1}));
}

void TestLocking::turnedIsTheSame()
{
    const Eigen::Quaterniond turn = Eigen::Quaterniond(0.3, -0.5, 0.7, 0.2).normalized();
    for (const std::size_t left : {12U, 11U, 9U, 7U}) {
        std::vector<RigidContact> contacts = boxedIn(0, kRest, 0.01);
        contacts.resize(left);
        const std::vector<char> before = movable(contacts, 1, {});
        for (RigidContact &touch : contacts) {
            touch.contact.at = turn * touch.contact.at + Vec3(300, -40, 7);
            touch.contact.normal = turn * touch.contact.normal;
        }
        QCOMPARE(movable(contacts, 1, {}), before);
    }
}

// Wrong: a wall or a face that is not seen, or one whose normal points into its material.
void TestLocking::platesInEachOthersSlits()
{
    const Model model =
        twoSections(plateOf(-50, 0, 50, 50), front(), plateOf(-50, 0, 50, 50), side());
    const Bodies bodies = ::bodiesOf(model);
    QCOMPARE(bodies.size(), std::size_t(2));
    std::array<int, 6> ways{}; // how many push each way along x, y, z
    std::vector<RigidContact> contacts;
    const auto add = [&](int a, int b, double sign) {
        for (Contact contact : contactsOf(bodies.at(a), bodies.at(b), 0.3)) {
            contact.normal *= sign;
            QVERIFY(contact.gap <= 0.3 && std::abs(contact.normal.norm() - 1.0) < 1e-12);
            QVERIFY(std::abs(contact.at.x()) < 2.0 && std::abs(contact.at.z()) < 2.0);
            for (int axis = 0; axis < 3; ++axis)
                if (std::abs(contact.normal[axis]) > 0.5)
                    ++ways[static_cast<std::size_t>(2 * axis + (contact.normal[axis] > 0.0))];
            contacts.push_back({0, kRest, contact});
        }
    };
    add(0, 1, 1.0);
    add(1, 0, -1.0);
    // One of them rests in the other's slit: it may go up or down, not both.
    QVERIFY(ways[0] > 3 && ways[1] > 3 && ways[4] > 3 && ways[5] > 3);
    QVERIFY((ways[2] > 0) != (ways[3] > 0));
    QVERIFY(movable(contacts, 1, {}).front());
    // With a lid nothing is left.
    Contact lid;
    lid.at = {0, 25, 0};
    lid.normal = Vec3(0, ways[3] > 0 ? -1 : 1, 0);
    contacts.push_back({0, kRest, lid});
    QVERIFY(!movable(contacts, 1, {0.0, 0.5}).front());
}

FFF_TEST(TestLocking)
#include "tst_locking.moc"
