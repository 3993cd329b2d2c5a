// Planes through meshes whose cuts are known. If this fails, a guide has gaps, a hole is filled, or
// a plane through a corner finds something else than one beside it.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/templates/plane_cut.h"
#include "tests/core/templates/made_meshes.h"
#include "tests/test_program.h"

#include <algorithm>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

PlaneCut cutOf(const MeshDraft &draft, const Vec3 &origin, const Vec3 &normal)
{
    return planeCut(*meshOf(draft), makeCutPlane(origin, normal).value());
}

double signedArea(const CutLoop &loop, const Vec3 &normal)
{
    Vec3 twice = Vec3::Zero();
    for (std::size_t i = 1; i + 1 < loop.points.size(); ++i)
        twice += (loop.points[i] - loop.points[0]).cross(loop.points[i + 1] - loop.points[0]);
    return 0.5 * twice.dot(normal);
}

/// "2 loops, 1 hole": what most of these are about.
QString shapeOf(const PlaneCut &cut)
{
    const auto holes = std::count_if(cut.loops.begin(), cut.loops.end(),
                                     [](const CutLoop &loop) { return loop.isHole; });
    return QStringLiteral("%1/%2").arg(std::ssize(cut.loops) - holes).arg(holes);
}

bool isNear(double a, double b, double error = 1e-9)
{
    return std::abs(a - b) <= error * std::max({1.0, std::abs(a), std::abs(b)});
}

const Vec3 kUp = Vec3::UnitZ();

} // namespace

class TestPlaneCut : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void knownCuts_data();
    void knownCuts();
    void loopsRunAsTheyShould();
    void theOtherWayIsTheSame();
    void treeAndScanAgree();
    void farAwayIsTheSame();
    void openChainsAreClosedNearestFirst();
    void aCrackIsClosedStraight();
    void bridgesLeaveSmoothly();
    void loopsWithBridgesStayApart();
    void surfacesWithoutAnInside();
    void facesThatDoNotAgree();
    void exactSides();
    void planesThatAreNone();
};

