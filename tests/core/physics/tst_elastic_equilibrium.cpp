// Forces on sections that bend: their laws (against other solvers: compare_elastic.cpp).
#include <QTest> // first: moc stumbles over some standard headers

#include "tests/core/physics/reference_plates.h"
#include "tests/test_program.h"

#include <array>
#include <cmath>

using namespace fff;
using namespace fff::test;

namespace {

/// A rigid table of 1 kg on feet at these places (x, z), pressed by 10 N at `load`.
Structure tableOn(const std::vector<Vec2> &feet, const Vec2 &load)
{
    Structure table;
    table.members = {{1.0, {0, 50, 0}}};
    for (const Vec2 &p : feet)
        table.feet.push_back({0, {p.x(), 0, p.y()}, 1e4});
    table.loads = {{0, {load.x(), 60, load.y()}, {0, -10, 0}, Vec3::Zero()}};
    return table;
}

/// Crossing plates in a row, each joined to the next, every one on two feet.
Structure row(int count)
{
    Structure structure;
    structure.size = 40.0 * count;
    for (int i = 0; i < count; ++i) {
        const double x = 40.0 * i;
        structure.members.push_back({0.05, {x, 40, 0}});
        structure.feet.push_back({i, {x, 0, i % 2 == 0 ? -30.0 : -20.0}, 1e4});
        structure.feet.push_back({i, {x, 0, i % 2 == 0 ? 30.0 : 20.0}, 1e4});
    }
    const auto join = [&](int a, int b) {
        Link link;
        link.a = a;
        link.b = b;
        link.point = {20.0 * (a + b), 40, 5.0 * (a % 3)};
        link.axis = Vec3::UnitY();
        link.normalA = Vec3::UnitX();
        link.normalB = Vec3::UnitZ();
        link.depthA = link.depthB = 30.0;
        link.thicknessA = link.thicknessB = 3.0;
        link.modulusA = link.modulusB = 3200.0;
        link.grip = 1e3;
        structure.links.push_back(link);
    };
    for (int i = 0; i + 1 < count; ++i)
        join(i, i + 1);
    for (int i = 0; i + 2 < count; i += 2)
        join(i, i + 2);
    structure.loads = {{0, {3, 80, 5}, {0, -20, 0}, Vec3::Zero()}};
    return structure;
}

/// All of it turned, then moved.
ReferenceCase turned(ReferenceCase given, const Eigen::Matrix3d &turn, const Vec3 &move)
{
    const auto place = [&](Vec3 &point) { point = turn * point + move; };
    const auto direct = [&](Vec3 &direction) { direction = turn * direction; };
    for (Member &member : given.structure.members)
        place(member.centroid);
    for (Link &link : given.structure.links) {
        place(link.point);
        for (Vec3 *direction : {&link.axis, &link.normalA, &link.normalB})
            direct(*direction);
    }
    for (Foot &foot : given.structure.feet)
        place(foot.point);
    for (std::size_t i = 0; i < given.patches.size(); ++i) {
        MemberLoad &load = given.structure.loads[i];
        place(load.point);
        direct(load.force);
        direct(load.moment);
        given.patches[i].load = load;
    }
    for (ReferenceSection &section : given.sections) {
        place(section.frame.origin);
        direct(section.frame.x);
        direct(section.frame.y);
    }
    direct(given.structure.gravity);
    direct(given.structure.up);
    return given;
}

} // namespace

class TestElasticEquilibrium : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void turnedWorldTurnsTheAnswer();
    void whichIsAIsOfNoAccount();
    void fourEqualFeetShareAsAPlaneDoes();
    void aFootThatWouldPullIsLifted();
    void whatTopplesIsNotBalanced();
    void gripHoldsAsMuchAsItHolds();
    void oneHoldAfterTheOther();
    void manyMembersBalance();
    void canBeStopped();
    void nonsenseIsToldApart();
};

void TestElasticEquilibrium::turnedWorldTurnsTheAnswer()
{
    QString error;
    const auto given = readReferenceCase(
        QStringLiteral(FFF_TEST_DATA "/mechanics/07_portals_on_hinges.json"), &error);
    QVERIFY2(given, qPrintable(error));
    const auto turn =
        Eigen::AngleAxisd(1.1, Vec3(1, 2, -0.5).normalized()).toRotationMatrix().eval();
    const ReferenceCase other = turned(*given, turn, {100, -20, 3});
    const auto solved = [](const ReferenceCase &found) {
        return elasticEquilibrium(found.structure, flexibilitiesOf(found, platesOf(found).value()))
            .value();
    };
    const auto here = solved(*given), there = solved(other);
    QVERIFY(here.isBalanced() && there.isBalanced());
    double sideways = 0.0;
    for (std::size_t k = 0; k < here.feet.size(); ++k) {
        // Wrong: the answer depends on which way is up or where the model stands.
        QVERIFY((turn * here.feet[k] - there.feet[k]).norm() < 1e-6);
        sideways = std::max(sideways, std::abs(here.feet[k].x()));
    }
    for (std::size_t j = 0; j < here.links.size(); ++j)
        QVERIFY((turn * here.links[j].head<3>() - there.links[j].head<3>()).norm() < 1e-6);
    // Wrong: feet that are held slide all the same.
    QVERIFY(sideways > 0.5);
}

