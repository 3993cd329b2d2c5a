// Cuts against CGAL's exact slicer. If this fails, a loop is lost, or is not where the plane meets
// the mesh. Alone in its file: CGAL's slicer is slow to compile.
#include "core/templates/plane_cut.h"
#include "tests/core/templates/made_meshes.h"
#include "tests/test_program.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_slicer.h>
#include <CGAL/Surface_mesh.h>
#include <QTest>

#include <numeric>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using ExactMesh = CGAL::Surface_mesh<Kernel::Point_3>;

constexpr int kPlanes = 1000;

/// What the slicer finds: loops by their areas, and how long all of it is.
struct Sliced
{
    std::vector<double> areas; // rising, of closed ones
    double length = 0.0;
    double area = 0.0; // of what lies in an odd number of them
    int open = 0;
};

/// Seen along the axis in which the normal is longest.
bool liesIn(const Vec3 &p, const std::vector<Vec3> &loop, int axis)
{
    const int x = (axis + 1) % 3, y = (axis + 2) % 3;
    bool isInside = false;
    for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
        const Vec3 &a = loop[j], &b = loop[i];
        if ((a[y] <= p[y]) != (b[y] <= p[y]) &&
            p[x] < a[x] + (p[y] - a[y]) / (b[y] - a[y]) * (b[x] - a[x]))
            isInside = !isInside;
    }
    return isInside;
}

class Slicer
{
public:
    /// Vertices as they are: what several solids have in common is there for each of them.
    explicit Slicer(const MeshDraft &draft)
    {
        for (const Vec3 &p : draft.positions)
            m_mesh.add_vertex({p.x(), p.y(), p.z()});
        for (const Triangle &t : draft.triangles)
            m_mesh.add_face(ExactMesh::Vertex_index(t[0]), ExactMesh::Vertex_index(t[1]),
                            ExactMesh::Vertex_index(t[2]));
        m_slicer = std::make_unique<CGAL::Polygon_mesh_slicer<ExactMesh, Kernel>>(m_mesh);
    }

    bool hasAll(const MeshDraft &draft) const
    {
        return m_mesh.number_of_faces() == draft.triangles.size();
    }

    Sliced at(const CutPlane &plane) const
    {
        const Kernel::Point_3 origin(plane.origin.x(), plane.origin.y(), plane.origin.z());
        const Kernel::Vector_3 normal(plane.normal.x(), plane.normal.y(), plane.normal.z());
        std::vector<std::vector<Kernel::Point_3>> lines;
        (*m_slicer)(Kernel::Plane_3(origin, normal), std::back_inserter(lines));
        Sliced result;
        std::vector<std::vector<Vec3>> loops;
        std::vector<double> areas;
        for (const auto &line : lines) {
            Vec3 twice = Vec3::Zero();
            const auto at = [&line](std::size_t i) {
                return Vec3(line[i].x(), line[i].y(), line[i].z());
            };
            for (std::size_t i = 0; i + 1 < line.size(); ++i) {
                twice += (at(i) - at(0)).cross(at(i + 1) - at(0));
                result.length += (at(i + 1) - at(i)).norm();
            }
            if (line.front() != line.back()) {
                ++result.open;
                continue;
            }
            areas.push_back(0.5 * std::abs(twice.dot(plane.normal)));
            std::vector<Vec3> &loop = loops.emplace_back();
            for (std::size_t i = 0; i + 1 < line.size(); ++i)
                loop.push_back(at(i));
        }
        int axis = 0;
        plane.normal.cwiseAbs().maxCoeff(&axis);
        for (std::size_t i = 0; i < loops.size(); ++i) {
            const auto around = std::count_if(loops.begin(), loops.end(), [&](const auto &loop) {
                return &loop != &loops[i] && liesIn(loops[i].front(), loop, axis);
            });
            result.area += around % 2 == 0 ? areas[i] : -areas[i];
        }
        result.areas = areas;
        std::sort(result.areas.begin(), result.areas.end());
        return result;
    }

private:
    ExactMesh m_mesh;
    std::unique_ptr<CGAL::Polygon_mesh_slicer<ExactMesh, Kernel>> m_slicer;
};

/// Without those that nobody would see.
std::vector<double> larger(const std::vector<double> &areas, double least)
{
    std::vector<double> kept;
    for (const double area : areas)
        if (area > least)
            kept.push_back(area);
    std::sort(kept.begin(), kept.end());
    return kept;
}

