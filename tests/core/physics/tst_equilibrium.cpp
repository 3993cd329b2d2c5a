#include "core/physics/equilibrium.h"
#include "tests/core/physics/force_method.h"
#include "tests/core/physics/structures.h"
#include "tests/test_program.h"

#include <QTest>

using namespace fff;
using namespace fff::test;

namespace {

constexpr double kSame = 1e-8;        // share of the largest force
constexpr double kBalanced = 1e-9;    // share: what may be left over, and of the sum of reactions
constexpr double kSameAsDense = 1e-6; // share: the dense oracle is that exact

/// The largest difference from the force method, by its largest force.
double differenceFrom(const ForceMethod &oracle, const Structure &structure,
                      const Equilibrium &found)
{
    double most = 0.0, scale = oracle.feet.lpNorm<Eigen::Infinity>();
    for (std::size_t j = 0; j < structure.links.size(); ++j) {
        const Wrench &wrench = found.links[j].onA;
        const Vec3 force = oracle.wrenches.segment<3>(6 * j);
        const Vec3 moment = oracle.wrenches.segment<3>(6 * j + 3);
        most = std::max({most, (wrench.force - force).norm(),
                         (wrench.moment - moment).norm() / structure.size});
        scale = std::max({scale, force.norm(), moment.norm() / structure.size});
    }
    for (std::size_t k = 0; k < structure.feet.size(); ++k)
        most = std::max(most, std::abs(found.feet[k].force.dot(structure.up) - oracle.feet[k]));
    return most / scale;
}

/// Two members: `b` hangs in `a`, which stands on four feet, by a link whose slits let it out
/// downwards.
Structure hanging(double grip)
{
    Structure structure = block(fourFeet(), {0, 0}, 1.0);
    structure.members.push_back({0.2, {0, 10, 0}});
    structure.links.push_back(upright(0, 1, {0, 20, 0}, -Vec3::UnitY()));
    structure.links.back().grip = grip;
    return structure;
}

} // namespace

class TestEquilibrium : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tripodByHand();
    void bracketByHand();
    void agreesWithTheForceMethod();
    void agreesWithTheForceMethodWherePulledOpen();
    void feetPressOnly();
    void pinnedFeetHoldHorizontally();
    void aLinkThatHangsAsksForGrip();
    void anOpenedLinkShedsItsPull();
    void editedEqualsFromScratch();
    void envelope();
};

// Wrong: the forces of a determinate stand, or their places among the feet.
void TestEquilibrium::tripodByHand()
{
    const Structure stand = block({{0, 0}, {100, 0}, {0, 100}}, {20, 50}, 2.0);
    const Equilibrium found = solveEquilibrium(stand);
    QCOMPARE(found.balance(), Balance::Stands);
    QCOMPARE(found.indeterminacy(), 0);
    const double weight = 2.0 * 9.81;
    QVERIFY(std::abs(found.feet[0].force.y() - 0.3 * weight) < kBalanced * weight);
    QVERIFY(std::abs(found.feet[1].force.y() - 0.2 * weight) < kBalanced * weight);
    QVERIFY(std::abs(found.feet[2].force.y() - 0.5 * weight) < kBalanced * weight);
}

// Wrong: the sign of the wrench on a, or the point its moment is about.
void TestEquilibrium::bracketByHand()
{
    Structure stand = block(fourFeet(), {0, 0}, 1.0);
    stand.members.push_back({0.5, {30, 60, 0}}); // stands on the first, 10 beside the link
    stand.links.push_back(upright(1, 0, {20, 40, 0}, -Vec3::UnitY()));
    stand.loads.push_back({1, {20, 70, 5}, {0, -4, 0}, {0, 0, 7}});
    const Equilibrium found = solveEquilibrium(stand);
    QCOMPARE(found.balance(), Balance::Stands);
    const double weight = 0.5 * 9.81;
    const Vec3 force(0, weight + 4.0, 0);
    // About the link's point: −(10, 20, 0) × (0, −w, 0) − (0, 30, 5) × (0, −4, 0) − (0, 0, 7)
    const Vec3 moment(-20.0, 0, 10.0 * weight - 7.0);
    QVERIFY((found.links[0].onA.force - force).norm() < kBalanced * force.norm());
    QVERIFY((found.links[0].onA.moment - moment).norm() < kBalanced * 100.0 * force.norm());
    QVERIFY(std::abs(found.links[0].pull + force.y()) < kBalanced * force.norm()); // it bears
}