void TestElasticEquilibrium::whichIsAIsOfNoAccount()
{
    const Structure structure = row(8);
    Structure swapped = structure;
    for (Link &link : swapped.links) {
        std::swap(link.a, link.b);
        std::swap(link.normalA, link.normalB);
        link.axis = -link.axis;
    }
    const auto here = elasticEquilibrium(structure, {}).value();
    const auto there = elasticEquilibrium(swapped, {}).value();
    // Wrong: the forces depend on which section of a joint is named first.
    for (std::size_t k = 0; k < here.feet.size(); ++k)
        QVERIFY((here.feet[k] - there.feet[k]).norm() < 1e-7);
    for (std::size_t j = 0; j < here.links.size(); ++j)
        QVERIFY((here.links[j] + there.links[j]).norm() < 1e-5);
}

void TestElasticEquilibrium::fourEqualFeetShareAsAPlaneDoes()
{
    const auto solved =
        elasticEquilibrium(tableOn({{-50, -50}, {50, -50}, {50, 50}, {-50, 50}}, {20, 10}), {});
    QVERIFY(solved.has_value() && solved->isBalanced());
    // Wrong: a stiff table on four like feet does not press them by a linear rule.
    const std::array<double, 4> expected{
        (9.81 + 10.0) / 4 + 10.0 * (-20 - 10) / 200, (9.81 + 10.0) / 4 + 10.0 * (20 - 10) / 200,
        (9.81 + 10.0) / 4 + 10.0 * (20 + 10) / 200, (9.81 + 10.0) / 4 + 10.0 * (-20 + 10) / 200};
    for (std::size_t k = 0; k < 4; ++k)
        QVERIFY(std::abs(solved->feet[k].y() - expected[k]) < 1e-8);
}

void TestElasticEquilibrium::aFootThatWouldPullIsLifted()
{
    Structure table = tableOn({{-50, -50}, {50, -50}, {50, 50}, {-50, 50}}, {45, 45});
    table.members[0].mass = 0.1;
    const auto solved = elasticEquilibrium(table, {});
    QVERIFY(solved.has_value() && solved->isBalanced());
    // Wrong: the ground pulls at the foot that lifts off, or it lifts off and nobody says so.
    QVERIFY(solved->isLifted[0]);
    QVERIFY(solved->feet[0].norm() == 0.0);
    QVERIFY(std::abs(solved->feet[1].y() - solved->feet[3].y()) < 1e-8);
    const double sum = solved->feet[1].y() + solved->feet[2].y() + solved->feet[3].y();
    QVERIFY(std::abs(sum - 10.981) < 1e-8);
    QVERIFY(!solved->isLifted[1] && !solved->isLifted[2] && !solved->isLifted[3]);
}

void TestElasticEquilibrium::whatTopplesIsNotBalanced()
{
    const auto falls =
        elasticEquilibrium(tableOn({{-50, -50}, {50, -50}, {50, 50}, {-50, 50}}, {300, 0}), {});
    // Wrong: what falls over gets forces, and is coloured by them.
    QVERIFY(falls.has_value());
    QVERIFY(!falls->isBalanced());
    const auto floats = elasticEquilibrium(tableOn({}, {0, 0}), {});
    QVERIFY(floats.has_value() && !floats->isBalanced());
}

