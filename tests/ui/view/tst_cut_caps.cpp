#include <QTest> // first: moc cannot read some of the standard library before it

#include "tests/test_program.h"
#include "ui/view/cut_caps.h"

#include <cmath>
#include <numbers>

using namespace fff;
using namespace fff::ui;

namespace {

Region ringRegion()
{
    Region region;
    constexpr int kPoints = 60;
    for (int i = 0; i < kPoints; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kPoints;
        region.outer.push_back({40.0 * std::cos(angle), 40.0 * std::sin(angle)});
    }
    region.holes.push_back({{-10, -10}, {-10, 10}, {10, 10}, {10, -10}});
    return region;
}

Vec3 corner(const CutCaps &caps, std::size_t i)
{
    const auto &p = caps.triangles[i];
    return {p[0], p[1], p[2]};
}

double area(const CutCaps &caps)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < caps.triangles.size(); i += 3) {
        const Vec3 a = corner(caps, i);
        sum += 0.5 * (corner(caps, i + 1) - a).cross(corner(caps, i + 2) - a).norm();
    }
    return sum;
}

const Frame kAskew = *makeFrame(Vec3(5, 20, -3), Vec3(1, 0.2, 0.1), Vec3(-0.1, 1, 0.4));
constexpr double kThickness = 6.0;

CutCaps capOf(const ClipPlane &plane)
{
    const Region region = ringRegion();
    const Triangulation triangles = *triangulate(region);
    CutCaps caps;
    addCap(caps, {&region, 1}, {&triangles, 1}, kAskew, kThickness, plane);
    return caps;
}

} // namespace

class TestCutCaps : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void capsAddUpToTheSolid_data();
    void capsAddUpToTheSolid();
    void capsLieInThePlane();
    void anOutlineIsClosed();
    void beyondIsNothing();
};

void TestCutCaps::capsAddUpToTheSolid_data()
{
    QTest::addColumn<Vec3>("normal");
    QTest::newRow("along the sheet") << kAskew.x;
    QTest::newRow("through the sheet") << kAskew.normal();
    QTest::newRow("askew") << Vec3(0.3, 0.5, -0.8).normalized();
    QTest::newRow("nearly in the sheet") << (kAskew.normal() + 0.05 * kAskew.x).normalized();
}

/// Cavalieri: areas of slices, times their distance, are the volume.
void TestCutCaps::capsAddUpToTheSolid()
{
    QFETCH(Vec3, normal);
    const double volume = area(ringRegion()) * kThickness;
    constexpr double kStep = 0.05;
    double sum = 0.0;
    for (double at = -60.0; at < 60.0; at += kStep)
        sum += kStep * area(capOf({kAskew.origin + (at + 0.0123) * normal, normal}));
    QVERIFY(std::abs(sum - volume) < 0.01 * volume);
}

void TestCutCaps::capsLieInThePlane()
{
    const ClipPlane plane{kAskew.origin + Vec3(1, 2, 3), Vec3(0.3, 0.5, -0.8).normalized()};
    const CutCaps caps = capOf(plane);
    QVERIFY(!caps.triangles.empty());
    for (std::size_t i = 0; i < caps.triangles.size(); ++i) {
        QVERIFY(std::abs(plane.height(corner(caps, i))) < 1e-4);
        QVERIFY(std::abs(kAskew.height(corner(caps, i))) < 0.5 * kThickness + 1e-4);
    }
}

/// Its edges, as vectors along the wall, come back to where they begin: the lines between them and
/// their number are those of a closed outline.
void TestCutCaps::anOutlineIsClosed()
{
    const CutCaps caps = capOf({kAskew.origin, kAskew.x});
    // Two bars beside the square hole, 30 x 6 mm each.
    double length = 0.0;
    for (const SlabEdge &edge : caps.edges)
        length += (Vec3(edge.to[0], edge.to[1], edge.to[2]) -
                   Vec3(edge.from[0], edge.from[1], edge.from[2]))
                      .norm();
    QVERIFY(std::abs(length - 4.0 * (30.0 + kThickness)) < 0.2);
    QVERIFY(std::abs(area(caps) - 2.0 * 30.0 * kThickness) < 0.5);
}

void TestCutCaps::beyondIsNothing()
{
    const CutCaps caps = capOf({kAskew.origin + 50.0 * kAskew.x, kAskew.x});
    QVERIFY(caps.triangles.empty());
    QVERIFY(caps.edges.empty());
}

FFF_TEST(TestCutCaps)
#include "tst_cut_caps.moc"
