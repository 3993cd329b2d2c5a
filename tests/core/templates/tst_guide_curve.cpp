// Guides as contours. If this fails, a section that follows a template is beside it, has lost its
// corners, or comes as a thousand points that nobody can edit.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/templates/guide_curve.h"
#include "tests/core/geometry/curve_distance.h"
#include "tests/core/templates/made_meshes.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;

namespace {

/// The furthest that curve and loop are from each other, either way.
double apart(const Contour &contour, const Polygon &loop)
{
    double furthest = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
        for (const double t : {0.0, 0.5})
            furthest = std::max(furthest, distanceTo(Vec2(a + t * (b - a)), contour));
    }
    for (int s = 0; s < contour.segmentCount(); ++s)
        for (int i = 0; i < 20; ++i)
            furthest = std::max(furthest, distanceTo(contour.segment(s).at(i / 20.0), loop));
    return furthest;
}

Polygon flat(const CutLoop &loop, const Frame &frame)
{
    Polygon polygon;
    for (const Vec3 &p : loop.points)
        polygon.push_back(frame.toLocal(p));
    return polygon;
}

} // namespace

class TestGuideCurve : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void followsTheLoop_data();
    void followsTheLoop();
    void cornersStay();
    void holesRunAsHoles();
    void nothingToFollow();
};

void TestGuideCurve::followsTheLoop_data()
{
    QTest::addColumn<MeshDraft>("draft");
    QTest::addColumn<Vec3>("normal");
    QTest::addColumn<int>("most"); // segments
    QTest::newRow("a ball") << sphere(50.0, 60, 90) << Vec3(0, 0, 1) << 18;
    QTest::newRow("a ball, oblique") << sphere(50.0, 60, 90) << Vec3(1, 2, 3) << 16;
    QTest::newRow("a fine ball") << sphere(50.0, 500, 800) << Vec3(1, 2, 3) << 16;
    QTest::newRow("a head from the side") << head(120, 180) << Vec3(0, 1, 0) << 40;
    QTest::newRow("a head across") << head(120, 180) << Vec3(0.1, 0, 1) << 40;
    QTest::newRow("a cube") << cube(80.0) << Vec3(0, 0, 1) << 4;
    QTest::newRow("a cube, six edges") << cube(80.0) << Vec3(1, 1, 1) << 6;
    QTest::newRow("a coarse ball has its corners") << sphere(50.0, 6, 8) << Vec3(0.1, 0, 1) << 16;
    QTest::newRow("a cup with a lid that is not there")
        << without(sphere(50.0, 60, 90), [](const Vec3 &p) { return p.z() > 25.0; })
        << Vec3(0, 1, 0) << 24;
}

void TestGuideCurve::followsTheLoop()
{
    QFETCH(const MeshDraft, draft);
    QFETCH(const Vec3, normal);
    QFETCH(const int, most);
    const TriangleMeshPointer mesh = meshOf(draft);
    const CutPlane plane = makeCutPlane({0.5, 0.25, 0.125}, normal).value();
    const PlaneCut cut = planeCut(*mesh, plane);
    QVERIFY(!cut.loops.empty());
    const Frame frame = frameOn(plane);
    const Result<Contour> contour = guideCurve(cut.loops.front(), frame);
    QVERIFY(contour);
    const double off = apart(*contour, flat(cut.loops.front(), frame));
    QVERIFY2(off <= kGuideError, qPrintable(QString::number(off)));
    QVERIFY2(contour->segmentCount() <= most, qPrintable(QString::number(contour->segmentCount())));
    QVERIFY(std::abs(contour->signedArea() - cut.loops.front().area) <
            kGuideError * perimeter(flat(cut.loops.front(), frame)));
}

void TestGuideCurve::cornersStay()
{
    const CutPlane plane = makeCutPlane(Vec3::Zero(), {0.0, 0.0, 1.0}).value();
    const PlaneCut cut = planeCut(*meshOf(cube(80.0)), plane);
    const Contour contour = guideCurve(cut.loops.front(), frameOn(plane)).value();
    QCOMPARE(contour.segmentCount(), 4);
    for (int s = 0; s < 4; ++s) {
        QVERIFY((contour.segment(s).p0.cwiseAbs() - Vec2(40.0, 40.0)).norm() < 1e-9);
        QVERIFY(contour.segment(s).isStraight(1e-9));
    }
}

void TestGuideCurve::holesRunAsHoles()
{
    const CutPlane plane = makeCutPlane(Vec3::Zero(), {0.0, 0.0, 1.0}).value();
    const PlaneCut cut = planeCut(*meshOf(torus(60.0, 20.0, 90, 40)), plane);
    QCOMPARE(cut.loops.size(), std::size_t(2));
    QVERIFY(guideCurve(cut.loops[0], frameOn(plane))->signedArea() > 0.0);
    QVERIFY(cut.loops[1].isHole);
    QVERIFY(guideCurve(cut.loops[1], frameOn(plane))->signedArea() < 0.0);
}

void TestGuideCurve::nothingToFollow()
{
    CutLoop loop;
    loop.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    QCOMPARE(guideCurve(loop, Frame()).error().code, ErrorCode::EmptyContour);
    // Smaller than what it may be off.
    loop.points = {{0, 0, 0}, {0.04, 0, 0}, {0.04, 0.04, 0}, {0, 0.04, 0}};
    loop.area = 0.0016;
    const Result<Contour> speck = guideCurve(loop, Frame());
    QVERIFY(!speck || std::abs(speck->signedArea()) < 0.01);
}

FFF_TEST(TestGuideCurve)
#include "tst_guide_curve.moc"