void TestElasticEquilibrium::gripHoldsAsMuchAsItHolds()
{
    // A beam on two stands, each joined to it; pressed beyond one, it would be pulled off the
    // other.
    Structure structure;
    structure.members = {{0.01, {0, 50, 0}}, {0.5, {-50, 20, 0}}, {0.5, {50, 20, 0}}};
    for (int side = 0; side < 2; ++side) {
        const double x = side == 0 ? -50.0 : 50.0;
        for (const Vec2 &p : {Vec2(-20, -20), Vec2(20, -20), Vec2(20, 20), Vec2(-20, 20)})
            structure.feet.push_back({side + 1, {x + p.x(), 0, p.y()}, 1e4});
        Link link;
        link.b = side + 1;
        link.point = {x, 50, 0};
        link.axis = -Vec3::UnitY(); // the beam's slit opens down: it is pulled off upwards
        link.normalA = Vec3::UnitZ();
        link.normalB = Vec3::UnitX();
        link.depthA = link.depthB = 20.0;
        link.thicknessA = link.thicknessB = 3.0;
        link.modulusA = link.modulusB = 3200.0;
        structure.links.push_back(link);
    }
    structure.loads = {{0, {70, 50, 0}, {0, -5, 0}, Vec3::Zero()}};
    const auto axial = [&](double grip) {
        for (Link &link : structure.links)
            link.grip = grip;
        const auto solved = elasticEquilibrium(structure, {}).value();
        return std::pair(solved.links[0].head<3>().dot(structure.links[0].axis), solved);
    };
    const auto glued = axial(1e6);
    const auto loose = axial(0.0);
    const auto held = axial(0.5 * glued.first);
    // Wrong: a joint that nothing holds pulls, or one that friction holds does not.
    QVERIFY(glued.first > 0.1);
    QVERIFY(!glued.second.isParted[0]);
    QVERIFY(glued.second.isBalanced() && loose.second.isBalanced() && held.second.isBalanced());
    QVERIFY(std::abs(loose.first) < 1e-9);
    QVERIFY(loose.second.isParted[0] && !loose.second.isParted[1]);
    QVERIFY(std::abs(held.first - 0.5 * glued.first) < 1e-9);
}

// Wrong: what lifts off under one hold stays so under another.
void TestElasticEquilibrium::oneHoldAfterTheOther()
{
    for (const double push : {-2000.0, -20.0, 0.0, 20.0, 200.0}) {
        Structure structure = row(9);
        structure.loads.push_back({4, {160, 70, 25}, {0, push, 0}, Vec3::Zero()});
        auto kept = ElasticStructure::make(structure, {});
        QVERIFY(kept.has_value());
        for (const FootHold hold :
             {FootHold::Frictionless, FootHold::Pinned, FootHold::Frictionless, FootHold::Pinned}) {
            const auto after = kept->solve(hold);
            const auto anew = elasticEquilibrium(structure, {}, hold);
            QVERIFY(after.has_value() && anew.has_value());
            QCOMPARE(after->isBalanced(), anew->isBalanced());
            if (!anew->isBalanced())
                continue;
            QVERIFY(after->isLifted == anew->isLifted && after->isParted == anew->isParted);
            for (std::size_t k = 0; k < anew->feet.size(); ++k)
                QVERIFY((after->feet[k] - anew->feet[k]).norm() == 0.0);
        }
    }
}

void TestElasticEquilibrium::manyMembersBalance()
{
    const Structure structure = row(100);
    const auto solved = elasticEquilibrium(structure, {});
    QVERIFY(solved.has_value());
    double sum = 0.0;
    for (const Vec3 &foot : solved->feet) {
        QVERIFY(foot.y() >= -1e-7);
        sum += foot.y();
    }
    // Wrong: a large model finds no end of lifting and setting down its feet, or what it finds does
    // not carry it.
    QVERIFY(solved->isBalanced());
    QVERIFY(std::abs(sum - (100 * 0.05 * 9.81 + 20.0)) < 1e-7);
}

void TestElasticEquilibrium::canBeStopped()
{
    std::stop_source source;
    LongWork work;
    work.stop = source.get_token();
    std::vector<double> told;
    work.progress = [&](double share) {
        told.push_back(share);
        source.request_stop();
    };
    // Wrong: once nobody waits any more, it goes on, or what it had is taken for the answer.
    const auto stopped = elasticEquilibrium(row(20), {}, FootHold::Frictionless, work);
    QVERIFY(!stopped.has_value());
    QCOMPARE(stopped.error().code, ErrorCode::Cancelled);
    QCOMPARE(told.size(), std::size_t(1));
    QVERIFY(told[0] > 0.0 && told[0] <= 1.0);
}

void TestElasticEquilibrium::nonsenseIsToldApart()
{
    Structure table = tableOn({{-50, -50}, {50, -50}, {0, 50}}, {0, 0});
    // Wrong: flexibilities of another model are read beyond their end.
    QCOMPARE(elasticEquilibrium(table, {{}, {}}).error().code, ErrorCode::BadCount);
    MemberFlexibility wrong;
    wrong.attachments = {{MemberAttachment::Kind::Foot, 7}};
    wrong.flexibility = {Eigen::MatrixXd::Zero(6, 6), Eigen::VectorXd::Zero(6)};
    QCOMPARE(elasticEquilibrium(table, {wrong}).error().code, ErrorCode::BadCount);
    table.loads[0].force.x() = NAN;
    QCOMPARE(elasticEquilibrium(table, {}).error().code, ErrorCode::NonFinite);
}

FFF_TEST(TestElasticEquilibrium)

#include "tst_elastic_equilibrium.moc"
