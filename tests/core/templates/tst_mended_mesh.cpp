// What is wrong with a mesh, by name. If this fails, a mesh that could be used is refused, or one
// is shown that is not what the file has, without a word.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/templates/plane_cut.h"
#include "tests/core/templates/made_meshes.h"
#include "tests/test_program.h"

#include <algorithm>
#include <limits>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

/// Every face with vertices of its own, as a file of loose triangles has them.
MeshDraft loose(const MeshDraft &draft)
{
    MeshDraft result;
    for (const Triangle &t : draft.triangles)
        result.triangles.push_back({addPoint(result, draft.positions[t[0]]),
                                    addPoint(result, draft.positions[t[1]]),
                                    addPoint(result, draft.positions[t[2]])});
    return result;
}

MeshReport oneShell()
{
    MeshReport report;
    report.shells = 1;
    return report;
}

} // namespace

class TestMendedMesh : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatIsInOrderStays();
    void whatIsFound_data();
    void whatIsFound();
    void mendingAgainFindsNothing();
    void faceByFaceTheRightWay();
    void measures();
    void nothingLeft();
    void stopped();
};

void TestMendedMesh::whatIsInOrderStays()
{
    for (const MeshDraft &draft : {sphere(10.0, 8, 12), torus(20.0, 5.0, 16, 8), cube(3.0)}) {
        const MendedMesh found = mended(draft).value();
        QCOMPARE(found.report, oneShell());
        QVERIFY(found.report.messages().empty());
        QCOMPARE(found.mesh->triangles().size(), draft.triangles.size());
        QCOMPARE(found.mesh->positions().size(), draft.positions.size());
        // From loose triangles the same comes.
        const MendedMesh again = mended(loose(draft)).value();
        QCOMPARE(again.report, oneShell());
        QCOMPARE(again.mesh->positions().size(), draft.positions.size());
        QVERIFY(again.mesh->volume() > 0.0);
    }
}

void TestMendedMesh::whatIsFound_data()
{
    QTest::addColumn<MeshDraft>("draft");
    QTest::addColumn<MeshReport>("expected");
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    MeshDraft draft = cube(10.0);
    MeshReport report = oneShell();

    draft.triangles.push_back({0, 1, 8});
    draft.triangles.push_back({kNoVertex, 1, 2});
    report.wrongIndices = 2;
    QTest::newRow("wrong indices") << draft << report;

    draft = cube(10.0);
    report = oneShell();
    draft.positions[0].x() = kNan;
    report.notFinite = 6;
    report.openEdges = 6;
    QTest::newRow("a vertex that is no number") << draft << report;
    draft.positions[0].x() = 1e300;
    QTest::newRow("a vertex beyond all measure") << draft << report;
    draft.positions[0].x() = -std::numeric_limits<double>::infinity();
    QTest::newRow("a vertex at infinity") << draft << report;

    draft = cube(10.0);
    report = oneShell();
    draft.positions.push_back({kNan, kNan, kNan});
    QTest::newRow("a bad vertex that no face has") << draft << report;

    draft.triangles.push_back({0, 0, 1});
    draft.triangles.push_back({3, 3, 3});
    report.degenerate = 2;
    QTest::newRow("faces with a corner twice") << draft << report;

    draft = cube(10.0);
    report = oneShell();
    const Triangle first = draft.triangles.front();
    draft.triangles.push_back({first[1], first[2], first[0]});
    report.duplicates = 1;
    QTest::newRow("a face twice") << draft << report;
    append(draft, cube(10.0));
    report.duplicates = 13;
    QTest::newRow("all faces twice and one three times") << draft << report;

    draft = cube(10.0);
    report = oneShell();
    draft.triangles.push_back({first[1], first[0], first[2]});
    draft.triangles.push_back({first[1], first[0], first[2]});
    report.duplicates = 2;
    report.flipped = 0;
    // Most of them look the other way; the cube then turns that one over.
    report.flipped = 1;
    QTest::newRow("a face once, and twice turned over") << draft << report;

    draft = sphere(10.0, 8, 12);
    report = oneShell();
    for (std::size_t f = 0; f < 20; ++f)
        std::swap(draft.triangles[3 * f][0], draft.triangles[3 * f][1]);
    report.flipped = 20;
    QTest::newRow("some faces look inwards") << draft << report;

    report = oneShell();
    report.wasInsideOut = true;
    QTest::newRow("inside out") << turnedOver(sphere(10.0, 8, 12)) << report;

    draft = cube(10.0);
    draft.triangles.pop_back();
    report = oneShell();
    report.openEdges = 3;
    QTest::newRow("a hole") << draft << report;

    report = oneShell();
    report.crowdedEdges = 1;
    QTest::newRow("an edge of four faces") << cubesAtAnEdge(10.0) << report;

    draft = cube(10.0);
    append(draft, box({5.0, -5.0, -5.0}, {15.0, 5.0, 5.0}));
    report.crowdedEdges = 5; // the diagonals of the wall agree
    QTest::newRow("a wall of two cubes stays for both") << draft << report;

    report = oneShell();
    report.openEdges = 90 * 2;
    report.oneSidedEdges = 1;
    QTest::newRow("a Möbius band") << moebiusBand(50.0, 20.0, 90) << report;

    draft = crossingBalls(10.0, 8, 12);
    report = {};
    report.shells = 2;
    QTest::newRow("two shells") << draft << report;
    append(draft, turnedOver(moved(sphere(1.0, 5, 8), {50.0, 0.0, 0.0})));
    report.shells = 3;
    QTest::newRow("a small shell inside out is let be") << draft << report;

    // A corner in the middle of a neighbour's edge, closed by a triangle without area.
    draft = {};
    draft.positions = {{0, 0, 0}, {2, 0, 0}, {1, 2, 0}, {1, 0, 0}, {1, 1, 2}};
    draft.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 4}, {3, 1, 4}, {1, 2, 4}, {2, 0, 4}};
    QTest::newRow("what closes a gap without an area stays") << draft << oneShell();
}

