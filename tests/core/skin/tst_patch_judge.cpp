// What the skin keeps of all that could be spanned between contours.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/skin/coons_patch.h"
#include "core/skin/patch_judge.h"
#include "tests/test_program.h"

#include <cmath>
#include <numbers>
#include <utility>

using namespace fff;

namespace {

constexpr double kHalfCircle = 50.0; // mm
constexpr double kHalfTurn = std::numbers::pi;

/// Half a circle about the origin from +x over +y to −x, turned about x; its ends are vertices of
/// the mesh.
SkinCurve halfCircle(GrowingMesh &mesh, double turn, std::uint32_t first, std::uint32_t last)
{
    constexpr int kChords = 24;
    SkinCurve curve;
    for (int i = 0; i <= kChords; ++i) {
        const double angle = kHalfTurn * i / kChords;
        const Vec3 out(std::cos(angle), std::sin(angle) * std::cos(turn),
                       std::sin(angle) * std::sin(turn));
        curve.points.push_back(kHalfCircle * out);
        curve.normals.push_back(out);
        curve.outwards.push_back(out);
        curve.vertices.push_back(i == 0         ? first
                                 : i == kChords ? last
                                                : mesh.add(kHalfCircle * out));
    }
    measure(curve);
    return curve;
}

} // namespace

class TestPatchJudge : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void partsOfASphere_data();
    void partsOfASphere();
};

void TestPatchJudge::partsOfASphere_data()
{
    QTest::addColumn<double>("degrees"); // between two half circles
    QTest::addColumn<bool>("isKept");
    for (const double degrees : {10.0, 45.0, 90.0, 120.0})
        QTest::addRow("%g°", degrees) << degrees << true;
    // Of a flat disc alone nobody knows how far it bulges; nor of arches with nothing between them.
    for (const double degrees : {170.0, 180.0})
        QTest::addRow("%g°", degrees) << degrees << false;
}

// Wrong: balloons at the ends of a bridge.
void TestPatchJudge::partsOfASphere()
{
    QFETCH(double, degrees);
    QFETCH(bool, isKept);
    const double half = 0.5 * degrees * kHalfTurn / 180.0;
    GrowingMesh mesh;
    const std::uint32_t first = mesh.add({kHalfCircle, 0, 0}),
                        last = mesh.add({-kHalfCircle, 0, 0});
    const SkinCurve south = halfCircle(mesh, -half, first, last);
    const SkinCurve north = halfCircle(mesh, half, first, last);
    const std::size_t points = mesh.points.size();
    PatchJudge judge(mesh);
    fillLune(mesh, south, north);
    QVERIFY(mesh.points.size() > points);
    const PatchFault fault = judge.faultOf({south, north.reversed()});
    QCOMPARE(fault == PatchFault::None, isKept);
    QCOMPARE(mesh.triangles.empty(), !isKept);
    QCOMPARE(mesh.points.size() == points, !isKept);
}

FFF_TEST(TestPatchJudge)
#include "tst_patch_judge.moc"
