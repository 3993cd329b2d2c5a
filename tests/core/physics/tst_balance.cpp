#include "core/physics/equilibrium.h"
#include "tests/core/physics/structures.h"
#include "tests/test_program.h"

#include <QTest>

using namespace fff;
using namespace fff::test;

namespace {

constexpr double kMillimetres = 1e-9;

/// One above the other, without a link; only the first has feet.
Structure pairApart()
{
    Structure structure = block(fourFeet(), {0, 0});
    structure.members.push_back({0.3, {0, 90, 0}});
    return structure;
}

} // namespace

Q_DECLARE_METATYPE(Structure)

class TestBalance : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void verdicts_data();
    void verdicts();
    void marginByHand();
    void topplesOverItsEdge();
    void lineSupportOnTheLineCarries();
    void componentsByThemselves();
    void slidingForceByHand();
    void frictionHolds();
    void onTheEdgeIsNoFooting();
};

void TestBalance::verdicts_data()
{
    QTest::addColumn<Structure>("structure");
    QTest::addColumn<Balance>("balance");
    const Structure table = block(fourFeet(), {10, -20});
    QTest::newRow("a table") << table << Balance::Stands;
    QTest::newRow("its weight beside it") << block(fourFeet(), {60, 0}) << Balance::Topples;
    QTest::newRow("on two feet") << block({{-50, 0}, {50, 0}}, {0, 0}) << Balance::LineSupport;
    QTest::newRow("on one foot") << block({{3, 4}}, {3, 4}) << Balance::LineSupport;
    QTest::newRow("on feet in a row")
        << block({{-50, 0}, {0, 0}, {50, 0}}, {0, 0}) << Balance::LineSupport;
    // 0.01 · 3 mm · 100 mm = 3 mm², and the feet span 2.5
    QTest::newRow("on feet nearly in a row")
        << block({{-50, 0}, {0, 0.05}, {50, 0}}, {0, 0.02}) << Balance::LineSupport;
    QTest::newRow("without feet") << block({}, {0, 0}) << Balance::NoContact;
    QTest::newRow("something above it") << pairApart() << Balance::Floating;
    Structure lifted = table;
    lifted.loads.push_back({0, {10, 30, -20}, {0, 12, 0}, Vec3::Zero()});
    QTest::newRow("lifted by more than it weighs") << lifted << Balance::NoContact;
    Structure loaded = table;
    loaded.loads.push_back({0, {70, 30, 0}, {0, -60, 0}, Vec3::Zero()});
    QTest::newRow("loaded beside its feet") << loaded << Balance::Topples;
    Structure pushed = table;
    pushed.loads.push_back({0, {10, 0, -20}, {1, 0, 0}, Vec3::Zero()});
    QTest::newRow("pushed at the ground") << pushed << Balance::Slides;
    Structure turned = table;
    turned.loads.push_back({0, {10, 0, -20}, Vec3::Zero(), {0, 50, 0}});
    QTest::newRow("turned about the vertical") << turned << Balance::Slides;
    for (Foot &foot : turned.feet)
        foot.isPinned = foot.point.x() > 0 && foot.point.z() > 0;
    QTest::newRow("turned about its one pin") << turned << Balance::Slides;
    turned.feet[1].isPinned = true;
    QTest::newRow("turned, held by two pins") << turned << Balance::Stands;
    Structure lifting = block(fourFeet(), {0, 0});
    lifting.loads.push_back({0, {30, 0, 50}, {1, -10, 0}, Vec3::Zero()});
    lifting.feet[0].isPinned = true;
    QTest::newRow("pushed, held by a pin that presses") << lifting << Balance::Stands;
    std::swap(lifting.feet[0].isPinned, lifting.feet[2].isPinned);
    lifting.loads[0].point = {49, 0, 49};
    lifting.loads[0].force = {1, -100, 1};
    QTest::newRow("pushed, its one pin in the air") << lifting << Balance::Slides;
    Structure tipped = table;
    tipped.loads.push_back({0, {10, 30, -20}, Vec3::Zero(), {0, 0, -600}});
    QTest::newRow("tipped by a moment") << tipped << Balance::Topples;
    Structure hung = table;
    hung.members.push_back({0.1, {10, 10, -20}});
    hung.links.push_back(upright(0, 1, {10, 20, -20}, -Vec3::UnitY()));
    hung.links.back().grip = 0.5;
    QTest::newRow("something falls out of it") << hung << Balance::Mechanism;
    hung.links.back().grip = 1.5;
    QTest::newRow("something hangs in it") << hung << Balance::Stands;
    QTest::newRow("nothing") << Structure() << Balance::NoContact;
}

