#include <QTest> // first: moc stumbles over some standard headers

#include "core/geometry/hull_faces.h"
#include "tests/test_program.h"

#include <Eigen/Geometry>

#include <random>

using namespace fff;

namespace {

const Vec3 &at(const HullFaces &hull, int corner)
{
    return hull.points[static_cast<std::size_t>(corner)];
}

std::vector<Vec3> box(const Vec3 &size)
{
    std::vector<Vec3> points;
    for (int i = 0; i < 8; ++i)
        points.emplace_back(i & 1 ? size.x() : 0.0, i & 2 ? size.y() : 0.0, i & 4 ? size.z() : 0.0);
    return points;
}

} // namespace

class TestHullFaces : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingIsOutside();
    void facesMeetTheirNeighbours();
    void aBoxHasTwelve();
    void whatIsFlatHasNone();
};

void TestHullFaces::nothingIsOutside()
{
    std::mt19937 random(3);
    std::normal_distribution<double> along;
    for (int round = 0; round < 50; ++round) {
        std::vector<Vec3> points;
        for (int i = 0; i < 40; ++i)
            points.emplace_back(along(random), along(random), along(random));
        const HullFaces hull = hullFaces(points);
        QVERIFY(hull.faces.size() >= 4);
        for (const HullFaces::Face &face : hull.faces) {
            const Vec3 &a = at(hull, face.corners[0]);
            const Vec3 out =
                (at(hull, face.corners[1]) - a).cross(at(hull, face.corners[2]) - a).normalized();
            for (const Vec3 &p : points)
                QVERIFY(out.dot(p - a) < 1e-12);
        }
    }
}

void TestHullFaces::facesMeetTheirNeighbours()
{
    std::mt19937 random(4);
    std::normal_distribution<double> along;
    std::vector<Vec3> points;
    for (int i = 0; i < 200; ++i)
        points.push_back(Vec3(along(random), along(random), along(random)).normalized());
    const HullFaces hull = hullFaces(points);
    // On a sphere every point is a corner; Euler: two faces a corner, but for four.
    QCOMPARE(hull.points.size(), points.size());
    QCOMPARE(hull.faces.size(), 2 * points.size() - 4);
    for (const HullFaces::Face &face : hull.faces)
        for (std::size_t side = 0; side < 3; ++side) {
            const HullFaces::Face &other = hull.faces[static_cast<std::size_t>(face.across[side])];
            const int from = face.corners[side], to = face.corners[(side + 1) % 3];
            bool isBack = false;
            for (std::size_t i = 0; i < 3; ++i)
                isBack |= other.corners[i] == to && other.corners[(i + 1) % 3] == from &&
                          &hull.faces[static_cast<std::size_t>(other.across[i])] == &face;
            QVERIFY(isBack);
        }
}

void TestHullFaces::aBoxHasTwelve()
{
    std::vector<Vec3> points = box({3, 4, 5});
    points.push_back({1.5, 2, 2.5});                                 // inside
    points.push_back({1.5, 0, 2.5});                                 // on a side
    points.push_back({1.5, 0, 0});                                   // on an edge
    points.insert(points.end(), points.begin(), points.begin() + 8); // twice
    const HullFaces hull = hullFaces(points);
    QCOMPARE(hull.faces.size(), std::size_t(12));
    QCOMPARE(hull.points.size(), std::size_t(8));
}

void TestHullFaces::whatIsFlatHasNone()
{
    QVERIFY(hullFaces({}).faces.empty());
    QVERIFY(hullFaces({{1, 2, 3}, {1, 2, 3}}).faces.empty());
    QVERIFY(hullFaces({{0, 0, 0}, {1, 2, 3}, {2, 4, 6}, {3, 6, 9}}).faces.empty());
    QVERIFY(hullFaces(box({3, 0, 5})).faces.empty());
}

FFF_TEST(TestHullFaces)
#include "tst_hull_faces.moc"
