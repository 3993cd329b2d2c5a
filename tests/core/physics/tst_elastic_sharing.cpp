// Elastic equilibrium beside the same by other means: links in rows, in rings, at their grip.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/physics/elastic_equilibrium.h"
#include "tests/core/physics/force_method.h"
#include "tests/core/physics/structures.h"
#include "tests/test_program.h"

#include <string>

using namespace fff;
using namespace fff::test;

namespace {

constexpr double kAsDense = 1e-6; // of the largest force: what the dense solution leaves

double differenceOf(const ForceMethod &oracle, const Structure &stand,
                    const ElasticEquilibrium &found)
{
    double most = 0.0, scale = oracle.feet.norm();
    for (std::size_t j = 0; j < stand.links.size(); ++j) {
        const WrenchVector truth = oracle.wrenches.segment<6>(6 * static_cast<Eigen::Index>(j));
        const WrenchVector off = found.links[j] - truth;
        most = std::max({most, off.head<3>().norm(), off.tail<3>().norm() / stand.size});
        scale = std::max(scale, truth.head<3>().norm());
    }
    for (std::size_t k = 0; k < stand.feet.size(); ++k)
        most = std::max(most, std::abs(found.feet[k].dot(stand.up) -
                                       oracle.feet[static_cast<Eigen::Index>(k)]));
    return most / scale;
}

/// Each gives somehow where it is held, also in what its neighbours do.
std::vector<MemberFlexibility> flexibilitiesFor(const Structure &stand, StructureSource &source)
{
    std::vector<MemberFlexibility> members(stand.members.size());
    const auto hold = [&](int member, MemberAttachment::Kind kind, std::size_t index) {
        members[static_cast<std::size_t>(member)].attachments.push_back(
            {kind, static_cast<int>(index)});
    };
    for (std::size_t j = 0; j < stand.links.size(); ++j) {
        hold(stand.links[j].a, MemberAttachment::Kind::Link, j);
        hold(stand.links[j].b, MemberAttachment::Kind::Link, j);
    }
    for (std::size_t k = 0; k < stand.feet.size(); ++k)
        hold(stand.feet[k].member, MemberAttachment::Kind::Foot, k);
    for (MemberFlexibility &member : members) {
        const auto size = 6 * static_cast<Eigen::Index>(member.attachments.size());
        Eigen::MatrixXd root(size, size);
        for (double &value : root.reshaped())
            value = source.between(-0.01, 0.01);
        for (Eigen::Index row = 0; row < size; ++row)
            if (row % 6 >= 3)
                root.row(row) /= stand.size; // rotations
        member.flexibility.compliance = root * root.transpose();
        member.flexibility.deflection = root.col(0);
    }
    return members;
}

/// What the energy changes by with each unknown of equilibriumMatrix() at `found`.
Eigen::VectorXd slopeAt(const ElasticEquilibrium &found, const Structure &stand,
                        const std::vector<MemberFlexibility> &members)
{
    const auto links = static_cast<Eigen::Index>(stand.links.size());
    const auto feet = static_cast<Eigen::Index>(stand.feet.size());
    Eigen::VectorXd slope = Eigen::VectorXd::Zero(6 * links + feet);
    const auto toUnknown = [&](WrenchVector moves) {
        moves.tail<3>() *= stand.size;
        return moves;
    };
    for (Eigen::Index j = 0; j < links; ++j) {
        WrenchVector wrench = found.links[static_cast<std::size_t>(j)];
        wrench.tail<3>() /= stand.size;
        slope.segment<6>(6 * j) +=
            compliance(stand.links[static_cast<std::size_t>(j)], stand.size) * wrench;
    }
    for (Eigen::Index k = 0; k < feet; ++k)
        slope[6 * links + k] += found.feet[static_cast<std::size_t>(k)].dot(stand.up) /
                                stand.feet[static_cast<std::size_t>(k)].stiffness;
    for (std::size_t i = 0; i < members.size(); ++i) {
        const auto &[attachments, plate] = members[i];
        const auto signAt = [&](const MemberAttachment &at) {
            return at.kind == MemberAttachment::Kind::Foot ||
                           stand.links[static_cast<std::size_t>(at.index)].a == static_cast<int>(i)
                       ? 1.0
                       : -1.0;
        };
        Eigen::VectorXd wrenches = Eigen::VectorXd::Zero(plate.deflection.size());
        for (std::size_t n = 0; n < attachments.size(); ++n) {
            const MemberAttachment &at = attachments[n];
            const auto index = static_cast<std::size_t>(at.index);
            auto part = wrenches.segment<6>(6 * static_cast<Eigen::Index>(n));
            if (at.kind == MemberAttachment::Kind::Foot)
                part.head<3>() = found.feet[index];
            else
                part = signAt(at) * found.links[index];
        }
        const Eigen::VectorXd moves = plate.compliance * wrenches + plate.deflection;
        for (std::size_t n = 0; n < attachments.size(); ++n) {
            const MemberAttachment &at = attachments[n];
            const WrenchVector part = moves.segment<6>(6 * static_cast<Eigen::Index>(n));
            if (at.kind == MemberAttachment::Kind::Foot)
                slope[6 * links + at.index] += part.head<3>().dot(stand.up);
            else
                slope.segment<6>(6 * at.index) += signAt(at) * toUnknown(part);
        }
    }
    return slope;
}

} // namespace