// Wrong: a person is told that it stands and it falls, or the other way round.
void TestBalance::verdicts()
{
    QFETCH(Structure, structure);
    QFETCH(Balance, balance);
    const Equilibrium found = solveEquilibrium(structure);
    QCOMPARE(found.balance(), balance);
    for (const ComponentState &component : found.components)
        QCOMPARE(component.offenders.empty(), component.balance == Balance::Stands);
    // The same however large the world is around it: a hill's gravity, a stone's.
    structure.gravity *= 1e-3;
    for (MemberLoad &load : structure.loads) {
        load.force *= 1e-3;
        load.moment *= 1e-3;
    }
    for (Link &link : structure.links)
        link.grip *= 1e-3;
    QCOMPARE(solveEquilibrium(structure).balance(), balance);
}

// Wrong: how far it is from toppling.
void TestBalance::marginByHand()
{
    const Equilibrium found = solveEquilibrium(block(fourFeet(), {10, -20}));
    const BodyBalance &body = found.components[0].body;
    QVERIFY(std::abs(body.margin - 30.0) < kMillimetres);
    QVERIFY((body.onGround - Vec3(10, 0, -20)).norm() < kMillimetres);
    QVERIFY((body.nearest - Vec3(10, 0, -50)).norm() < kMillimetres);
    // A load moves it: 9.81 N at (10, −20), 9.81 N at (40, 0).
    Structure loaded = block(fourFeet(), {10, -20});
    loaded.loads.push_back({0, {40, 77, 0}, {0, -9.81, 0}, Vec3::Zero()});
    const BodyBalance moved = solveEquilibrium(loaded).components[0].body;
    QVERIFY((moved.onGround - Vec3(25, 0, -10)).norm() < kMillimetres);
    QVERIFY(std::abs(moved.margin - 25.0) < kMillimetres);
    // A push of as much as it weighs at 12 above the ground moves it by 12.
    Structure pushed = block(fourFeet(), {10, -20});
    pushed.loads.push_back({0, {0, 12, 0}, {9.81, 0, 0}, Vec3::Zero()});
    const BodyBalance tilted = solveEquilibrium(pushed).components[0].body;
    QVERIFY(std::abs(tilted.onGround.x() - 22.0) < kMillimetres);
}

// Wrong: the edge that is shown is not the one it falls over.
void TestBalance::topplesOverItsEdge()
{
    const Equilibrium found = solveEquilibrium(block(fourFeet(), {62, 7}));
    const BodyBalance &body = found.components[0].body;
    QCOMPARE(body.balance, Balance::Topples);
    QVERIFY(std::abs(body.margin + 12.0) < kMillimetres);
    QCOMPARE(std::min(body.edge[0], body.edge[1]), 0); // (50, 50) and (50, −50)
    QCOMPARE(std::max(body.edge[0], body.edge[1]), 1);
    QVERIFY(!found.components[0].hasForces);
    QVERIFY(largest(block(fourFeet(), {62, 7}), found) == 0.0); // nothing is made up
}

// Wrong: a plate on its edge has no forces, or is said to stand.
void TestBalance::lineSupportOnTheLineCarries()
{
    const Structure plate = block({{-80, 0}, {80, 0}}, {20, 0}, 0.5);
    const Equilibrium found = solveEquilibrium(plate);
    QCOMPARE(found.balance(), Balance::LineSupport);
    QVERIFY(found.components[0].hasForces);
    const double weight = 0.5 * 9.81;
    QVERIFY(std::abs(found.feet[0].force.y() - 0.375 * weight) < 1e-9 * weight);
    QVERIFY(std::abs(found.feet[1].force.y() - 0.625 * weight) < 1e-9 * weight);
    QVERIFY(!solveEquilibrium(block({{-80, 0}, {80, 0}}, {20, 1})).components[0].hasForces);
    QVERIFY(!solveEquilibrium(block({{-80, 0}, {80, 0}}, {90, 0})).components[0].hasForces);
}

