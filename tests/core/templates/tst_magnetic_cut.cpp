// What is drawn to sections. If this fails, a template tears where a magnet ends, or its outline is
// beside the section that it was drawn to.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/templates/magnetic_cut.h"
#include "core/templates/placed_mesh.h"
#include "core/templates/vertex_normals.h"
#include "tests/core/templates/made_meshes.h"
#include "tests/test_program.h"

#include <random>

using namespace fff;
using namespace fff::test;

namespace {

MagneticPlane magnet(const Vec3 &origin, const Vec3 &normal, double reach)
{
    return {makeCutPlane(origin, normal).value(), reach};
}

std::vector<Vec3> drawn(const TriangleMesh &mesh, const std::vector<MagneticPlane> &planes)
{
    return magneticCut(mesh, vertexNormals(mesh), planes)->positions();
}

} // namespace

class TestMagneticCut : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theWeight();
    void whatIsFarStays();
    void theOutlineLiesOnThePlane();
    void nothingTears();
    void severalPlanes();
    void turnedTheSame();
    void normalsOfAnySurface();
    void placing();
};

void TestMagneticCut::theWeight()
{
    QCOMPARE(magneticWeight(0.0), 1.0);
    QCOMPARE(magneticWeight(kFirmReach), 1.0);
    QCOMPARE(magneticWeight(1.0), 0.0);
    QCOMPARE(magneticWeight(5.0), 0.0);
    double before = 1.0;
    for (double d = 0.0; d < 1.2; d += 1e-4) {
        const double weight = magneticWeight(d);
        QVERIFY(weight <= before && before - weight < 1e-3);
        before = weight;
    }
    // It leaves both ends smoothly.
    QVERIFY(1.0 - magneticWeight(kFirmReach + 1e-4) < 1e-5 && magneticWeight(1.0 - 1e-4) < 1e-5);
}

void TestMagneticCut::whatIsFarStays()
{
    const TriangleMeshPointer mesh = meshOf(head(40, 60));
    const MagneticPlane plane = magnet({0, 0, 10}, {0.2, -0.1, 1.0}, 12.0);
    const std::vector<Vec3> positions = drawn(*mesh, {plane});
    int moved = 0;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const bool isFar = std::abs(plane.plane.height(mesh->positions()[i])) >= plane.reach;
        if (isFar)
            QVERIFY(positions[i] == mesh->positions()[i]);
        // Along the normal only.
        const Vec3 way = positions[i] - mesh->positions()[i];
        QVERIFY((way - way.dot(plane.plane.normal) * plane.plane.normal).norm() < 1e-12);
        moved += way.norm() > 1e-6 ? 1 : 0;
    }
    QVERIFY(moved > 100);
    QVERIFY(drawn(*mesh, {}) == mesh->positions());
}

/// Of a ball beside the plane, the ring that looks across it; what faces it keeps its distance.
void TestMagneticCut::theOutlineLiesOnThePlane()
{
    const TriangleMeshPointer mesh = meshOf(sphere(50.0, 40, 60));
    const double reach = 40.0;
    for (const double height : {-20.0, 0.0, 15.0, 31.0}) {
        const MagneticPlane plane = magnet({3, 4, height}, {0, 0, 1}, reach);
        const std::vector<Vec3> normals = vertexNormals(*mesh);
        const std::vector<Vec3> positions =
            magneticCut(*mesh, normals, std::span(&plane, 1))->positions();
        int found = 0;
        for (std::size_t i = 0; i < positions.size(); ++i) {
            if (std::abs(mesh->positions()[i].z()) > 1e-9)
                continue;
            ++found;
            QVERIFY(std::abs(positions[i].z() - height) < 1e-9);
        }
        QCOMPARE(found, 60);
        // By the formula: a place firmly held goes to where its normal says.
        for (std::size_t i = 0; i < positions.size(); ++i)
            if (std::abs(mesh->positions()[i].z() - height) < kFirmReach * reach)
                QVERIFY(std::abs(positions[i].z() - height - normals[i].z() * reach) < 1e-9);
    }
}

