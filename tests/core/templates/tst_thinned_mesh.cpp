// How meshes are shown: thinned for motion, smooth or with edges, and where a template has them
// cut.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/templates/template_cut.h"
#include "core/templates/template_mesh.h"
#include "core/templates/thinned_mesh.h"
#include "tests/core/templates/made_meshes.h"
#include "tests/test_program.h"

#include <numbers>

using namespace fff;
using namespace fff::test;

namespace {

TriangleMeshPointer shownMesh(const MeshDraft &draft)
{
    return mended(draft).value().mesh;
}

Template shownTemplate(const MeshDraft &draft, UpAxis up = UpAxis::Y, double size = 0.0)
{
    Template one;
    one.id = TemplateId{7};
    one.mesh = makeTemplateMesh(shownMesh(draft), {}).value();
    return stood(one, *one.mesh, up, size);
}

} // namespace

class TestThinnedMesh : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void fewerTrianglesOfTheSameForm();
    void smallOnesStay();
    void aBallIsSmoothAndACubeIsNot();
    void faceOrderAndManyFacesAtAPoint();
    void movedOnesAreTheSameElsewhere();
    void howAMeshComesIn();
    void cutsAreWhereTheTemplateIs();
};

void TestThinnedMesh::fewerTrianglesOfTheSameForm()
{
    for (const MeshDraft &draft :
         {sphere(50.0, 300, 500), head(300, 400), torus(60, 20, 400, 200)}) {
        const TriangleMeshPointer mesh = shownMesh(draft), coarse = thinned(mesh, 5000);
        QVERIFY(coarse->triangles().size() < 9000);
        QVERIFY(coarse->triangles().size() > 1500);
        QVERIFY(std::abs(coarse->volume() / mesh->volume() - 1.0) < 0.03);
        QVERIFY((coarse->bounds().size() - mesh->bounds().size()).norm() < 0.05 * mesh->size());
        for (const Triangle &t : coarse->triangles())
            for (const std::uint32_t vertex : t)
                QVERIFY(vertex < coarse->positions().size());
    }
}

void TestThinnedMesh::smallOnesStay()
{
    const TriangleMeshPointer mesh = shownMesh(cube(10.0));
    QCOMPARE(thinned(mesh, 12), mesh);
    QVERIFY(!thinned(mesh, 3)->triangles().empty());
}

void TestThinnedMesh::aBallIsSmoothAndACubeIsNot()
{
    const TriangleMeshPointer ball = shownMesh(sphere(50.0, 40, 60));
    const MeshSurface smooth = surfaceOf(*ball);
    QCOMPARE(smooth.corners.size(), ball->positions().size());
    for (const MeshSurface::Corner &corner : smooth.corners) {
        const Vec3 at(corner.position[0], corner.position[1], corner.position[2]);
        const Vec3 normal(corner.normal[0], corner.normal[1], corner.normal[2]);
        QVERIFY(std::abs(normal.norm() - 1.0) < 1e-5);
        QVERIFY(normal.dot(at.normalized()) > 0.99);
    }
    const TriangleMeshPointer box = shownMesh(cube(10.0));
    const MeshSurface sharp = surfaceOf(*box);
    QCOMPARE(sharp.corners.size(), std::size_t(24)); // three at each of eight
    for (const MeshSurface::Corner &corner : sharp.corners) {
        const Vec3 normal(corner.normal[0], corner.normal[1], corner.normal[2]);
        QVERIFY(std::abs(normal.cwiseAbs().maxCoeff() - 1.0) < 1e-6);
    }
}

void TestThinnedMesh::faceOrderAndManyFacesAtAPoint()
{
    // Every corner of every face is that vertex, whatever the normals; also where 400 faces meet.
    for (const MeshDraft &draft : {cube(10.0), sphere(50.0, 20, 400), head(30, 40)}) {
        const TriangleMeshPointer mesh = shownMesh(draft);
        const MeshSurface surface = surfaceOf(*mesh);
        const Vec3 middle = 0.5 * (mesh->bounds().min + mesh->bounds().max);
        QCOMPARE(surface.indices.size(), 3 * mesh->triangles().size());
        for (std::size_t f = 0; f < mesh->triangles().size(); ++f)
            for (std::size_t c = 0; c < 3; ++c) {
                const MeshSurface::Corner &corner = surface.corners.at(surface.indices[3 * f + c]);
                const Vec3 at(corner.position[0], corner.position[1], corner.position[2]);
                const Vec3 &wanted = mesh->positions()[mesh->triangles()[f][c]];
                QVERIFY((at + middle - wanted).norm() < 1e-3);
            }
    }
}