void TestPlaneCut::knownCuts_data()
{
    QTest::addColumn<MeshDraft>("draft");
    QTest::addColumn<Vec3>("origin");
    QTest::addColumn<Vec3>("normal");
    QTest::addColumn<QString>("shape"); // loops / holes
    QTest::addColumn<double>("area");
    const auto row = [](const char *name, const MeshDraft &draft, const Vec3 &origin,
                        const Vec3 &normal, const char *shape, double area) {
        QTest::newRow(name) << draft << origin << normal << QString::fromLatin1(shape) << area;
    };
    const MeshDraft ten = box({0.0, 0.0, 0.0}, {10.0, 10.0, 10.0});
    const Vec3 zero = Vec3::Zero();
    row("the middle of a cube", ten, {0.0, 0.0, 5.0}, kUp, "1/0", 100.0);
    row("along its top", ten, {0.0, 0.0, 10.0}, kUp, "1/0", 100.0);
    row("along its foot", ten, zero, kUp, "1/0", 100.0);
    row("along its foot, from below", ten, zero, -kUp, "1/0", 100.0);
    row("above it", ten, {0.0, 0.0, 10.0000001}, kUp, "0/0", 0.0);
    row("along two edges", ten, {0.0, 0.0, 10.0}, {1.0, 0.0, 1.0}, "1/0", 100.0 * std::sqrt(2.0));
    row("touching an edge", ten, zero, {1.0, 0.0, 1.0}, "0/0", 0.0);
    row("touching a corner", ten, zero, {1.0, 1.0, 1.0}, "0/0", 0.0);
    row("six corners of a hexagon", ten, {5.0, 5.0, 5.0}, {1.0, 1.0, 1.0}, "1/0",
        0.75 * std::sqrt(3.0) * 100.0);
    row("through three corners", ten, {10.0, 0.0, 0.0}, {1.0, 1.0, 1.0}, "1/0",
        50.0 * std::sqrt(3.0));
    MeshDraft step = ten;
    append(step, box({2.0, 2.0, 10.0}, {8.0, 8.0, 20.0}));
    row("at a step the wider part", step, {0.0, 0.0, 10.0}, kUp, "1/0", 100.0);
    row("at a step, from above", step, {0.0, 0.0, 10.0}, -kUp, "1/0", 100.0);
    row("two cubes at an edge", cubesAtAnEdge(10.0), {0.0, 0.0, 3.0}, kUp, "2/0", 200.0);
    row("along that edge", cubesAtAnEdge(10.0), zero, {1.0, -1.0, 0.0}, "1/0",
        200.0 * std::sqrt(2.0));
    MeshDraft room = ten;
    append(room, turnedOver(box({2.0, 2.0, 2.0}, {8.0, 8.0, 8.0})));
    row("a hollow cube", room, {0.0, 0.0, 5.0}, kUp, "1/1", 64.0);
    row("along the ceiling of the hollow", room, {0.0, 0.0, 8.0}, kUp, "1/0", 100.0);
    append(room, box({4.0, 4.0, 4.0}, {6.0, 6.0, 6.0}));
    row("something in the hollow", room, {0.0, 0.0, 5.0}, kUp, "2/1", 68.0);
    MeshDraft solid = ten;
    append(solid, box({2.0, 2.0, 2.0}, {8.0, 8.0, 8.0}));
    row("a solid in a solid is no hole and no other piece", solid, {0.0, 0.0, 5.0}, kUp, "1/0",
        100.0);
    MeshDraft crossing = ten;
    append(crossing, box({5.0, 3.0, 1.0}, {15.0, 13.0, 11.0}));
    row("cubes that run over into each other are one", crossing, {0.0, 0.0, 5.0}, kUp, "1/0",
        165.0);
    append(crossing, box({-5.0, 2.0, 1.0}, {-2.0, 4.0, 9.0}));
    row("what is apart from these stays so", crossing, {0.0, 0.0, 5.0}, kUp, "2/0", 171.0);
    MeshDraft frame = crossing;
    append(frame, box({-4.0, 3.0, 1.0}, {-3.0, 12.5, 9.0}));
    append(frame, box({-4.0, 12.0, 1.0}, {6.0, 12.5, 9.0}));
    append(frame, box({-3.5, 3.0, 1.0}, {1.0, 3.5, 9.0}));
    row("around a hole", frame, {0.0, 0.0, 5.0}, kUp, "1/1", 184.5);
    MeshDraft filled = ten;
    append(filled, turnedOver(box({2.0, 2.0, 2.0}, {8.0, 8.0, 8.0})));
    append(filled, box({1.0, 1.0, 1.0}, {9.0, 5.0, 9.0}));
    row("a hole that another solid fills in part", filled, {0.0, 0.0, 5.0}, kUp, "1/1", 82.0);
    MeshDraft wall = ten; // two faces on the wall, each of another cube
    append(wall, box({10.0, 0.0, 0.0}, {20.0, 10.0, 10.0}));
    row("cubes that share a wall are one", wall, {0.0, 0.0, 5.0}, kUp, "1/0", 200.0);
    row("along the wall they share", wall, {10.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, "1/0", 100.0);
    const double side = std::numbers::pi / 200; // of 400 corners around
    const auto ring = [side](double radius) { return 200.0 * radius * radius * std::sin(side); };
    row("a torus across its axis", torus(30.0, 10.0, 400, 40), zero, kUp, "1/1",
        ring(40.0) - ring(20.0));
    row("a torus along its axis", torus(30.0, 10.0, 40, 400), zero, {1.0, 0.0, 0.0}, "2/0",
        2.0 * ring(10.0));
}

void TestPlaneCut::knownCuts()
{
    QFETCH(const MeshDraft, draft);
    QFETCH(const Vec3, origin);
    QFETCH(const Vec3, normal);
    QFETCH(const QString, shape);
    QFETCH(const double, area);
    const PlaneCut cut = cutOf(draft, origin, normal);
    QCOMPARE(shapeOf(cut), shape);
    QVERIFY2(isNear(cut.area(), area), qPrintable(QString::number(cut.area(), 'g', 12)));
    QVERIFY(cut.messages().empty());
    for (const CutLoop &loop : cut.loops) {
        QVERIFY(loop.isClosed());
        for (std::size_t i = 0; i < loop.points.size(); ++i)
            QVERIFY(loop.points[i] != loop.points[(i + 1) % loop.points.size()]);
    }
}

void TestPlaneCut::loopsRunAsTheyShould()
{
    MeshDraft room = sphere(20.0, 20, 30);
    append(room, turnedOver(sphere(12.0, 20, 30)));
    std::mt19937 random(7);
    std::normal_distribution<double> direction;
    for (int i = 0; i < 100; ++i) {
        const Vec3 normal(direction(random), direction(random), direction(random));
        const PlaneCut cut = cutOf(room, Vec3::Constant(2.0), normal);
        QCOMPARE(shapeOf(cut), QStringLiteral("1/1"));
        QVERIFY(signedArea(cut.loops[0], cut.plane.normal) > 0.0);
        QVERIFY(signedArea(cut.loops[1], cut.plane.normal) < 0.0);
    }
}

void TestPlaneCut::theOtherWayIsTheSame()
{
    const TriangleMeshPointer mesh = meshOf(head(40, 60));
    for (const double height : {-20.0, 0.0, 3.0, 17.0}) {
        const CutPlane plane = makeCutPlane({0.0, 0.0, height}, {0.2, 0.1, 1.0}).value();
        const PlaneCut cut = planeCut(*mesh, plane);
        const PlaneCut other = planeCut(*mesh, {plane.origin, -plane.normal});
        QVERIFY(cut.area() > 100.0);
        QVERIFY(isNear(cut.area(), other.area()));
        QCOMPARE(cut.loops.size(), other.loops.size());
    }
}

void TestPlaneCut::treeAndScanAgree()
{
    const TriangleMeshPointer mesh = meshOf(crossingBalls(30.0, 30, 40));
    const MeshTree tree = MeshTree::make(*mesh).value();
    std::mt19937 random(8);
    std::normal_distribution<double> direction;
    for (int i = 0; i < 200; ++i) {
        const CutPlane plane =
            makeCutPlane(mesh->positions()[std::size_t(17 * i) % mesh->positions().size()],
                         {direction(random), direction(random), direction(random)})
                .value();
        const PlaneCut scanned = planeCut(*mesh, plane), found = planeCut(*mesh, plane, &tree);
        QCOMPARE(found.loops.size(), scanned.loops.size());
        for (std::size_t l = 0; l < found.loops.size(); ++l)
            QVERIFY(found.loops[l].points == scanned.loops[l].points);
    }
}

/// Coordinates with few digits left, as of a plan in a country's grid.
void TestPlaneCut::farAwayIsTheSame()
{
    const Vec3 away(4.5e6, -3.25e6, 1.75e5);
    const MeshDraft near = torus(30.0, 10.0, 60, 30);
    for (int i = 0; i < 20; ++i) {
        const Vec3 normal(std::sin(i), std::cos(3.0 * i), 0.2 * i - 1.0);
        const PlaneCut here = cutOf(near, Vec3(1.0, 2.0, 3.0), normal);
        const PlaneCut there = cutOf(moved(near, away), away + Vec3(1.0, 2.0, 3.0), normal);
        QCOMPARE(there.loops.size(), here.loops.size());
        QVERIFY(isNear(there.area(), here.area(), 1e-6));
        QCOMPARE(there.bridges(), std::size_t(0));
    }
}

void TestPlaneCut::openChainsAreClosedNearestFirst()
{
    // A tube of two halves with a narrow and a wide gap between them: two chains, of which the
    // ends at the narrow gap are joined first, then those at the wide one.
    const MeshDraft tube = without(torus(100.0, 10.0, 200, 40), [](const Vec3 &p) {
        const double around = std::atan2(p.z(), std::hypot(p.x(), p.y()) - 100.0);
        return std::abs(around) < 0.2 || std::abs(around) > 2.5;
    });
    const PlaneCut cut = cutOf(tube, Vec3::Zero(), {0.0, 1.0, 0.0});
    QCOMPARE(shapeOf(cut), QStringLiteral("2/0")); // one on each side of the axis
    QCOMPARE(cut.bridges(), std::size_t(4));
    QCOMPARE(cut.messages().size(), std::size_t(1));
    QCOMPARE(*cut.messages().front().count, 4);
    for (const CutLoop &loop : cut.loops) {
        QVERIFY(!loop.isClosed());
        QVERIFY(isNear(loop.area, std::numbers::pi * 100.0, 0.05));
    }
}

void TestPlaneCut::aCrackIsClosedStraight()
{
    // Two halves of a box that miss each other by a nanometre.
    MeshDraft draft = without(box({0.0, 0.0, 0.0}, {10.0, 10.0, 10.0}),
                              [](const Vec3 &p) { return p.x() > 9.0; });
    append(draft, without(box({1e-6, 0.0, 0.0}, {10.000001, 10.0, 10.0}),
                          [](const Vec3 &p) { return p.x() < 9.0; }));
    const PlaneCut cut = cutOf(draft, {0.0, 0.0, 5.0}, kUp);
    QCOMPARE(shapeOf(cut), QStringLiteral("1/0"));
    QCOMPARE(cut.bridges(), std::size_t(2));
    QVERIFY(isNear(cut.area(), 100.0, 1e-5));
    for (const CutLoop::Bridge &bridge : cut.loops.front().bridges)
        QCOMPARE(bridge.chords, std::size_t(1));
}

void TestPlaneCut::bridgesLeaveSmoothly()
{
    const MeshDraft cup = without(sphere(50.0, 60, 90), [](const Vec3 &p) { return p.z() > 25.0; });
    const PlaneCut cut = cutOf(cup, Vec3::Zero(), {0.0, 1.0, 0.0});
    QCOMPARE(shapeOf(cut), QStringLiteral("1/0"));
    QCOMPARE(cut.bridges(), std::size_t(1));
    const std::vector<Vec3> &points = cut.loops.front().points;
    double sharpest = 1.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3 in = points[i] - points[(i + points.size() - 1) % points.size()];
        const Vec3 out = points[(i + 1) % points.size()] - points[i];
        sharpest = std::min(sharpest, in.normalized().dot(out.normalized()));
    }
    QVERIFY2(std::acos(sharpest) < 0.25, qPrintable(QString::number(std::acos(sharpest))));
    // It bulges on as the ball does, not flat from edge to edge.
    const double top =
        std::max_element(points.begin(), points.end(), [](const Vec3 &a, const Vec3 &b) {
            return a.z() < b.z();
        })->z();
    QVERIFY(top > 35.0 && top < 50.0);
}