/// Places that are near stay near, across the end of the reach as well.
void TestMagneticCut::nothingTears()
{
    MeshDraft strip; // a wall that goes on through it
    constexpr int kSteps = 4000;
    for (int i = 0; i <= kSteps; ++i)
        for (const double y : {0.0, 1.0})
            addPoint(strip, {0.0, y, -20.0 + 40.0 * i / kSteps});
    for (std::uint32_t i = 0; i < kSteps; ++i)
        addQuad(strip, 2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2);
    const TriangleMeshPointer mesh = meshOf(strip);
    const std::vector<Vec3> positions =
        drawn(*mesh, {magnet(Vec3::Zero(), {0.1, 0, 1}, 10.0), magnet({0, 0, 6}, {0, 0, 1}, 8.0)});
    double widest = 0.0;
    for (const Triangle &t : mesh->triangles())
        for (std::size_t i = 0; i < 3; ++i)
            widest =
                std::max(widest, std::abs(positions[t[i]].z() - positions[t[(i + 1) % 3]].z()));
    // A hundredth apart before; the steepest weight moves ten millimetres within two.
    QVERIFY2(widest < 0.12, qPrintable(QString::number(widest)));
}

void TestMagneticCut::severalPlanes()
{
    const TriangleMeshPointer mesh = meshOf(head(30, 45));
    const MagneticPlane a = magnet({0, 0, 10}, {0, 0.1, 1}, 15.0);
    const MagneticPlane far = magnet({0, 0, -40}, {0, 0, 1}, 5.0);
    // The same plane twice draws as once, also seen from behind.
    const MagneticPlane back = magnet({0, 0, 10}, {0, -0.1, -1}, 15.0);
    const std::vector<Vec3> once = drawn(*mesh, {a}), twice = drawn(*mesh, {a, back}),
                            both = drawn(*mesh, {a, far}), other = drawn(*mesh, {far});
    for (std::size_t i = 0; i < once.size(); ++i) {
        QVERIFY((once[i] - twice[i]).norm() < 1e-9);
        // Those that have nothing in common work by themselves.
        const Vec3 &p = mesh->positions()[i];
        QVERIFY((both[i] - p - (once[i] - p) - (other[i] - p)).norm() < 1e-9);
    }
}

void TestMagneticCut::turnedTheSame()
{
    std::mt19937 random(6);
    std::normal_distribution<double> direction;
    const MeshDraft draft = torus(30.0, 12.0, 40, 20);
    for (int round = 0; round < 20; ++round) {
        const Eigen::Quaterniond turn = Eigen::Quaterniond(direction(random), direction(random),
                                                           direction(random), direction(random))
                                            .normalized();
        MeshDraft turned = draft;
        for (Vec3 &p : turned.positions)
            p = turn * p;
        const Vec3 origin(5, 3, 2), normal(1, 2, 0.5);
        const TriangleMeshPointer mesh = meshOf(draft), other = meshOf(turned);
        const std::vector<Vec3> here = drawn(*mesh, {magnet(origin, normal, 9.0)});
        const std::vector<Vec3> there = drawn(*other, {magnet(turn * origin, turn * normal, 9.0)});
        for (std::size_t i = 0; i < here.size(); ++i)
            QVERIFY((turn * here[i] - there[i]).norm() < 1e-6);
    }
}

void TestMagneticCut::normalsOfAnySurface()
{
    // At a cube's corner by the angles, whatever diagonals its faces have.
    const TriangleMeshPointer mesh = meshOf(cube(2.0));
    const std::vector<Vec3> normals = vertexNormals(*mesh);
    for (std::size_t i = 0; i < normals.size(); ++i)
        QVERIFY((normals[i] - mesh->positions()[i].normalized()).norm() < 1e-12);
    const TriangleMeshPointer ball = meshOf(sphere(10.0, 30, 40));
    const std::vector<Vec3> round = vertexNormals(*ball);
    for (std::size_t i = 0; i < round.size(); ++i)
        QVERIFY((round[i] - ball->positions()[i].normalized()).norm() < 0.02);
}

void TestMagneticCut::placing()
{
    const TriangleMeshPointer mesh = meshOf(moved(box({0, 0, 0}, {1, 2, 4}), {7, 8, 9}));
    const TriangleMeshPointer placed = placedMesh(*mesh);
    QCOMPARE(placed->size(), kTemplateSize);
    QCOMPARE(placed->bounds().min.y(), 0.0);
    QVERIFY(std::abs(placed->bounds().center().x()) < 1e-9);
    QVERIFY(std::abs(placed->bounds().center().z()) < 1e-9);
    QVERIFY((placed->bounds().size() - 63.5 * Vec3(1, 2, 4)).norm() < 1e-9);
}

FFF_TEST(TestMagneticCut)
#include "tst_magnetic_cut.moc"