void TestMendedMesh::whatIsFound()
{
    QFETCH(const MeshDraft, draft);
    QFETCH(const MeshReport, expected);
    const MendedMesh found = mended(draft).value();
    const auto differs = [&](auto member, const char *name) {
        if (found.report.*member != expected.*member)
            qWarning("%s: %zu, expected %zu", name, std::size_t(found.report.*member),
                     std::size_t(expected.*member));
    };
    differs(&MeshReport::wrongIndices, "wrong indices");
    differs(&MeshReport::notFinite, "not finite");
    differs(&MeshReport::degenerate, "degenerate");
    differs(&MeshReport::duplicates, "duplicates");
    differs(&MeshReport::flipped, "flipped");
    differs(&MeshReport::openEdges, "open");
    differs(&MeshReport::crowdedEdges, "crowded");
    differs(&MeshReport::oneSidedEdges, "one-sided");
    differs(&MeshReport::shells, "shells");
    QVERIFY(found.report == expected);
    QCOMPARE(found.report.messages().empty(), found.report.isInOrder());
    for (const Vec3 &p : found.mesh->positions())
        QVERIFY(p.allFinite());
}

void TestMendedMesh::mendingAgainFindsNothing()
{
    std::mt19937 random(11);
    for (int round = 0; round < 200; ++round) {
        MeshDraft draft = round % 2 ? sphere(10.0, 6, 8) : cubesAtAnEdge(10.0);
        std::uniform_int_distribution<std::size_t> face(0, draft.triangles.size() - 1);
        std::uniform_int_distribution<std::uint32_t> vertex(
            0, static_cast<std::uint32_t>(draft.positions.size() + 2));
        for (int i = 0; i < 6; ++i) {
            Triangle &t = draft.triangles[face(random)];
            switch (random() % 4) {
            case 0:
                t[random() % 3] = vertex(random);
                break;
            case 1:
                std::swap(t[0], t[2]);
                break;
            case 2:
                draft.triangles.push_back(Triangle(t));
                break;
            default:
                t = draft.triangles[face(random)];
            }
        }
        const MendedMesh once = mended(draft).value();
        MeshDraft again;
        again.positions = once.mesh->positions();
        again.triangles = once.mesh->triangles();
        const MendedMesh twice = mended(again).value();
        QCOMPARE(twice.report.wrongIndices + twice.report.degenerate + twice.report.duplicates +
                     twice.report.flipped,
                 std::size_t(0));
        QCOMPARE(twice.report.openEdges, once.report.openEdges);
        QCOMPARE(twice.report.shells, once.report.shells);
        QVERIFY(twice.mesh->triangles() == once.mesh->triangles());
    }
}

/// However many of them were turned, as long as it is the smaller part.
void TestMendedMesh::faceByFaceTheRightWay()
{
    const double volume = meshOf(head(20, 30))->volume();
    std::mt19937 random(5);
    for (const double share : {0.05, 0.2, 0.45}) {
        MeshDraft draft = head(20, 30);
        std::size_t turned = 0;
        for (Triangle &t : draft.triangles)
            if (std::uniform_real_distribution<double>()(random) < share) {
                std::swap(t[1], t[2]);
                ++turned;
            }
        const MendedMesh found = mended(draft).value();
        QCOMPARE(found.report.flipped, turned);
        QVERIFY(std::abs(found.mesh->volume() - volume) < 1e-9 * volume);
    }
}

void TestMendedMesh::measures()
{
    const TriangleMeshPointer mesh = meshOf(moved(box({0, 0, 0}, {2, 4, 6}), {10, 20, 30}));
    QCOMPARE(mesh->size(), 6.0);
    QVERIFY(std::abs(mesh->volume() - 48.0) < 1e-9);
    QVERIFY(std::abs(mesh->area() - 88.0) < 1e-9);
    QVERIFY((mesh->centroid() - Vec3(11, 22, 33)).norm() < 1e-9);
    QVERIFY(!mesh->unit());
}

void TestMendedMesh::nothingLeft()
{
    QCOMPARE(mended({}).error().code, ErrorCode::BadValue);
    MeshDraft draft;
    draft.triangles = {{0, 1, 2}};
    QCOMPARE(mended(draft).error().code, ErrorCode::BadValue);
    draft.positions = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}};
    QCOMPARE(mended(draft).error().code, ErrorCode::BadValue);
}

void TestMendedMesh::stopped()
{
    std::stop_source source;
    source.request_stop();
    LongWork work;
    work.stop = source.get_token();
    QCOMPARE(mended(cube(1.0), work).error().code, ErrorCode::Cancelled);
    QCOMPARE(MeshTree::make(*meshOf(cube(1.0)), work).error().code, ErrorCode::Cancelled);
    std::vector<double> told;
    LongWork listening;
    listening.progress = [&told](double share) { told.push_back(share); };
    QVERIFY(mended(cube(1.0), listening));
    QVERIFY(told.size() > 2 && std::is_sorted(told.begin(), told.end()));
    QCOMPARE(told.back(), 1.0);
}

FFF_TEST(TestMendedMesh)
#include "tst_mended_mesh.moc"
