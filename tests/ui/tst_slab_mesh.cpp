// A wrong mesh would show holes in the sheet, or light from inside.
#include "tests/test_program.h"
#include "ui/view/slab_mesh.h"

#include <QTest>

#include <cmath>
#include <map>
#include <numbers>

using namespace fff;
using namespace fff::ui;

namespace {

Polygon circle(const Vec2 &centre, double radius, int count, bool clockwise = false)
{
    Polygon points;
    for (int i = 0; i < count; ++i) {
        const double angle = (clockwise ? -2.0 : 2.0) * std::numbers::pi * i / count;
        points.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    return points;
}

Region square(double size)
{
    return {{{0.0, 0.0}, {size, 0.0}, {size, size}, {0.0, size}}, {}};
}

SlabMesh meshOf(const std::vector<Region> &regions)
{
    std::vector<Triangulation> triangulations;
    for (const Region &region : regions)
        triangulations.push_back(*triangulate(region));
    return buildSlab(regions, triangulations);
}

Vec3 point(const SlabVertex &v)
{
    return {v.position[0], v.position[1], v.position[2]};
}

/// Twice the triangle's area times its normal.
Vec3 twiceArea(const SlabMesh &mesh, std::size_t triangle)
{
    const Vec3 a = point(mesh.vertices[mesh.triangles[3 * triangle]]);
    const Vec3 b = point(mesh.vertices[mesh.triangles[3 * triangle + 1]]);
    const Vec3 c = point(mesh.vertices[mesh.triangles[3 * triangle + 2]]);
    const Vec3 u = b - a, v = c - a;
    return {u.y() * v.z() - u.z() * v.y(), u.z() * v.x() - u.x() * v.z(),
            u.x() * v.y() - u.y() * v.x()};
}

} // namespace

class TestSlabMesh : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void closed_data();
    void closed();
    void faces_data() { closed_data(); }
    void faces();
    void triangles_data() { closed_data(); }
    void triangles();
    void normals_data() { closed_data(); }
    void normals();
    void edges();
    void nothing();
};

void TestSlabMesh::closed_data()
{
    QTest::addColumn<std::vector<Region>>("regions");
    QTest::newRow("a square") << std::vector{square(10.0)};
    QTest::newRow("a disc with a hole")
        << std::vector{Region{circle({0.0, 0.0}, 50.0, 90), {circle({5.0, 0.0}, 20.0, 40, true)}}};
    QTest::newRow("two pieces") << std::vector{square(10.0),
                                               Region{circle({40.0, 0.0}, 9.0, 30), {}}};
    QTest::newRow("a square with a slit") << std::vector{Region{
        {{0, 0}, {8.5, 0}, {8.5, 10}, {11.5, 10}, {11.5, 0}, {20, 0}, {20, 20}, {0, 20}}, {}}};
    QTest::newRow("repeated points")
        << std::vector{Region{{{0, 0}, {0, 0}, {9, 0}, {9, 9}, {9, 9}, {0, 9}, {0, 0}}, {}}};
    QTest::newRow("points on a straight edge")
        << std::vector{Region{{{0, 0}, {3, 0}, {6, 0}, {9, 0}, {9, 9}, {0, 9}}, {}}};
}

/// Every edge of a triangle is met by one that runs the other way: no gap, no face turned inside.
void TestSlabMesh::closed()
{
    QFETCH(std::vector<Region>, regions);
    const SlabMesh mesh = meshOf(regions);
    using Place = std::array<float, 3>;
    std::map<std::pair<Place, Place>, int> runs;
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Place &from = mesh.vertices[mesh.triangles[i + k]].position;
            const Place &to = mesh.vertices[mesh.triangles[i + (k + 1) % 3]].position;
            ++runs[{from, to}];
            --runs[{to, from}];
        }
    }
    for (const auto &[edge, count] : runs)
        QCOMPARE(count, 0);
}

/// Top and bottom together have twice the area of what is cut.
void TestSlabMesh::faces()
{
    QFETCH(std::vector<Region>, regions);
    const SlabMesh mesh = meshOf(regions);
    double expected = 0.0, top = 0.0, bottom = 0.0;
    for (const Region &region : regions)
        expected += area(region);
    for (std::size_t i = 0; i < mesh.triangles.size() / 3; ++i) {
        const SlabVertex &v = mesh.vertices[mesh.triangles[3 * i]];
        if (v.normal[3] == 0)
            (v.normal[2] > 0 ? top : bottom) += 0.5 * twiceArea(mesh, i).z();
    }
    QVERIFY(std::abs(top - expected) < 1e-4 * expected);
    QVERIFY(std::abs(bottom + expected) < 1e-4 * expected);
}

void TestSlabMesh::triangles()
{
    QFETCH(std::vector<Region>, regions);
    const SlabMesh mesh = meshOf(regions);
    QVERIFY(!mesh.triangles.empty());
    for (std::size_t i = 0; i < mesh.triangles.size() / 3; ++i)
        QVERIFY(twiceArea(mesh, i).norm() > 1e-9);
}

/// A vertex's normal looks the way its triangle does, so that no wall is lit from behind.
void TestSlabMesh::normals()
{
    QFETCH(std::vector<Region>, regions);
    const SlabMesh mesh = meshOf(regions);
    for (std::size_t i = 0; i < mesh.triangles.size() / 3; ++i) {
        const Vec3 flat = twiceArea(mesh, i).normalized();
        for (std::size_t k = 0; k < 3; ++k) {
            const PackedNormal &n = mesh.vertices[mesh.triangles[3 * i + k]].normal;
            const Vec3 normal = Vec3(n[0], n[1], n[2]) / 127.0;
            QVERIFY(normal.dot(flat) > 0.9);
        }
    }
}

/// Corners have a line, the seams of a curve only where they are the silhouette.
void TestSlabMesh::edges()
{
    const auto uprights = [](const SlabMesh &mesh) {
        int count = 0;
        for (const SlabEdge &edge : mesh.edges)
            count += edge.from[2] != edge.to[2] && edge.normalA[3] > 0 ? 1 : 0;
        return count;
    };
    QCOMPARE(uprights(meshOf({square(10.0)})), 4);
    QCOMPARE(uprights(meshOf({Region{circle({0.0, 0.0}, 50.0, 90), {}}})), 0);
    QCOMPARE(meshOf({square(10.0)}).edges.size(), std::size_t(12));
}

void TestSlabMesh::nothing()
{
    const SlabMesh mesh = buildSlab({}, {});
    QVERIFY(mesh.vertices.empty() && mesh.triangles.empty() && mesh.edges.empty());
}

FFF_TEST(TestSlabMesh)
#include "tst_slab_mesh.moc"