// Wrong: one that falls takes the forces of others with it, or hides behind them.
void TestBalance::componentsByThemselves()
{
    Structure all = pairApart();
    all.members.push_back({1.0, {500, 20, 0}});
    for (double z : {-10.0, 10.0})
        all.feet.push_back({2, {500, 0, z}, 1e4, false});
    all.feet.push_back({2, {520, 0, 0}, 1e4, false});
    all.members[2].centroid.x() = 530;
    const Equilibrium found = solveEquilibrium(all);
    QCOMPARE(found.components.size(), 3u);
    QCOMPARE(found.components[0].balance, Balance::Stands);
    QCOMPARE(found.components[1].balance, Balance::Floating);
    QCOMPARE(found.components[1].offenders, std::vector<int>{1});
    QCOMPARE(found.components[2].balance, Balance::Topples);
    QCOMPARE(found.balance(), Balance::Floating);
    for (int i = 0; i < 4; ++i)
        QVERIFY(std::abs(found.feet[i].force.y() - 0.25 * 9.81) < 1e-8);
    QVERIFY(found.feet[4].force.isZero());
}

// Wrong: how much friction it takes.
void TestBalance::slidingForceByHand()
{
    Structure pushed = block(fourFeet(), {0, 0});
    pushed.loads.push_back({0, {0, 5, 0}, {3, 0, -4}, Vec3::Zero()});
    BodyBalance body = solveEquilibrium(pushed).components[0].body;
    QCOMPARE(body.balance, Balance::Slides);
    // Its line passes where the resultant meets the ground, so that nothing turns.
    QVERIFY(std::abs(body.sliding - 5.0) < 1e-9);
    pushed.loads[0] = {0, {0, 5, 0}, Vec3::Zero(), {0, 100, 0}};
    body = solveEquilibrium(pushed).components[0].body;
    QVERIFY(std::abs(body.sliding - 100.0 / (50.0 * std::sqrt(2.0))) < 1e-9);
    QVERIFY(solveEquilibrium(block(fourFeet(), {1, 2})).components[0].body.sliding == 0.0);
}

// Wrong: friction that is enough does not hold, or that is too little does.
void TestBalance::frictionHolds()
{
    Structure pushed = block(fourFeet(), {0, 0});
    pushed.loads.push_back({0, {0, 5, 0}, {3, 0, 0}, Vec3::Zero()});
    Support support;
    support.friction = 0.3;
    QCOMPARE(solveEquilibrium(pushed, support).balance(), Balance::Slides); // 2.943 N
    support.friction = 0.31;
    const Equilibrium found = solveEquilibrium(pushed, support);
    QCOMPARE(found.balance(), Balance::Stands);
    Vec3 sum = Vec3::Zero();
    for (const FootForce &foot : found.feet)
        sum += foot.force;
    QVERIFY((sum - Vec3(-3, 9.81, 0)).norm() < 1e-8);
    QVERIFY(found.indeterminacy() > solveEquilibrium(block(fourFeet(), {0, 0})).indeterminacy());
}

// Wrong: rounding decides at the very edge.
void TestBalance::onTheEdgeIsNoFooting()
{
    for (double z : {-30.0, 0.0, 49.0}) {
        const Equilibrium found = solveEquilibrium(block(fourFeet(), {50, z}));
        QCOMPARE(found.balance(), Balance::Topples);
        QCOMPARE(found.components[0].body.margin, 0.0);
        const Equilibrium inside = solveEquilibrium(block(fourFeet(), {50 - 1e-6, z}));
        QCOMPARE(inside.balance(), Balance::Stands);
        QVERIFY(inside.worstResidual < 1e-9);
    }
}

FFF_TEST(TestBalance)
#include "tst_balance.moc"