// Wrong: how forces are shared where statics leaves it open, or which feet lift.
void TestEquilibrium::agreesWithTheForceMethod()
{
    int standing = 0, lifted = 0;
    for (unsigned seed = 1; seed <= 60; ++seed) {
        StructureSource source(seed);
        const int members = 1 + source.upTo(3);
        Structure stand = source.stand(members, source.upTo(2), 3 + source.upTo(3), 2);
        if (seed % 3 == 0)
            stand.loads.push_back({0, {30, 20, 30}, {0, -60, 0}, Vec3::Zero()});
        const Equilibrium found = solveEquilibrium(stand);
        const std::optional<ForceMethod> oracle = forceMethod(stand);
        const std::string where = "seed " + std::to_string(seed);
        QVERIFY2(oracle.has_value() == (found.balance() == Balance::Stands), where.c_str());
        if (!oracle)
            continue;
        ++standing;
        const double off = differenceFrom(*oracle, stand, found);
        QVERIFY2(off < kSameAsDense, (where + ": " + std::to_string(off)).c_str());
        for (const FootForce &foot : found.feet)
            lifted += foot.isPressing ? 0 : 1;
        QVERIFY2(found.worstResidual < kBalanced, where.c_str());
    }
    QVERIFY(standing > 30);
    QVERIFY(lifted > 10);
}

// Wrong: which links open, what the others take over, or what falls apart.
void TestEquilibrium::agreesWithTheForceMethodWherePulledOpen()
{
    int opened = 0, apart = 0;
    for (unsigned seed = 100; seed < 140; ++seed) {
        StructureSource source(seed);
        const int members = 2 + source.upTo(1);
        Structure stand = source.stand(members, 4 - members, 4, 1);
        for (Link &link : stand.links)
            link.grip = source.upTo(1) == 0 ? 0.0 : source.between(0, 3);
        const Equilibrium found = solveEquilibrium(stand);
        if (found.components[0].body.balance != Balance::Stands)
            continue;
        const std::optional<ForceMethod> oracle = forceMethod(stand, true);
        const std::string where = "seed " + std::to_string(seed);
        QVERIFY2(oracle.has_value() == (found.balance() == Balance::Stands), where.c_str());
        if (!oracle) {
            ++apart;
            QCOMPARE(found.balance(), Balance::Mechanism);
            QVERIFY(!found.components[0].openLinks.empty());
            QCOMPARE(found.components[0].motion.size(), stand.members.size());
            continue;
        }
        const double off = differenceFrom(*oracle, stand, found);
        QVERIFY2(off < kSameAsDense, (where + ": " + std::to_string(off)).c_str());
        opened += found.components[0].openLinks.empty() ? 0 : 1;
    }
    QVERIFY(opened >= 3);
    QVERIFY(apart >= 3);
}