class TestElasticSharing : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void rigidMembersShareByTheForceMethod();
    void linksLetGoByTheForceMethod();
    void noOtherForcesStoreLess();
    void whatHangsInARowIsCarried();
    void aRingThatFloatsIsNotBalanced();
};

void TestElasticSharing::rigidMembersShareByTheForceMethod()
{
    int standing = 0, lifted = 0;
    for (unsigned seed = 1; seed <= 80; ++seed) {
        StructureSource source(seed);
        Structure stand = source.stand(1 + source.upTo(6), source.upTo(3), 3 + source.upTo(2), 2);
        if (seed % 3 == 0)
            stand.loads.push_back({0, {30, 20, 30}, {0, -60, 0}, {5, 0, -9}});
        const auto oracle = forceMethod(stand);
        const auto found = elasticEquilibrium(stand, {});
        const std::string where = "seed " + std::to_string(seed);
        // Wrong: what topples has forces, or what stands has none.
        QVERIFY2(found && found->isBalanced() == oracle.has_value(), where.c_str());
        if (!oracle)
            continue;
        ++standing;
        lifted +=
            static_cast<int>(std::count(found->isLifted.begin(), found->isLifted.end(), true));
        // Wrong: a chain's wrench is turned round or moved on its way from link to link.
        const double off = differenceOf(*oracle, stand, *found);
        QVERIFY2(off < kAsDense, (where + ": " + std::to_string(off)).c_str());
        QVERIFY2(found->worstResidual < 1e-12, where.c_str());
    }
    QVERIFY(standing > 40);
    QVERIFY(lifted > 10);
}

void TestElasticSharing::linksLetGoByTheForceMethod()
{
    int parted = 0, lost = 0;
    for (unsigned seed = 200; seed < 260; ++seed) {
        StructureSource source(seed);
        const int members = 2 + source.upTo(2);
        Structure stand = source.stand(members, 4 - members, 3, 1);
        for (Link &link : stand.links)
            link.grip = source.upTo(1) == 0 ? 0.0 : source.between(0, 3);
        const auto oracle = forceMethod(stand, true);
        const auto found = elasticEquilibrium(stand, {});
        const std::string where = "seed " + std::to_string(seed);
        // Wrong: a joint holds more than its grip, also one whose force nothing can share.
        QVERIFY2(found && found->isBalanced() == oracle.has_value(), where.c_str());
        if (!oracle) {
            ++lost;
            continue;
        }
        const double off = differenceOf(*oracle, stand, *found);
        QVERIFY2(off < kAsDense, (where + ": " + std::to_string(off)).c_str());
        parted +=
            static_cast<int>(std::count(found->isParted.begin(), found->isParted.end(), true));
    }
    QVERIFY(parted >= 3);
    QVERIFY(lost >= 3);
}