std::vector<double> areasOf(const PlaneCut &cut)
{
    std::vector<double> areas;
    for (const CutLoop &loop : cut.loops)
        areas.push_back(loop.area);
    return areas;
}

bool areAlike(const std::vector<double> &a, const std::vector<double> &b, double error)
{
    return a.size() == b.size() &&
           std::equal(a.begin(), a.end(), b.begin(),
                      [=](double x, double y) { return std::abs(x - y) <= error; });
}

double sum(const std::vector<double> &areas)
{
    return std::accumulate(areas.begin(), areas.end(), 0.0);
}

double lengthOf(const PlaneCut &cut)
{
    double length = 0.0;
    for (const CutLoop &loop : cut.loops) {
        std::vector<bool> isBridge(loop.points.size(), false);
        for (const CutLoop::Bridge &bridge : loop.bridges)
            for (std::size_t i = 0; i < bridge.chords; ++i)
                isBridge[(bridge.from + i) % isBridge.size()] = true;
        for (std::size_t i = 0; i < loop.points.size(); ++i)
            if (!isBridge[i])
                length += (loop.points[(i + 1) % loop.points.size()] - loop.points[i]).norm();
    }
    return length;
}

double furthestOff(const PlaneCut &cut)
{
    double furthest = 0.0;
    for (const CutLoop &loop : cut.loops)
        for (const Vec3 &p : loop.points)
            furthest = std::max(furthest, std::abs(cut.plane.height(p)));
    return furthest;
}

std::string numbers(const std::vector<double> &values)
{
    std::string text;
    for (const double value : values)
        text += ' ' + std::to_string(value);
    return text + ' ';
}

} // namespace

class TestPlaneCutOracle : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void randomPlanes_data();
    void randomPlanes();
    void planesThroughVertices_data() { randomPlanes_data(); }
    void planesThroughVertices();
};

void TestPlaneCutOracle::randomPlanes_data()
{
    QTest::addColumn<MeshDraft>("draft");
    QTest::addColumn<bool>("isOpen");
    QTest::addColumn<bool>("isCrossing"); // itself
    QTest::newRow("a sphere") << sphere(50.0, 24, 40) << false << false;
    QTest::newRow("a torus") << torus(60.0, 20.0, 48, 24) << false << false;
    QTest::newRow("a cube") << cube(80.0) << false << false;
    QTest::newRow("cubes that share an edge") << cubesAtAnEdge(40.0) << false << false;
    QTest::newRow("a ball with two holes") << without(sphere(50.0, 24, 40), [](const Vec3 &p) {
        return p.z() > 30.0 || p.x() < -40.0;
    }) << true << false;
    QTest::newRow("balls that cross each other") << crossingBalls(40.0, 20, 32) << false << true;
    QTest::newRow("a head") << head(60, 90) << false << false;
    QTest::newRow("100,000 triangles") << torus(60.0, 25.0, 500, 100) << false << false;
    MeshDraft shell = sphere(50.0, 20, 30);
    append(shell, turnedOver(sphere(42.0, 16, 24)));
    QTest::newRow("a hollow ball") << shell << false << false;
}

void TestPlaneCutOracle::randomPlanes()
{
    QFETCH(const MeshDraft, draft);
    QFETCH(const bool, isOpen);
    QFETCH(const bool, isCrossing);
    const Slicer slicer(draft);
    QVERIFY(slicer.hasAll(draft));
    const TriangleMeshPointer mesh = meshOf(draft);
    const MeshTree tree = MeshTree::make(*mesh).value();
    const double size = mesh->size();
    std::mt19937 random(20261);
    std::normal_distribution<double> direction;
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (int i = 0; i < kPlanes; ++i) {
        const Vec3 normal(direction(random), direction(random), direction(random));
        const Vec3 origin =
            mesh->bounds().min +
            Vec3(share(random), share(random), share(random)).cwiseProduct(mesh->bounds().size());
        const CutPlane plane = makeCutPlane(origin, normal).value();
        const PlaneCut cut = planeCut(*mesh, plane, &tree);
        const Sliced expected = slicer.at(plane);
        QVERIFY(furthestOff(cut) <= 1e-9 * size);
        if (isOpen) {
            QVERIFY2(std::abs(lengthOf(cut) - expected.length) <= 1e-9 * size * 1e3,
                     qPrintable(QStringLiteral("plane %1: %2 of %3")
                                    .arg(i)
                                    .arg(lengthOf(cut))
                                    .arg(expected.length)));
            QCOMPARE(cut.bridges(), std::size_t(expected.open));
            continue;
        }
        QCOMPARE(cut.bridges(), std::size_t(0));
        QCOMPARE(expected.open, 0);
        if (isCrossing) { // of loops that cross, one round both
            const std::vector<double> &areas = expected.areas;
            QVERIFY(cut.loops.size() <= areas.size());
            QVERIFY(cut.area() <= sum(areas) + 1e-9 * size * size);
            QVERIFY(areas.empty() || cut.area() >= areas.back() - 1e-9 * size * size);
            continue;
        }
        const std::vector<double> found = larger(areasOf(cut), 0.0);
        QVERIFY2(
            areAlike(found, larger(expected.areas, 0.0), 1e-9 * size * size),
            (std::to_string(i) + ": found" + numbers(found) + "expected" + numbers(expected.areas))
                .c_str());
    }
}