// Wrong: a foot holds something down.
void TestEquilibrium::feetPressOnly()
{
    Structure stand = block(fourFeet(), {0, 0}, 1.0);
    stand.members.push_back({1.0, {0, 20, 0}});
    stand.links.push_back(upright(0, 1, {0, 25, 0}, Vec3::UnitY()));
    for (const Vec2 &foot : fourFeet(80.0))
        stand.feet.push_back({1, {foot.x(), 0, foot.y()}, 1e4, false});
    stand.loads.push_back({1, {70, 20, 60}, {0, -200, 0}, Vec3::Zero()});
    const Equilibrium found = solveEquilibrium(stand);
    QCOMPARE(found.balance(), Balance::Stands);
    int lifted = 0;
    for (std::size_t i = 0; i < stand.feet.size(); ++i) {
        const Foot &foot = stand.feet[i];
        const RigidMotion &motion = found.members[foot.member];
        const Vec3 moved = motion.translation +
                           motion.rotation.cross(foot.point - stand.members[foot.member].centroid);
        QVERIFY(found.feet[i].force.y() >= 0.0);
        // It presses as far as it is pushed in, and one that does not has come off the ground.
        const double press = foot.stiffness * std::max(0.0, -moved.y());
        QVERIFY(std::abs(press - found.feet[i].force.y()) < kSame * 200.0);
        lifted += found.feet[i].isPressing ? 0 : 1;
    }
    QVERIFY(lifted > 0);
}

// Wrong: pinned feet that slide, or hold while they are in the air.
void TestEquilibrium::pinnedFeetHoldHorizontally()
{
    Structure stand = block(fourFeet(), {0, 0}, 1.0);
    stand.loads.push_back({0, {0, 30, 0}, {3, 0, 1}, Vec3::Zero()});
    QCOMPARE(solveEquilibrium(stand).balance(), Balance::Slides);
    Support pinned;
    pinned.arePinned = true;
    const Equilibrium found = solveEquilibrium(stand, pinned);
    QCOMPARE(found.balance(), Balance::Stands);
    QVERIFY((sumOfReactions(found) + sumOfLoads(stand)).norm() < kBalanced * 10.0);
    for (Foot &foot : stand.feet)
        foot.isPinned = foot.point.x() > 0.0;
    const Equilibrium half = solveEquilibrium(stand);
    QCOMPARE(half.balance(), Balance::Stands);
    for (std::size_t i = 0; i < stand.feet.size(); ++i) {
        const Vec3 &force = half.feet[i].force;
        const double across = std::hypot(force.x(), force.z());
        QVERIFY(stand.feet[i].isPinned ? across > 0.1 : across < kBalanced * 10.0);
    }
    // Pushed along a diagonal, far enough to lift the foot behind.
    stand.loads[0].force = {10, 0, 10};
    const Equilibrium lifted = solveEquilibrium(stand, pinned);
    QCOMPARE(lifted.balance(), Balance::Stands);
    QVERIFY(!lifted.feet[2].isPressing);
    QVERIFY(lifted.feet[2].force.norm() < kBalanced * 10.0);
    QVERIFY(lifted.worstResidual < kBalanced);
}

// Wrong: what hangs by nothing is said to hold, or its weight is lost.
void TestEquilibrium::aLinkThatHangsAsksForGrip()
{
    const double weight = 0.2 * 9.81;
    const Equilibrium held = solveEquilibrium(hanging(3.0));
    QCOMPARE(held.balance(), Balance::Stands);
    QVERIFY(std::abs(held.links[0].pull - weight) < kBalanced * weight);
    QVERIFY(held.components[0].openLinks.empty());

    const Equilibrium falls = solveEquilibrium(hanging(1.0));
    QCOMPARE(falls.balance(), Balance::Mechanism);
    QVERIFY(std::abs(falls.links[0].asked - weight) < kBalanced * weight);
    QVERIFY(falls.links[0].isOpen);
    QCOMPARE(falls.components[0].openLinks, std::vector<int>{0});
    QCOMPARE(falls.components[0].offenders, std::vector<int>{1});
    const RigidMotion &motion = falls.components[0].motion[1];
    QVERIFY((motion.translation - Vec3(0, -1, 0)).norm() < 1e-6); // straight down
    QVERIFY(falls.components[0].motion[0].translation.norm() < 1e-6);
}

