#include "core/physics/equilibrium.h"
#include "tests/core/physics/structures.h"
#include "tests/test_program.h"

#include <QTest>

using namespace fff;
using namespace fff::test;

namespace {

constexpr double kBalanced = 1e-9; // share: what may be left over, and of the sum of reactions

/// A stand with one thing of it as nobody should have it; `which` as in nastyNumbers_data.
Structure spoiled(Structure stand, int which)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    switch (which) {
    case 0:
        stand.members[1].mass = nan;
        break;
    case 1:
        stand.feet[0].point.x() = kUnlimitedGrip;
        break;
    case 2:
        stand.links[0].axis.setZero();
        break;
    case 3:
        stand.loads[0].force.y() = nan;
        break;
    case 4:
        stand.links[0].b = 99;
        break;
    case 5:
        for (Member &member : stand.members)
            member.mass = 0.0;
        stand.loads.clear();
        break;
    case 6:
        stand.feet.insert(stand.feet.end(), 5, stand.feet[0]);
        break;
    case 7:
        stand.members[0].mass = 1e-3;
        stand.members[1].mass = 1e6;
        break;
    case 8:
        stand.links[0].depthA = stand.links[0].depthB = 0.0;
        break;
    case 9:
        stand.feet[0].stiffness = stand.links[0].modulusA = 0.0;
        break;
    case 10:
        stand.size = nan;
        break;
    case 11:
        for (Member &member : stand.members)
            member.centroid.x() += 1e6;
        for (Link &link : stand.links)
            link.point.x() += 1e6;
        for (Foot &foot : stand.feet)
            foot.point.x() += 1e6;
        stand.loads[0].point.x() += 1e6;
        break;
    case 12:
        stand = {};
        break;
    case 13:
        stand.up.setZero();
        break;
    default:
        stand.links[0].grip = nan;
    }
    return stand;
}

} // namespace

class TestEquilibriumExtremes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void manyFeet();
    void latticeOfManyLinks();
    void longChain();
    void nastyNumbers_data();
    void nastyNumbers();
};

// Wrong: thousands of feet take their number of passes, or lose the sum.
void TestEquilibriumExtremes::manyFeet()
{
    constexpr int kRibs = 3200;
    StructureSource source(5);
    Structure comb;
    comb.size = 10.0 * kRibs;
    comb.members.push_back({5.0, {5.0 * kRibs, 30, 0}});
    for (int i = 0; i < kRibs; ++i) {
        const double x = 10.0 * i;
        comb.members.push_back({source.between(0.02, 0.2), {x, 20, source.between(-20, 20)}});
        comb.links.push_back(upright(0, i + 1, {x, 30, 0}, Vec3::UnitY()));
        for (double z : {-50.0, 50.0})
            comb.feet.push_back({i + 1, {x, 0, z}, 1e4, false});
    }
    comb.loads.push_back({0, {200, 30, 20}, {0, -3000, 0}, Vec3::Zero()});
    const Equilibrium found = solveEquilibrium(comb);
    QCOMPARE(found.balance(), Balance::Stands);
    QVERIFY(found.components[0].passes <= 30);
    QVERIFY(found.worstResidual < kBalanced);
    const Vec3 load = sumOfLoads(comb);
    QVERIFY((sumOfReactions(found) + load).norm() < kBalanced * load.norm());
    int lifted = 0;
    for (const FootForce &foot : found.feet)
        lifted += foot.isPressing ? 0 : 1;
    QVERIFY(lifted > 100);
}

