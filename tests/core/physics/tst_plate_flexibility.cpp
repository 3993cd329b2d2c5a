// How a plate gives where it is held, and how a wrench is passed on to it.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/physics/plate_flexibility.h"
#include "tests/core/physics/plate_samples.h"
#include "tests/test_program.h"

#include <Eigen/Eigenvalues>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

Region turnedRegion(Region region, double angle, const Vec2 &move)
{
    const Eigen::Rotation2Dd turn(angle);
    const auto apply = [&](Polygon &ring) {
        for (Vec2 &p : ring)
            p = turn * p + move;
    };
    apply(region.outer);
    for (Polygon &hole : region.holes)
        apply(hole);
    return region;
}

/// Two feet up, the joint down and a moment in it, across and in the plane: in equilibrium.
Eigen::VectorXd balanced(double angle)
{
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    turn.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(angle).toRotationMatrix();
    Eigen::VectorXd wrenches = Eigen::VectorXd::Zero(18);
    const Vec3 up(0.0, 1.0, 0.5);
    wrenches.segment<3>(6) = turn * up;
    wrenches.segment<3>(12) = turn * (2.0 * up);
    wrenches.segment<3>(0) = turn * (-3.0 * up);
    const Vec3 moment = Vec3(-55, -30, 0).cross(up) + Vec3(55, -30, 0).cross(2.0 * up);
    wrenches.segment<3>(3) = turn * -moment;
    return wrenches;
}

double strainEnergy(double angle, const Vec2 &move, double fineness = 1.0)
{
    const PlateModel model =
        modelOf(turnedRegion(slitPlate(), angle, move), kSixMillimetres, {}, fineness);
    const PlateFlexibility plate =
        plateFlexibility(model, holdsOf(model, angle, move), model.noField()).value();
    const Eigen::VectorXd wrenches = balanced(angle);
    return 0.5 * wrenches.dot(plate.compliance * wrenches);
}

} // namespace

class TestPlateFlexibility : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void pressuresAreTheWrench_data();
    void pressuresAreTheWrench();
    void flexibilityIsSymmetric();
    void flexibilityIsThatOfAnyPlace();
    void flexibilityConverges();
    void axisMomentIsHeldByTheFaces();
};

void TestPlateFlexibility::pressuresAreTheWrench_data()
{
    QTest::addColumn<int>("which");
    QTest::newRow("a slit") << 0;
    QTest::newRow("a slit whose partner has none") << 1;
    QTest::newRow("a foot at a corner") << 2;
    QTest::newRow("a weight") << 3;
    QTest::newRow("a slot") << 4;
    QTest::newRow("a foot drawn beside the plate") << 5;
    QTest::newRow("no depth at all") << 6;
}

void TestPlateFlexibility::pressuresAreTheWrench()
{
    QFETCH(int, which);
    const PlateModel model = modelOf(slitPlate(), kSixMillimetres);
    const Vec2 inner(60, 30), up(0, 1);
    const PlateAttachment attachment =
        which == 0   ? slitAttachment(model, {inner, up, 30.0, 6.0, 30.0, 6.0})
        : which == 1 ? slitAttachment(model, {inner, up, 30.0, 6.0, 0.0, 6.0})
        : which == 2 ? discAttachment(model, {0, 0}, 3.0)
        : which == 3 ? discAttachment(model, {90, 30}, 15.0)
        : which == 4 ? slotAttachment(model, {60, 45}, up, 30.0, 6.0)
        : which == 5 ? discAttachment(model, {50, -2}, 3.0)
                     : slitAttachment(model, {inner, up, 0.0, 6.0, 0.0, 6.0});
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    for (int k = 0; k < 20; ++k) {
        WrenchVector wrench;
        for (int i = 0; i < 6; ++i)
            wrench[i] = number(random) * (i < 3 ? 1.0 : 20.0);
        const Eigen::VectorXd forces = pressures(attachment, wrench);
        Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
        for (std::size_t i = 0; i < attachment.points.size(); ++i) {
            const PatchPoint &p = attachment.points[i];
            const Vec2 arm = p.point - attachment.about;
            const Vec3 there = forces[static_cast<Eigen::Index>(i)] * p.way;
            force += there;
            moment += Vec3(arm.x(), arm.y(), 0.0).cross(there);
        }
        // Wrong: what a joint passes on to a section is not what the joint carries.
        QVERIFY((force - wrench.head<3>()).norm() < 1e-9);
        QVERIFY((moment - wrench.tail<3>()).norm() < 1e-7);
    }
}

void TestPlateFlexibility::flexibilityIsSymmetric()
{
    const PlateModel model = modelOf(slitPlate(), kSixMillimetres);
    const PlateFlexibility plate =
        plateFlexibility(model, holdsOf(model, 0.0, {0, 0}), model.noField()).value();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(plate.compliance);
    // Wrong: a plate gives work back that nobody did: the energy has no least.
    QVERIFY((plate.compliance - plate.compliance.transpose()).norm() == 0.0);
    QVERIFY(eigen.eigenvalues()[0] > -1e-12 * eigen.eigenvalues()[17]);
    // Wrong: forces in its plane bend it, or it does not give at all.
    QVERIFY(plate.compliance(0, 2) == 0.0 && plate.compliance(1, 8) == 0.0);
    QVERIFY(plate.compliance.diagonal().minCoeff() > 0.0);
}

void TestPlateFlexibility::flexibilityIsThatOfAnyPlace()
{
    const double here = strainEnergy(0.0, {0, 0});
    for (const double angle : {0.4, 1.3, 3.0}) {
        // Wrong: how a section gives depends on how it lies on the paper.
        const double there = strainEnergy(angle, {500, -300});
        QVERIFY2(std::abs(there / here - 1.0) < 0.01, qPrintable(QString::number(there / here)));
    }
}

void TestPlateFlexibility::flexibilityConverges()
{
    const double coarse = strainEnergy(0.0, {0, 0}, 0.5), plain = strainEnergy(0.0, {0, 0}),
                 fine = strainEnergy(0.0, {0, 0}, 2.5);
    // Wrong: the answer is one of the mesh.
    QVERIFY2(std::abs(plain / fine - 1.0) < 0.02, qPrintable(QString::number(plain / fine)));
    QVERIFY2(std::abs(coarse / fine - 1.0) < 0.06, qPrintable(QString::number(coarse / fine)));
}

void TestPlateFlexibility::axisMomentIsHeldByTheFaces()
{
    const PlateModel model = modelOf(slitPlate(), kSixMillimetres);
    const PlateAttachment slit = slitAttachment(model, {{60, 30}, {0, 1}, 30.0, 6.0, 30.0, 6.0});
    const Eigen::VectorXd forces =
        pressures(slit, WrenchVector::Unit(4)); // about v: the slit's axis
    for (std::size_t i = 0; i < slit.points.size(); ++i) {
        // Wrong: a moment about the slit's axis is carried by the slit's walls, which are ten times
        // too soft for it, or beside the strip that the partner holds.
        if (std::abs(forces[static_cast<Eigen::Index>(i)]) < 1e-9)
            continue;
        QVERIFY(slit.points[i].way == Vec3::UnitZ());
        QVERIFY(slit.points[i].point.y() < 30.0);
        QVERIFY(std::abs(slit.points[i].point.x() - 60.0) <= 3.0 + 1e-9);
    }
    QVERIFY(forces.cwiseAbs().maxCoeff() > 1e-3);
}

FFF_TEST(TestPlateFlexibility)
#include "tst_plate_flexibility.moc"