void TestElasticSharing::noOtherForcesStoreLess()
{
    int shared = 0;
    for (unsigned seed = 300; seed < 360; ++seed) {
        StructureSource source(seed);
        const Structure stand =
            source.stand(1 + source.upTo(8), source.upTo(4), 3 + source.upTo(3), 2);
        const std::vector<MemberFlexibility> members = flexibilitiesFor(stand, source);
        const auto found = elasticEquilibrium(stand, members);
        QVERIFY(found.has_value());
        if (!found->isBalanced())
            continue;
        // Forces in equilibrium with nothing, feet in the air left there.
        const Eigen::MatrixXd matrix = equilibriumMatrix(stand);
        const auto links = 6 * static_cast<Eigen::Index>(stand.links.size());
        const auto feet = static_cast<Eigen::Index>(stand.feet.size());
        Eigen::MatrixXd held(matrix.rows() + feet, matrix.cols());
        held.setZero();
        held.topRows(matrix.rows()) = matrix;
        for (Eigen::Index k = 0; k < feet; ++k)
            if (found->isLifted[static_cast<std::size_t>(k)])
                held(matrix.rows() + k, links + k) = 1.0;
        const Eigen::VectorXd slope = slopeAt(*found, stand, members);
        Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver(held.transpose());
        const Eigen::VectorXd left = slope - held.transpose() * solver.solve(slope);
        // Wrong: sections give, and others carry less than they would.
        QVERIFY2(
            left.norm() <= 1e-8 * slope.norm(),
            (std::to_string(seed) + ": " + std::to_string(left.norm() / slope.norm())).c_str());
        shared += held.cols() > solver.rank() ? 1 : 0;
    }
    QVERIFY(shared > 20);
}

void TestElasticSharing::whatHangsInARowIsCarried()
{
    // Two stands, and between them a row of members that nothing else holds.
    Structure bridge;
    bridge.size = 300.0;
    for (const double x : {-150.0, 150.0}) {
        bridge.members.push_back({0.5, {x, 30, 0}});
        for (const Vec2 &foot : fourFeet(20.0))
            bridge.feet.push_back({x < 0.0 ? 0 : 1, {x + foot.x(), 0, foot.y()}, 1e4, true});
    }
    for (int i = 0; i < 5; ++i) {
        const double x = -100.0 + 50.0 * i;
        bridge.members.push_back({0.1, {x, 60, 0}});
        bridge.links.push_back(
            upright(i == 0 ? 0 : i + 1, i + 2, {x - 25.0, 50.0 + i, 3.0}, Vec3::UnitY()));
    }
    bridge.links.push_back(upright(1, 6, {125, 50, -2}, Vec3::UnitY()));
    bridge.members.push_back({0.2, {0, 90, 10}}); // on the middle one
    bridge.links.push_back(upright(7, 4, {0, 80, 5}, -Vec3::UnitY()));
    const auto solved = elasticEquilibrium(bridge, {}, FootHold::Pinned);
    QVERIFY(solved && solved->isBalanced());
    double sum = 0.0;
    for (const Vec3 &foot : solved->feet)
        sum += foot.y();
    // Wrong: weights on the way along a row are lost, or counted twice.
    QVERIFY(std::abs(sum - 1.7 * 9.81) < 1e-9);
    QVERIFY(std::abs(solved->links.back()[1] - 0.2 * 9.81) < 1e-12);
    QVERIFY(solved->worstResidual < 1e-12);
}

void TestElasticSharing::aRingThatFloatsIsNotBalanced()
{
    Structure ring;
    for (int i = 0; i < 3; ++i)
        ring.members.push_back({0.1, {30.0 * i, 20, 10.0 * (i % 2)}});
    for (int i = 0; i < 3; ++i)
        ring.links.push_back(
            upright(i, (i + 1) % 3, {30.0 * i + 15.0, 20, 5.0 * i}, Vec3::UnitY()));
    // Wrong: it goes round for ever, or what falls is in equilibrium.
    const auto falls = elasticEquilibrium(ring, {});
    QVERIFY(falls && !falls->isBalanced());
    ring.gravity.setZero();
    const auto floats = elasticEquilibrium(ring, {});
    QVERIFY(floats && floats->isBalanced());
    for (const WrenchVector &link : floats->links)
        QVERIFY(link.norm() < 1e-12);
}

FFF_TEST(TestElasticSharing)

#include "tst_elastic_sharing.moc"