// Wrong: what a magnet pulls is drawn where it was, or comes apart into other corners.
void TestThinnedMesh::movedOnesAreTheSameElsewhere()
{
    const auto at = [](const MeshSurface::Corner &corner) {
        return Vec3(corner.position[0], corner.position[1], corner.position[2]);
    };
    for (const MeshDraft &draft : {cube(10.0), sphere(50.0, 20, 400), head(200, 300)}) {
        const TriangleMeshPointer mesh = shownMesh(draft);
        const TemplateMeshPointer whole = makeTemplateMesh(mesh, {}).value();
        // Turned, larger and elsewhere: surfaces that go along with the mesh.
        const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, 3).normalized());
        std::vector<Vec3> positions;
        for (const Vec3 &p : mesh->positions())
            positions.push_back(Vec3(3.0, -70.0, 11.0) + 1.5 * (turn * p));
        const TemplateMeshPointer moved =
            movedTemplateMesh(*whole, std::make_shared<TriangleMesh>(positions, mesh->triangles()))
                .value();
        for (const bool isCoarse : {false, true}) {
            const MeshSurface &was = isCoarse ? whole->coarse : whole->surface,
                              &is = isCoarse ? moved->coarse : moved->surface;
            QCOMPARE(is.indices, was.indices);
            QCOMPARE(is.corners.size(), was.corners.size());
            if (is.corners.empty())
                continue;
            for (std::size_t i = 0; i < is.corners.size(); ++i) {
                const Vec3 way = at(is.corners[i]) - at(is.corners[0]);
                const Vec3 before = at(was.corners[i]) - at(was.corners[0]);
                QVERIFY((way - 1.5 * (turn * before)).norm() < 1e-4 * mesh->size());
                const auto &n = is.corners[i].normal, &m = was.corners[i].normal;
                const Vec3 normal(n[0], n[1], n[2]), wanted = turn * Vec3(m[0], m[1], m[2]);
                // Of creases their own faces only: elsewhere it is the very normal.
                QVERIFY(normal.norm() == 0.0 || normal.dot(wanted) > std::cos(kCreaseAngle));
            }
        }
        QVERIFY(moved->coarse.corners.empty() == (mesh->triangles().size() <= kCoarseTriangles));
        // In place, the surface of one without creases is what it was.
        if (whole->surface.corners.size() == mesh->positions().size()) {
            const MeshSurface same = movedSurface(whole->surface, *mesh);
            for (std::size_t i = 0; i < same.corners.size(); ++i)
                for (std::size_t k = 0; k < 3; ++k) {
                    QCOMPARE(same.corners[i].position[k], whole->surface.corners[i].position[k]);
                    QVERIFY(std::abs(same.corners[i].normal[k] -
                                     whole->surface.corners[i].normal[k]) < 1e-5F);
                }
        }
    }
}

void TestThinnedMesh::howAMeshComesIn()
{
    const MeshDraft tall = moved(box({0, 0, 0}, {10, 20, 40}), {500, 600, 700});
    const Template asIs = shownTemplate(tall);
    Box3 box = worldBounds(asIs, *asIs.mesh);
    QVERIFY(std::abs(box.size().z() - kTemplateSize) < 1e-9); // no unit is known
    QVERIFY(std::abs(box.min.y()) < 1e-9);
    QVERIFY(std::abs(box.min.x() + box.max.x()) < 1e-9);
    const Template upright = shownTemplate(tall, UpAxis::Z, 80.0);
    box = worldBounds(upright, *upright.mesh);
    QVERIFY((box.size() - Vec3(20, 80, 40)).norm() < 1e-9);
    QVERIFY(std::abs(box.min.y()) < 1e-9);
    // What the file's z points to is up, and nothing is mirrored.
    QVERIFY((upright.placement().turn * Vec3::UnitZ() - Vec3::UnitY()).norm() < 1e-12);
    QVERIFY(upright.placement().turn.determinant() > 0.0);
    MeshDraft known = tall;
    known.unit = 1.0;
    const Template sized = shownTemplate(known);
    QVERIFY((worldBounds(sized, *sized.mesh).size() - Vec3(10, 20, 40)).norm() < 1e-9);
}

// Wrong: guides would be beside the mesh that is seen, or run the wrong way round.
void TestThinnedMesh::cutsAreWhereTheTemplateIs()
{
    Template one = shownTemplate(torus(60, 20, 200, 120), UpAxis::Z, 160.0);
    one.frame = makeFrame({30, 40, -10}, {0.8, 0.6, 0}, {0, 0.6, 0.8}).value();
    for (const bool isFlipped : {false, true}) {
        one.isFlipped = isFlipped;
        // Across its axis, through the middle: a ring.
        const Vec3 axis = one.frame.normal();
        const Frame frame =
            makeFrame(one.frame.origin, {0.1, 1, 0.3}, axis.cross(Vec3(1, 2, 3))).value();
        const Frame across = makeFrame(one.frame.origin, axis.cross(Vec3(1, 2, 3)),
                                       axis.cross(axis.cross(Vec3(1, 2, 3))))
                                 .value();
        const std::vector<TemplateLoop> ring = loopsOn(across, one, *one.mesh);
        QCOMPARE(ring.size(), std::size_t(2));
        QVERIFY(!ring[0].isHole && ring[1].isHole);
        const double pi = std::numbers::pi;
        QVERIFY(std::abs(signedArea(ring[0].points) / (pi * 6400) - 1.0) < 0.01);
        QVERIFY(std::abs(signedArea(ring[1].points) / (-pi * 1600) - 1.0) < 0.01);
        for (const Vec2 &p : ring[0].points)
            QVERIFY(std::abs(p.norm() - 80.0) < 0.1);
        // Any other plane: what is cut lies on the torus as it stands there.
        for (const TemplateLoop &loop : loopsOn(frame, one, *one.mesh)) {
            QVERIFY(!loop.isBridged);
            for (const Vec2 &p : loop.points) {
                const Vec3 at = frame.toWorld(p) - one.frame.origin;
                const double high = at.dot(axis), out = (at - high * axis).norm();
                QVERIFY(std::abs(std::hypot(out - 60.0, high) - 20.0) < 0.1);
            }
            QVERIFY(curveOf(loop));
        }
    }
}

FFF_TEST(TestThinnedMesh)
#include "tst_thinned_mesh.moc"
