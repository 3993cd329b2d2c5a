// A mesh that leans a little is stood on its face.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/templates/mesh_facets.h"
#include "core/templates/stood_mesh.h"
#include "tests/core/templates/made_meshes.h"
#include "tests/test_program.h"

#include <algorithm>
#include <cmath>

using namespace fff;
using namespace fff::test;

namespace {

constexpr double kSide = 80.0; // mm
constexpr double kRounding = 1e-9;

MeshDraft leaning(MeshDraft draft, double degrees, const Vec3 &about)
{
    const Eigen::AngleAxisd turn(degrees * std::numbers::pi / 180.0, about.normalized());
    for (Vec3 &p : draft.positions)
        p = turn * p + Vec3(10.0, 200.0, -30.0);
    return draft;
}

/// Corners at the lowest height of all.
std::ptrdiff_t lowestCorners(const TriangleMesh &mesh)
{
    return std::count_if(mesh.positions().begin(), mesh.positions().end(), [&](const Vec3 &p) {
        return p.y() - mesh.bounds().min.y() < kRounding * kSide;
    });
}

} // namespace

class TestStoodMesh : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aLeaningBlockIsLevel_data();
    void aLeaningBlockIsLevel();
    void whatIsMeantToLeanStays();
    void aHollowIsNoFoot();
    void stoodOnceIsStood();
};

// Wrong: a box of sheets rocks on a corner, since simplifying has tilted its base.
void TestStoodMesh::aLeaningBlockIsLevel_data()
{
    QTest::addColumn<double>("degrees");
    QTest::addColumn<Vec3>("about");
    for (const double degrees : {0.01, 1.0, 6.0, 14.5})
        for (const Vec3 &about : {Vec3(1, 0, 0), Vec3(0, 0, -1), Vec3(1, 0, 2)})
            QTest::addRow("%g° about %g, %g", degrees, about.x(), about.z()) << degrees << about;
}

void TestStoodMesh::aLeaningBlockIsLevel()
{
    QFETCH(const double, degrees);
    QFETCH(const Vec3, about);
    const TriangleMeshPointer mesh = meshOf(leaning(cube(kSide), degrees, about));
    const TriangleMeshPointer stood = stoodOnFacet(*mesh);
    QVERIFY(stood);
    QCOMPARE(lowestCorners(*stood), std::ptrdiff_t(4));
    QVERIFY(std::abs(stood->volume() / mesh->volume() - 1.0) < kRounding);
    QVERIFY(std::abs(stood->bounds().min.y() - mesh->bounds().min.y()) < kRounding * kSide);
    const Vec3 away = stood->bounds().center() - mesh->bounds().center();
    QVERIFY(std::hypot(away.x(), away.z()) < kRounding * kSide);
    QVERIFY(stood->triangles() == mesh->triangles());
}

void TestStoodMesh::whatIsMeantToLeanStays()
{
    for (const double degrees : {16.0, 30.0, 45.0})
        QVERIFY(!stoodOnFacet(*meshOf(leaning(cube(kSide), degrees, Vec3::UnitX()))));
    QVERIFY(!stoodOnFacet(*meshOf(cube(kSide)))); // nothing to do
}

// Wrong: a stool is turned onto the underside of its seat, which its legs reach below.
void TestStoodMesh::aHollowIsNoFoot()
{
    MeshDraft stool = box({0.0, 100.0, 0.0}, {kSide, 110.0, kSide});
    append(stool, box({5.0, 0.0, 5.0}, {15.0, 90.0, 15.0}));
    const TriangleMeshPointer mesh = meshOf(leaning(stool, 5.0, Vec3::UnitX()));
    const TriangleMeshPointer stood = stoodOnFacet(*mesh);
    QVERIFY(stood);
    QCOMPARE(lowestCorners(*stood), std::ptrdiff_t(4)); // of the leg
}

void TestStoodMesh::stoodOnceIsStood()
{
    const TriangleMeshPointer stood =
        stoodOnFacet(*meshOf(leaning(cube(kSide), 7.0, Vec3(1.0, 0.0, 0.4))));
    QVERIFY(stood);
    if (const TriangleMeshPointer again = stoodOnFacet(*stood))
        for (std::size_t i = 0; i < stood->positions().size(); ++i)
            QVERIFY((again->positions()[i] - stood->positions()[i]).norm() < kRounding * kSide);
}

FFF_TEST(TestStoodMesh)
#include "tst_stood_mesh.moc"
