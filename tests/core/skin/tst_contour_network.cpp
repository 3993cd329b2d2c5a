// Where contours meet, and the cycles between.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/skin/contour_network.h"
#include "tests/core/skin/discs.h"
#include "tests/test_program.h"

#include <map>
#include <numbers>

using namespace fff;
using namespace fff::test;

namespace {

using Sections = std::vector<SectionPointer>;

ContourNetwork networkOf(const Sections &sections)
{
    return contourNetwork(sections).value();
}

/// Corners − edges + cycles: 2 for a ball.
int euler(const ContourNetwork &network)
{
    return static_cast<int>(network.corners.size()) - static_cast<int>(network.edges.size()) +
           static_cast<int>(cyclesOf(network).size());
}

std::map<std::size_t, int> sidesOf(const ContourNetwork &network)
{
    std::map<std::size_t, int> count;
    for (const auto &cycle : cyclesOf(network))
        ++count[cycle.size()];
    return count;
}

} // namespace

class TestContourNetwork : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void balls_data();
    void balls();
    void normalsPointOutwards();
    void eachHalfEdgeIsInOneCycle();
    void threeInOnePlace();
    void ribsBesideEachOtherStayTwo();
    void endsInsideAreNone();
    void aRing();
};

void TestContourNetwork::balls_data()
{
    QTest::addColumn<Sections>("sections");
    QTest::addColumn<int>("corners");
    QTest::addColumn<int>("edges");
    QTest::newRow("two") << Sections{disc(50, Vec3::UnitX(), 0), disc(50, Vec3::UnitY(), 0)} << 2
                         << 4;
    QTest::newRow("three") << sphere(50, {0.0}) << 6 << 12;
    QTest::newRow("two by three") << sphere(50, {-0.3, 0.25}) << 24 << 48;
    QTest::newRow("far from the middle")
        << moved(sphere(50, {0.0}), Eigen::Isometry3d(Eigen::Translation3d(9000, -7000, 400))) << 6
        << 12;
}

void TestContourNetwork::balls()
{
    QFETCH(Sections, sections);
    QFETCH(int, corners);
    QFETCH(int, edges);
    const ContourNetwork network = networkOf(sections);
    QCOMPARE(int(network.corners.size()), corners);
    QCOMPARE(int(network.edges.size()), edges);
    QCOMPARE(euler(network), 2);
    QVERIFY(network.loose.empty());
}

void TestContourNetwork::normalsPointOutwards()
{
    for (const NetCorner &corner : networkOf(sphere(50, {-0.3, 0.25})).corners)
        QVERIFY(corner.normal.dot(corner.point.normalized()) > 0.98);
}

void TestContourNetwork::eachHalfEdgeIsInOneCycle()
{
    const ContourNetwork network = networkOf(sphere(50, {-0.3, 0.25}));
    std::map<HalfEdge, int> count;
    for (const auto &cycle : cyclesOf(network))
        for (std::size_t i = 0; i < cycle.size(); ++i) {
            ++count[cycle[i]];
            const HalfEdge next = cycle[(i + 1) % cycle.size()];
            QCOMPARE(network.startOf(next), network.startOf(cycle[i] ^ 1));
        }
    QCOMPARE(count.size(), 2 * network.edges.size());
    for (const auto &[half, times] : count)
        QCOMPARE(times, 1);
}

void TestContourNetwork::threeInOnePlace()
{
    const ContourNetwork network =
        networkOf({disc(50, {1, 0, 0}, 0), disc(50, {1, 0, 1}, 0), disc(50, {-1, 0, 1}, 0)});
    QCOMPARE(int(network.corners.size()), 2);
    QCOMPARE(int(network.edges.size()), 6);
    QCOMPARE(sidesOf(network), (std::map<std::size_t, int>{{2, 6}}));
}

// Wrong: ribs that stand close become one.
void TestContourNetwork::ribsBesideEachOtherStayTwo()
{
    const ContourNetwork network =
        networkOf({disc(50, Vec3::UnitZ(), 0), disc(50, Vec3::UnitX(), 0),
                   disc(50, Vec3::UnitX(), 2.0), disc(50, Vec3::UnitX(), 4.0)});
    QCOMPARE(int(network.corners.size()), 6);
    QCOMPARE(sidesOf(network), (std::map<std::size_t, int>{{2, 4}, {4, 4}}));
}

void TestContourNetwork::endsInsideAreNone()
{
    const ContourNetwork network =
        networkOf({disc(80, Vec3::UnitZ(), 0), disc(30, Vec3::UnitX(), 0)});
    QVERIFY(network.corners.empty() && network.edges.empty());
    QCOMPARE(int(network.loose.size()), 2);
}

// Wrong: a torus is filled as if it were a ball.
void TestContourNetwork::aRing()
{
    Sections all;
    for (int i = 0; i < 6; ++i) {
        const double angle = std::numbers::pi * i / 3.0;
        const Vec3 out(std::cos(angle), 0.0, std::sin(angle));
        all.push_back(sectionOf(circle({0, 0}, 15.0), 50.0 * out, out, Vec3::UnitY()));
    }
    // Two plates round, cut at the middle of the tubes.
    all.push_back(sectionOf(circle({0, 0}, 65.0), Vec3::Zero(), Vec3::UnitX(), Vec3::UnitZ(),
                            {circle({0, 0}, 35.0)}));
    const ContourNetwork network = networkOf(all);
    QCOMPARE(int(network.corners.size()), 6);
    QCOMPARE(int(network.edges.size()), 12);
}

FFF_TEST(TestContourNetwork)
#include "tst_contour_network.moc"