/// A guess takes away nothing that is known.
void TestPlaneCut::loopsWithBridgesStayApart()
{
    MeshDraft draft = box({0.0, 0.0, 0.0}, {10.0, 10.0, 10.0});
    std::erase_if(draft.triangles, [&](const Triangle &t) {
        return std::all_of(t.begin(), t.end(), [&](std::uint32_t corner) {
            return draft.positions[corner].x() == 0.0;
        });
    });
    append(draft, box({5.0, -3.0, 1.0}, {15.0, 13.0, 11.0}));
    append(draft, box({12.0, 0.0, 1.0}, {18.0, 5.0, 11.0}));
    const PlaneCut cut = cutOf(draft, {0.0, 0.0, 5.0}, kUp);
    QCOMPARE(shapeOf(cut), QStringLiteral("2/0"));
    QCOMPARE(cut.bridges(), std::size_t(1));
    QVERIFY(cut.loops.front().isClosed());
    QVERIFY(isNear(cut.loops.front().area, 175.0));
}

void TestPlaneCut::surfacesWithoutAnInside()
{
    const PlaneCut band = cutOf(moebiusBand(50.0, 20.0, 90), Vec3::Zero(), {0.3, 1.0, 0.1});
    QVERIFY(!band.loops.empty());
    QVERIFY(band.bridges() > 0);
    // One triangle: a chord, there and back.
    MeshDraft one;
    one.positions = {{0.0, 0.0, 0.0}, {10.0, 0.0, 0.0}, {0.0, 0.0, 10.0}};
    one.triangles = {{0, 1, 2}};
    const PlaneCut chord = cutOf(one, {0.0, 0.0, 5.0}, kUp);
    QCOMPARE(chord.bridges(), chord.loops.empty() ? std::size_t(0) : std::size_t(1));
    QVERIFY(chord.area() < 1e-9);
    // A triangle in the plane has no edge that is crossed.
    QVERIFY(cutOf(one, Vec3::Zero(), {0.0, 1.0, 0.0}).loops.empty());
}

