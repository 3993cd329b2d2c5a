#include "core/physics/link_stiffness.h"
#include "tests/core/physics/structures.h"
#include "tests/test_program.h"

#include <Eigen/Eigenvalues>
#include <QTest>

using namespace fff;
using namespace fff::test;

class TestLinkStiffness : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void byHand();
    void eachSlitTurnsItsOwnPlate();
    void freedAxis();
    void alwaysPositive_data();
    void alwaysPositive();
};

namespace {

Link plain()
{
    Link link = upright(0, 1, Vec3::Zero(), Vec3::UnitY());
    link.thicknessA = link.thicknessB = 6.0;
    return link;
}

} // namespace

// Wrong: a link is softer or stiffer than was measured.
void TestLinkStiffness::byHand()
{
    Link link = plain();
    const LinkSprings tight = linkSprings(link, false);
    QCOMPARE(tight.across(0, 0), 19200.0); // E t, N/mm
    QCOMPARE(tight.across(2, 2), 19200.0);
    QCOMPARE(tight.across(1, 1), 0.0);
    QCOMPARE(tight.along, 9600.0);
    QCOMPARE(tight.across(3, 3), 0.29 * 3200.0 * 6.0 * 625.0); // 3.5e6 N·mm/rad
    QCOMPARE(tight.across(5, 5), tight.across(3, 3));
    QCOMPARE(tight.across(4, 4), 0.15 * 3200.0 * 2.0 * 36.0 * 25.0);
    link.isTight = false;
    QCOMPARE(linkSprings(link, false).across(3, 3), 0.155 * 3200.0 * 6.0 * 625.0);
}

// Wrong: the deeper slit holds the other plate.
void TestLinkStiffness::eachSlitTurnsItsOwnPlate()
{
    Link link = plain(); // a's normal is x, b's is z
    link.depthA = 50.0;
    link.thicknessB = 3.0;
    const LinkStiffness across = linkSprings(link, false).across;
    QCOMPARE(across(3, 3), 0.29 * 3200.0 * 6.0 * 2500.0);
    QCOMPARE(across(5, 5), 0.29 * 3200.0 * 3.0 * 625.0);
    QCOMPARE(across(0, 0), 3200.0 * 3.0); // along a's normal press the walls of b
    QCOMPARE(across(2, 2), 3200.0 * 6.0);
}

// Wrong: what is free to turn resists, or something else is freed too.
void TestLinkStiffness::freedAxis()
{
    const Link link = StructureSource(3).link(0, 1);
    const LinkStiffness held = linkSprings(link, false).across;
    const LinkStiffness freed = linkSprings(link, true).across;
    QVERIFY((freed.bottomRightCorner<3, 3>() * link.axis).norm() < 1e-9 * held.norm());
    QVERIFY((held.bottomRightCorner<3, 3>() * link.axis).norm() > 1e3);
    QVERIFY(((held - freed) * (Eigen::Matrix<double, 6, 1>() << link.axis, link.normalA).finished())
                .norm() < 1e-9 * held.norm());
}

void TestLinkStiffness::alwaysPositive_data()
{
    QTest::addColumn<double>("angle");      // between the plates, degrees
    QTest::addColumn<double>("fromNormal"); // of the axis to a's plane, degrees
    QTest::addColumn<bool>("isSlot");
    QTest::newRow("square") << 90.0 << 0.0 << false;
    QTest::newRow("as oblique as joints are") << 10.0 << 0.0 << false;
    QTest::newRow("parallel") << 0.0 << 0.0 << false;
    QTest::newRow("a slot") << 90.0 << 0.0 << true;
    QTest::newRow("a slot, out along the plate's normal") << 90.0 << 90.0 << true;
}

// Wrong: a link that gives way in some direction by nothing but its frame.
void TestLinkStiffness::alwaysPositive()
{
    QFETCH(double, angle);
    QFETCH(double, fromNormal);
    QFETCH(bool, isSlot);
    constexpr double kDegree = std::numbers::pi / 180.0;
    Link link = plain();
    link.kind = isSlot ? LinkKind::Slot : LinkKind::Slits;
    link.depthA = 0.0; // and no depth to speak of
    link.normalB = Eigen::AngleAxisd(angle * kDegree, Vec3::UnitY()) * link.normalA;
    link.axis = Eigen::AngleAxisd(fromNormal * kDegree, -Vec3::UnitZ()) * Vec3::UnitY();
    const LinkSprings springs = linkSprings(link, false);
    LinkStiffness all = springs.across;
    all.topLeftCorner<3, 3>() += springs.along * link.axis * link.axis.transpose();
    QVERIFY((all - all.transpose()).norm() <= 1e-12 * all.norm());
    QVERIFY(Eigen::SelfAdjointEigenSolver<LinkStiffness>(all).eigenvalues().minCoeff() > 0.0);
    // Along its axis only that spring resists.
    QVERIFY((springs.across.topLeftCorner<3, 3>() * link.axis).norm() < 1e-9 * springs.along);
}

FFF_TEST(TestLinkStiffness)
#include "tst_link_stiffness.moc"