// Wrong: a factorisation for every foot that lifts.
void TestEquilibriumExtremes::latticeOfManyLinks()
{
    constexpr int kSide = 30;
    StructureSource source(6);
    Structure lattice;
    lattice.size = 14.0 * kSide;
    for (int i = 0; i < 2 * kSide; ++i) {
        const double along = 5.0 * kSide, across = 10.0 * (i % kSide);
        const Vec3 centroid = i < kSide ? Vec3(across, 20, along) : Vec3(along, 20, across);
        lattice.members.push_back({source.between(0.05, 0.2), centroid});
        for (double end : {0.0, 10.0 * (kSide - 1)}) {
            const Vec3 at = i < kSide ? Vec3(across, 0, end) : Vec3(end, 0, across);
            lattice.feet.push_back({i, at, 1e4, false});
        }
    }
    for (int i = 0; i < kSide; ++i) {
        for (int j = 0; j < kSide; ++j)
            lattice.links.push_back(upright(i, kSide + j, {10.0 * i, 20, 10.0 * j}, Vec3::UnitY()));
    }
    lattice.loads.push_back({0, {5, 20, 5}, {0, -2000, 0}, Vec3::Zero()});
    const Equilibrium found = solveEquilibrium(lattice);
    QCOMPARE(found.balance(), Balance::Stands);
    QVERIFY(found.worstResidual < kBalanced);
    QVERIFY(found.components[0].factorisations <= 3);
    QVERIFY(found.components[0].passes <= 30);
}

// Wrong: a soft model's forces are made of its large displacements, whose last digits are gone.
void TestEquilibriumExtremes::longChain()
{
    constexpr int kLinks = 300;
    Structure chain = block(fourFeet(), {0, 0}, 5000.0);
    chain.size = 20.0 * kLinks;
    for (int i = 1; i <= kLinks; ++i) {
        chain.members.push_back({0.05, {20.0 * i, 40, 0}});
        chain.links.push_back(upright(i, i - 1, {20.0 * i - 10.0, 40, 0}, -Vec3::UnitY()));
    }
    const Equilibrium found = solveEquilibrium(chain);
    QCOMPARE(found.balance(), Balance::Stands);
    QVERIFY2(found.worstResidual < kBalanced, std::to_string(found.worstResidual).c_str());
    // At the root: all of them, at half their reach.
    const double weight = kLinks * 0.05 * 9.81, moment = weight * 10.0 * kLinks;
    QVERIFY(std::abs(found.links[0].onA.force.y() - weight) < kBalanced * weight);
    QVERIFY(std::abs(found.links[0].onA.moment.z() - moment) < kBalanced * moment);
}

void TestEquilibriumExtremes::nastyNumbers_data()
{
    QTest::addColumn<int>("which");
    QTest::newRow("a mass that is no number") << 0;
    QTest::newRow("a foot at infinity") << 1;
    QTest::newRow("a link without an axis") << 2;
    QTest::newRow("a load that is no number") << 3;
    QTest::newRow("a link to a member that is not there") << 4;
    QTest::newRow("nothing weighs anything") << 5;
    QTest::newRow("feet on one another") << 6;
    QTest::newRow("a gram beside a thousand tonnes") << 7;
    QTest::newRow("no depth of slits") << 8;
    QTest::newRow("a stiffness of nought") << 9;
    QTest::newRow("no size") << 10;
    QTest::newRow("far from the origin") << 11;
    QTest::newRow("no members") << 12;
    QTest::newRow("up is no direction") << 13;
    QTest::newRow("a grip that is no number") << 14;
}

// Wrong: something that is no number comes out, or it never ends.
void TestEquilibriumExtremes::nastyNumbers()
{
    QFETCH(int, which);
    const Structure stand = spoiled(StructureSource(31).stand(4, 1, 6, 1), which);
    const bool isSound = which >= 5 && which != 13 && which != 10;
    EquilibriumCache cache;
    for (bool arePinned : {false, true}) {
        Support support;
        support.arePinned = arePinned;
        const Equilibrium found = solveEquilibrium(stand, support, cache);
        QCOMPARE(found.balance() == Balance::NoContact, which == 12);
        for (const LinkForce &link : found.links)
            QVERIFY(link.onA.force.allFinite() && link.onA.moment.allFinite());
        for (const FootForce &foot : found.feet)
            QVERIFY(foot.force.allFinite());
        for (const ComponentState &component : found.components)
            QVERIFY(std::isfinite(component.body.margin) && component.body.onGround.allFinite());
        QVERIFY(std::isfinite(found.worstResidual));
        // What was left out is not passed over in silence.
        QVERIFY(isSound ? found.worstResidual < kBalanced : found.worstResidual == 1.0);
    }
}

FFF_TEST(TestEquilibriumExtremes)
#include "tst_equilibrium_extremes.moc"