// Wrong: a link carries more than its grip, or the rest does not take over.
void TestEquilibrium::anOpenedLinkShedsItsPull()
{
    // A beam over two slits, loaded beyond the one: the other is pulled; a third beside it bears.
    Structure stand = block(fourFeet(), {0, 0}, 2.0);
    stand.members.push_back({0.1, {0, 50, 0}});
    for (double x : {-30.0, 10.0, 30.0})
        stand.links.push_back(upright(1, 0, {x, 45, 0}, Vec3::UnitY()));
    for (Link &link : stand.links) {
        link.axis = -Vec3::UnitY();
        link.grip = 0.5;
    }
    stand.loads.push_back({1, {60, 50, 0}, {0, -8, 0}, Vec3::Zero()});
    const Equilibrium found = solveEquilibrium(stand);
    QCOMPARE(found.balance(), Balance::Stands);
    QVERIFY(found.links[0].asked > 0.5);
    QVERIFY(std::abs(found.links[0].pull - 0.5) < kBalanced * 10.0);
    QVERIFY(found.links[0].isOpen);
    QCOMPARE(found.components[0].openLinks, std::vector<int>{0});
    QVERIFY(found.worstResidual < kBalanced);
    QVERIFY(differenceFrom(*forceMethod(stand, true), stand, found) < kSameAsDense);
}

// Wrong: what was kept from before shows in the answer.
void TestEquilibrium::editedEqualsFromScratch()
{
    StructureSource source(11);
    EquilibriumCache cache;
    Structure stand = source.stand(6, 4, 7, 2);
    for (Link &link : stand.links)
        link.grip = source.between(0, 20);
    for (int edit = 0; edit < 60; ++edit) {
        const int member = source.upTo(5);
        switch (edit % 6) {
        case 0:
            stand.members[member].mass = source.between(0.05, 2.0);
            break;
        case 1:
            stand.loads[0].point = source.point(50.0);
            break;
        case 2:
            stand.links[source.upTo(8)].depthA = source.between(5, 40);
            break;
        case 3:
            stand.members[member].centroid = source.point(60.0);
            break;
        case 4:
            stand.links.back() = source.link(member, (member + 1) % 6);
            break;
        default:
            stand.feet[source.upTo(6)].point.x() += source.between(-5, 5);
        }
        Support support;
        support.arePinned = edit % 4 == 3;
        const Equilibrium kept = solveEquilibrium(stand, support, cache);
        const Equilibrium fresh = solveEquilibrium(stand, support);
        const std::string where = "edit " + std::to_string(edit);
        QVERIFY2(kept.balance() == fresh.balance(), where.c_str());
        QVERIFY2(difference(stand, fresh, kept) < kSame, where.c_str());
    }
}

// Wrong: a bound of the stresses is left out, or a determinate model solved four times.
void TestEquilibrium::envelope()
{
    EquilibriumCache cache;
    QCOMPARE(solveEnvelope(block({{0, 0}, {100, 0}, {0, 100}}, {20, 50}), {}, cache).size(), 1u);
    const Structure stand = StructureSource(21).stand(4, 2, 5, 1);
    const std::vector<Equilibrium> all = solveEnvelope(stand, {}, cache);
    QCOMPARE(all.size(), 4u);
    for (const Equilibrium &one : all) {
        QCOMPARE(one.balance(), Balance::Stands);
        QVERIFY(one.worstResidual < kBalanced);
    }
    // Free to turn about the axis: no moment about it.
    for (std::size_t i = 0; i < stand.links.size(); ++i) {
        const Link &link = stand.links[i];
        QVERIFY(std::abs(all[1].links[i].onA.moment.dot(link.axis)) <
                kSame * largest(stand, all[1]) * stand.size);
    }
    QVERIFY(difference(stand, all[0], all[1]) > 1e-3);
    QVERIFY(difference(stand, all[0], all[2]) > 1e-3);
}

FFF_TEST(TestEquilibrium)
#include "tst_equilibrium.moc"