/// As drawn without mending: half of the faces look inwards.
void TestPlaneCut::facesThatDoNotAgree()
{
    MeshDraft draft = cubesAtAnEdge(10.0);
    append(draft, turnedOver(box({-6.0, -6.0, 2.0}, {-3.0, -3.0, 8.0})));
    for (std::size_t f = 0; f < draft.triangles.size(); f += 2)
        std::swap(draft.triangles[f][1], draft.triangles[f][2]);
    // Not mended, which would turn the faces over.
    const TriangleMesh mesh(draft.positions, draft.triangles);
    const PlaneCut cut = planeCut(mesh, makeCutPlane({0.0, 0.0, 5.0}, kUp).value());
    QCOMPARE(shapeOf(cut), QStringLiteral("2/1"));
    QVERIFY(isNear(cut.area(), 200.0 - 9.0));
}

void TestPlaneCut::exactSides()
{
    // On the plane in exact arithmetic, but not in floating point.
    const Vec3 normal(0.1, 0.2, 0.7);
    const PlaneSides sides({{0.3, 0.7, -0.4}, normal});
    std::mt19937 random(3);
    std::uniform_int_distribution<int> whole(-1000, 1000);
    for (int i = 0; i < 1000; ++i) {
        // Along a direction that is exactly square to the normal.
        const double s = 0.125 * whole(random);
        const PlaneSides level({{1.0, 2.0, 3.0}, {1.0, 1.0, 1.0}});
        QCOMPARE(level.of({1.0 + s, 2.0 - s, 3.0}), 0);
        const double tiny = std::ldexp(1.0, -40);
        QCOMPARE(level.of({1.0 + s + tiny, 2.0 - s, 3.0}), 1);
        QCOMPARE(level.of({1.0 + s - tiny, 2.0 - s, 3.0}), -1);
    }
    QCOMPARE(sides.of({0.3, 0.7, -0.4}), 0);
    // Large terms that all but cancel.
    const PlaneSides steep({Vec3::Zero(), {1e15, -1e15, 1.0}});
    QCOMPARE(steep.of({1.0, 1.0, 0.0}), 0);
    QCOMPARE(steep.of({1.0, 1.0, 1e-12}), 1);
    QCOMPARE(steep.of({1.0, 1.0, -1e-300}), -1);
}

void TestPlaneCut::planesThatAreNone()
{
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    QCOMPARE(makeCutPlane(Vec3::Zero(), Vec3::Zero()).error().code, ErrorCode::DegenerateFrame);
    QCOMPARE(makeCutPlane({kNan, 0.0, 0.0}, kUp).error().code, ErrorCode::DegenerateFrame);
    QVERIFY(makeCutPlane(Vec3::Zero(), {0.0, 1e-200, 0.0})->normal == Vec3::UnitY());
    for (const Vec3 &normal : {Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(1e-9, 1, 0), Vec3(3, -2, 1)}) {
        const Frame frame = frameOn(makeCutPlane({1.0, 2.0, 3.0}, normal).value());
        QVERIFY((frame.normal() - normal.normalized()).norm() < 1e-12);
        QVERIFY(std::abs(frame.x.dot(frame.y)) < 1e-12 && isNear(frame.x.norm(), 1.0));
    }
}

FFF_TEST(TestPlaneCut)
#include "tst_plane_cut.moc"
