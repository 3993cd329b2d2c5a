// Which triangles a tree gives for a plane. If this fails, a cut has gaps.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/templates/mesh_tree.h"
#include "tests/core/templates/made_meshes.h"
#include "tests/test_program.h"

#include <random>

using namespace fff;
using namespace fff::test;

namespace {

/// Each face that meets a plane once, and none twice.
void findsAll(const MeshTree &tree, const TriangleMesh &mesh)
{
    std::mt19937 random(4);
    std::normal_distribution<double> direction;
    std::uniform_int_distribution<std::size_t> vertex(0, mesh.positions().size() - 1);
    for (int i = 0; i < 300; ++i) {
        Vec3 normal(direction(random), direction(random), direction(random));
        if (i % 4 == 0)
            normal = Vec3::Unit(i / 4 % 3);
        // Through a vertex, where only the exact side says that it is met.
        const CutPlane plane = makeCutPlane(mesh.positions()[vertex(random)], normal).value();
        std::vector<int> found(mesh.triangles().size(), 0);
        tree.meeting(plane, [&found](std::uint32_t face) { ++found[face]; });
        const PlaneSides sides(plane);
        for (std::size_t f = 0; f < found.size(); ++f) {
            QVERIFY(found[f] <= 1);
            int low = 1, high = -1;
            for (const std::uint32_t corner : mesh.triangles()[f]) {
                low = std::min(low, sides.of(mesh.positions()[corner]));
                high = std::max(high, sides.of(mesh.positions()[corner]));
            }
            if (low <= 0 && high >= 0)
                QVERIFY(found[f] == 1);
        }
    }
}

} // namespace

class TestMeshTree : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void allThatMeetAreFound_data();
    void allThatMeetAreFound();
    void movedVerticesAreFound_data() { allThatMeetAreFound_data(); }
    void movedVerticesAreFound();
    void costsWhatItMeets();
};

void TestMeshTree::allThatMeetAreFound_data()
{
    QTest::addColumn<MeshDraft>("draft");
    QTest::newRow("a cube") << cube(10.0);
    QTest::newRow("a sphere") << sphere(50.0, 20, 30);
    QTest::newRow("a flat sheet") << without(cube(10.0),
                                             [](const Vec3 &p) { return p.z() > -5.0; });
    QTest::newRow("far away") << moved(torus(3.0, 1.0, 20, 10), {1e7, -3e8, 2.5e9});
    MeshDraft mixed = sphere(1e-3, 10, 15);
    append(mixed, moved(sphere(1e5, 10, 15), {3e5, 0.0, 0.0}));
    QTest::newRow("a grain beside a mountain") << mixed;
    MeshDraft one;
    one.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    one.triangles = {{0, 1, 2}};
    QTest::newRow("one triangle") << one;
}

void TestMeshTree::allThatMeetAreFound()
{
    QFETCH(const MeshDraft, draft);
    const TriangleMeshPointer mesh = meshOf(draft);
    findsAll(MeshTree::make(*mesh).value(), *mesh);
}

// Wrong: guides of a mesh that magnets pull have gaps, or are those of the mesh before.
void TestMeshTree::movedVerticesAreFound()
{
    QFETCH(const MeshDraft, draft);
    const TriangleMeshPointer mesh = meshOf(draft);
    const MeshTree tree = MeshTree::make(*mesh).value();
    std::mt19937 random(8);
    std::uniform_real_distribution<double> way(-1.0, 1.0);
    TriangleMeshPointer last;
    for (const double much : {0.0, 0.001, 0.1, 3.0}) { // of the size of the mesh
        std::vector<Vec3> positions = mesh->positions();
        for (Vec3 &p : positions)
            p += much * mesh->size() * Vec3(way(random), way(random), way(random));
        last = std::make_shared<TriangleMesh>(std::move(positions), mesh->triangles());
        findsAll(tree.refitted(*last), *last);
    }
    // What a refitted one is refitted to does not hang on where it was before.
    const MeshTree there = tree.refitted(*last), back = there.refitted(*mesh);
    for (int axis = 0; axis < 3; ++axis) {
        const CutPlane plane{mesh->centroid(), Vec3::Unit(axis)};
        std::vector<std::uint32_t> once, again;
        tree.meeting(plane, [&once](std::uint32_t face) { once.push_back(face); });
        back.meeting(plane, [&again](std::uint32_t face) { again.push_back(face); });
        QCOMPARE(again, once);
    }
}

/// Counted, not timed.
void TestMeshTree::costsWhatItMeets()
{
    for (const int rows : {50, 100, 200}) {
        const TriangleMeshPointer mesh = meshOf(sphere(50.0, rows, 2 * rows));
        const MeshTree tree = MeshTree::make(*mesh).value();
        const CutPlane plane = makeCutPlane({1.0, 2.0, 3.0}, {1.0, 0.3, 0.2}).value();
        std::size_t visited = 0;
        tree.meeting(plane, [&visited](std::uint32_t) { ++visited; });
        // Along a ring there are some 4 rows' triangles; about them their leaves.
        QVERIFY2(visited < std::size_t(60 * rows), qPrintable(QString::number(visited)));
        QVERIFY(tree.bytes() < 12 * mesh->triangles().size());
        visited = 0;
        tree.meeting({{0.0, 0.0, 100.0}, Vec3::UnitZ()}, [&visited](std::uint32_t) { ++visited; });
        QCOMPARE(visited, std::size_t(0));
    }
}

FFF_TEST(TestMeshTree)
#include "tst_mesh_tree.moc"