/// Just below the plane is what a plane through vertices stands for.
void TestPlaneCutOracle::planesThroughVertices()
{
    QFETCH(const MeshDraft, draft);
    QFETCH(const bool, isOpen);
    QFETCH(const bool, isCrossing);
    if (isOpen || isCrossing)
        return; // ends on the plane come and go, and loops become one
    const Slicer slicer(draft);
    const TriangleMeshPointer mesh = meshOf(draft);
    const MeshTree tree = MeshTree::make(*mesh).value();
    const double size = mesh->size(), shift = 1e-10 * size, speck = 1e-7 * size * size;
    std::mt19937 random(20262);
    std::normal_distribution<double> direction;
    std::uniform_int_distribution<std::size_t> vertex(0, mesh->positions().size() - 1);
    std::uniform_int_distribution<std::size_t> face(0, mesh->triangles().size() - 1);
    for (int i = 0; i < kPlanes; ++i) {
        // By turns through one vertex, along an edge, and along a face.
        const Triangle &t = mesh->triangles()[face(random)];
        const Vec3 &a = mesh->positions()[t[0]], &b = mesh->positions()[t[1]],
                   &c = mesh->positions()[t[2]];
        Vec3 origin = a, normal(direction(random), direction(random), direction(random));
        if (i % 3 == 0)
            origin = mesh->positions()[vertex(random)];
        else if (i % 3 == 1)
            normal = (b - a).cross(normal);
        else
            normal = (b - a).cross(c - a);
        const CutPlane plane = makeCutPlane(origin, normal).value();
        const PlaneCut cut = planeCut(*mesh, plane, &tree);
        QVERIFY(furthestOff(cut) <= 1e-9 * size);
        QCOMPARE(cut.bridges(), std::size_t(0));
        const Sliced under = slicer.at({plane.origin - shift * plane.normal, plane.normal});
        const Sliced over = slicer.at({plane.origin + shift * plane.normal, plane.normal});
        const std::vector<double> found = larger(areasOf(cut), speck);
        const std::vector<double> below = larger(under.areas, speck),
                                  above = larger(over.areas, speck);
        const double error = 1e-6 * size * size;
        // What touches itself in a vertex is two loops, and a hole that touches what is around it
        // is none.
        const bool isOtherwiseThere =
            found.size() != below.size() && std::abs(cut.area() - under.area) <= error;
        bool fits = false;
        if (i % 3 == 0) {
            fits = areAlike(found, below, error) || isOtherwiseThere;
        } else if (i % 3 == 1) {
            // What touches along the edge may be one loop.
            fits = std::abs(sum(found) - sum(below)) <= error || isOtherwiseThere;
        } else {
            // Rounding tilts the plane: it may go right through the face.
            const auto isBetween = [error](double value, double from, double to) {
                return value >= std::min(from, to) - error && value <= std::max(from, to) + error;
            };
            fits = isBetween(cut.area(), under.area, over.area) ||
                   isBetween(sum(found), sum(below), sum(above));
        }
        QVERIFY2(fits, (std::to_string(i) + ": found" + numbers(found) + "below" + numbers(below) +
                        "above" + numbers(above))
                           .c_str());
    }
}

FFF_TEST(TestPlaneCutOracle)
#include "tst_plane_cut_oracle.moc"
