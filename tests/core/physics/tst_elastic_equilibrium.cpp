#include "core/physics/elastic_equilibrium.h"
#include "tests/core/physics/plate_case.h"
#include "tests/test_program.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace fff;

namespace {

QString casePath(const char *name)
{
    return QStringLiteral(FFF_SHARED "/mechanics/cases/%1.json").arg(QLatin1String(name));
}

std::vector<MemberFlexibility> flexibilitiesOf(const PlateCase &plates)
{
    std::vector<MemberFlexibility> result;
    for (std::size_t i = 0; i < plates.sections.size(); ++i) {
        const CasePlate plate = casePlate(plates, static_cast<int>(i)).value();
        result.push_back({plate.at, plateFlexibility(plate.model, plate.attachments, plate.loads)
                                        .value()
                                        .inWorld(plates.sections[i].frame)});
    }
    return result;
}

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

} // namespace

class TestElasticEquilibrium : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void feetOfARedundantStand();
    void casesOfAssemblies_data();
    void casesOfAssemblies();
    void turnedWorldTurnsTheAnswer();
    void whichIsAIsOfNoAccount();
    void fourEqualFeetShareAsAPlaneDoes();
    void aFootThatWouldPullIsLifted();
    void whatTopplesIsNotBalanced();
    void gripHoldsAsMuchAsItHolds();
    void manyMembersBalance();
    void canBeStopped();
    void nonsenseIsToldApart();
};

void TestElasticEquilibrium::feetOfARedundantStand()
{
    const auto plates = readCase(casePath("c10_crossed_stand_indeterminate"));
    if (!plates)
        FFF_WITHOUT_SHARED();
    const auto solved = elasticEquilibrium(plates->structure, flexibilitiesOf(*plates));
    QVERIFY(solved.has_value());
    QVERIFY(solved->isBalanced());
    const QJsonArray truth =
        plates->json["truth_contact"_L1].toObject()["contact_reactions_N"_L1].toArray();
    for (int k = 0; k < 4; ++k) {
        // Wrong: the stand's load goes to the feet as if the sections were stiff (5.06, 4.17, 1.15,
        // 1.15 N), not as finite elements with real contacts have it.
        const double foot = solved->feet[static_cast<std::size_t>(k)].z();
        QVERIFY2(std::abs(foot - vec3Of(truth[k]).z()) < 0.25, qPrintable(QString::number(foot)));
    }
    QVERIFY(std::abs(solved->feet[2].z() / 4.84 - 1.0) < 0.1);
    QVERIFY(std::abs(solved->feet[2].z() - solved->feet[3].z()) < 0.01);
}

void TestElasticEquilibrium::casesOfAssemblies_data()
{
    QTest::addColumn<QString>("file");
    for (const char *name :
         {"c13_shelf_two_supports", "c16_three_leg_glass_stand", "c17_four_leg_glass_stand"})
        QTest::newRow(name) << casePath(name);
}

void TestElasticEquilibrium::casesOfAssemblies()
{
    QFETCH(QString, file);
    const auto plates = readCase(file);
    if (!plates)
        FFF_WITHOUT_SHARED();
    const auto solved = elasticEquilibrium(plates->structure, flexibilitiesOf(*plates));
    QVERIFY(solved.has_value());
    QVERIFY(solved->isBalanced());
    const QJsonObject truth = plates->json["truth"_L1].toObject();
    double sum = 0.0, weight = 0.0;
    for (std::size_t k = 0; k < solved->feet.size(); ++k) {
        const double there =
            vec3Of(truth["contact_reactions_N"_L1].toArray()[static_cast<int>(k)]).z();
        // Wrong: a foot carries something else than in space.
        QVERIFY2(std::abs(solved->feet[k].z() / there - 1.0) < 0.05,
                 qPrintable(QString::number(solved->feet[k].z() / there)));
        sum += solved->feet[k].z();
    }
    for (const Member &member : plates->structure.members)
        weight += 9.81 * member.mass;
    for (const MemberLoad &load : plates->structure.loads)
        weight -= load.force.z();
    // Wrong: the ground carries more or less than there is.
    QVERIFY(std::abs(sum / weight - 1.0) < 1e-9);
    std::vector<CasePlate> models;
    std::vector<PlateStress> stresses;
    for (int i = 0; i < static_cast<int>(plates->sections.size()); ++i) {
        models.push_back(casePlate(*plates, i).value());
        stresses.push_back(plateStress(models.back().model,
                                       caseDisplacements(*plates, models.back(), i, *solved)));
    }
    for (const QJsonValue value : truth["cuts"_L1].toArray()) {
        const QJsonObject cut = value.toObject();
        const auto i = static_cast<std::size_t>(sectionIndex(*plates, cut["section"_L1]));
        const double ours =
            plateCut(models[i].model, stresses[i], vec2Of(cut["p0"_L1]), vec2Of(cut["p1"_L1]))
                .linear;
        const double ratio = ours / cut["fem"_L1].toObject()["sigma_lin"_L1].toDouble();
        // Wrong: a section's stress is not that in space. supR_z60 is a wide support barely
        // pressed, whose truth has glued slits: it is off by 5.4 %.
        const double allowed = cut["name"_L1].toString() == u"supR_z60" ? 0.08 : 0.05;
        QVERIFY2(std::abs(ratio - 1.0) < allowed,
                 qPrintable(cut["name"_L1].toString() + QStringLiteral(" %1").arg(ratio)));
    }
}

void TestElasticEquilibrium::turnedWorldTurnsTheAnswer()
{
    const auto plates = readCase(casePath("c10_crossed_stand_indeterminate"));
    if (!plates)
        FFF_WITHOUT_SHARED();
    const auto turn =
        Eigen::AngleAxisd(1.1, Vec3(1, 2, -0.5).normalized()).toRotationMatrix().eval();
    const Vec3 move(100, -20, 3);
    PlateCase other = *plates;
    for (Member &member : other.structure.members)
        member.centroid = turn * member.centroid + move;
    for (Link &link : other.structure.links) {
        link.point = turn * link.point + move;
        link.axis = turn * link.axis;
        link.normalA = turn * link.normalA;
        link.normalB = turn * link.normalB;
    }
    for (Foot &foot : other.structure.feet)
        foot.point = turn * foot.point + move;
    for (MemberLoad &load : other.structure.loads) {
        load.point = turn * load.point + move;
        load.force = turn * load.force;
    }
    for (CaseSection &section : other.sections) {
        section.frame.origin = turn * section.frame.origin + move;
        section.frame.x = turn * section.frame.x;
        section.frame.y = turn * section.frame.y;
    }
    other.structure.gravity = turn * other.structure.gravity;
    other.structure.up = turn * other.structure.up;
    const auto here = elasticEquilibrium(plates->structure, flexibilitiesOf(*plates)).value();
    const auto there = elasticEquilibrium(other.structure, flexibilitiesOf(other)).value();
    for (std::size_t k = 0; k < here.feet.size(); ++k) {
        // Wrong: the answer depends on which way is up or where the model stands.
        QVERIFY((turn * here.feet[k] - there.feet[k]).norm() < 1e-6);
    }
    QVERIFY((turn * here.links[0].head<3>() - there.links[0].head<3>()).norm() < 1e-6);
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
