// Triangles of a plate: all of it, none too thin, of whatever a person draws.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/physics/plate_element.h"
#include "core/physics/plate_flexibility.h"
#include "tests/core/physics/plate_samples.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;

namespace {

double areaOf(const PlateMesh &mesh)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const PlateCorners c = cornersOf(mesh, i);
        sum += 0.5 * cross(c[1] - c[0], c[2] - c[0]);
    }
    return sum;
}

double leastAngle(const PlateMesh &mesh)
{
    double least = 180.0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const PlateCorners c = cornersOf(mesh, i);
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec2 a = c[(k + 1) % 3] - c[k], b = c[(k + 2) % 3] - c[k];
            least = std::min(least, std::atan2(cross(a, b), a.dot(b)) * 180.0 / std::numbers::pi);
        }
    }
    return least;
}

} // namespace

class TestPlateMesh : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void meshCoversTheRegion_data();
    void meshCoversTheRegion();
    void meshOfNastyRegions_data();
    void meshOfNastyRegions();
    void meshCanBeStopped();
};

void TestPlateMesh::meshCoversTheRegion_data()
{
    QTest::addColumn<double>("width");
    QTest::addColumn<double>("fineness");
    QTest::newRow("a plate") << 100.0 << 1.0;
    QTest::newRow("a fine mesh") << 100.0 << 2.0;
    QTest::newRow("a long strip") << 3.0 << 1.0;
}

void TestPlateMesh::meshCoversTheRegion()
{
    QFETCH(double, width);
    QFETCH(double, fineness);
    const Region region{rectangle(0, 0, 200, width), {}};
    PlateMeshOptions options;
    options.fineness = fineness;
    const auto mesh = plateMesh(region, options);
    // Wrong: a part of the plate is missing or counted twice, its triangles are thin, or the mesh
    // is so coarse that it bends in steps.
    QVERIFY(mesh.has_value());
    QVERIFY(std::abs(areaOf(*mesh) - area(region)) < 1e-6 * area(region));
    QVERIFY(leastAngle(*mesh) > 20.0);
    QVERIFY(mesh->isComplete);
    QVERIFY(mesh->corners > 150);
    QVERIFY(mesh->corners < 4000);
}

void TestPlateMesh::meshOfNastyRegions_data()
{
    QTest::addColumn<QVector<QVector<QPointF>>>("rings");
    const auto rings = [](const std::vector<Polygon> &given) {
        QVector<QVector<QPointF>> result;
        for (const Polygon &ring : given) {
            QVector<QPointF> points;
            for (const Vec2 &p : ring)
                points.append({p.x(), p.y()});
            result.append(points);
        }
        return result;
    };
    const auto reversed = [](Polygon ring) {
        std::reverse(ring.begin(), ring.end());
        return ring;
    };
    QTest::newRow("a sliver") << rings({{{0, 0}, {200, 0}, {200, 0.2}}});
    QTest::newRow("a ligament of 0.02 mm")
        << rings({rectangle(0, 0, 100, 50), reversed(rectangle(10, 0.02, 90, 20))});
    QTest::newRow("five thousand corners") << rings({wavyRing(5000, 60.0, 0.5)});
    QTest::newRow("a saw of fine teeth") << rings({wavyRing(3000, 60.0, 8.0)});
    QTest::newRow("an edge of a micron")
        << rings({{{0, 0}, {100, 0}, {100, 50}, {50.001, 50}, {50, 50}, {0, 50}}});
    QTest::newRow("points twice") << rings(
        {{{0, 0}, {0, 0}, {80, 0}, {80, 40}, {80, 40}, {0, 40}}});
    QTest::newRow("holes that touch in a corner")
        << rings({rectangle(0, 0, 100, 100), reversed(rectangle(20, 20, 50, 50)),
                  reversed(rectangle(50, 50, 80, 80))});
    QTest::newRow("a needle of a notch")
        << rings({{{0, 0}, {100, 0}, {100, 50}, {50.01, 50}, {50, 5}, {49.99, 50}, {0, 50}}});
}

void TestPlateMesh::meshOfNastyRegions()
{
    QFETCH(QVector<QVector<QPointF>>, rings);
    Region region;
    for (qsizetype i = 0; i < rings.size(); ++i) {
        Polygon ring;
        for (const QPointF &p : rings[i])
            ring.emplace_back(p.x(), p.y());
        if (i == 0)
            region.outer = ring;
        else
            region.holes.push_back(ring);
    }
    const auto mesh = plateMesh(region);
    // Wrong: what a person draws makes a mesh without end, or one that is not of the plate.
    QVERIFY(mesh.has_value());
    QVERIFY(mesh->corners < 4100);
    QVERIFY(std::abs(areaOf(*mesh) - area(region)) < 0.01 * area(region));
    for (std::size_t i = 0; i < mesh->triangles.size(); ++i) {
        const PlateCorners c = cornersOf(*mesh, i);
        QVERIFY(cross(c[1] - c[0], c[2] - c[0]) > 0.0);
    }
    // Wrong: the plate is there and nobody can tell how it bends, or it bends by nonsense.
    const auto model = PlateModel::make(*mesh, {3.0, 3200.0, 0.37, 1.19e-6});
    QVERIFY(model.has_value());
    PlateField forces = model->noField();
    model->addWeight(forces, {0, 0, -9.81});
    const PlateField moved = model->solve(forces);
    QVERIFY(moved.bending.allFinite());
    QVERIFY(moved.bending.dot(forces.bending) >= 0.0);
}

void TestPlateMesh::meshCanBeStopped()
{
    std::stop_source source;
    LongWork work;
    work.stop = source.get_token();
    source.request_stop();
    // Wrong: the wait for a plate that nobody wants any more goes on.
    const auto mesh = plateMesh(slitPlate(), {}, work);
    QVERIFY(!mesh.has_value());
    QCOMPARE(mesh.error().code, ErrorCode::Cancelled);
    const auto model = PlateModel::make(plateMesh(slitPlate()).value(), kSixMillimetres, {}, work);
    QVERIFY(!model.has_value());
    QCOMPARE(model.error().code, ErrorCode::Cancelled);
    const PlateModel whole = modelOf(slitPlate(), kSixMillimetres);
    const auto plate = plateFlexibility(whole, holdsOf(whole, 0.0, {0, 0}), whole.noField(), work);
    QVERIFY(!plate.has_value());
    QCOMPARE(plate.error().code, ErrorCode::Cancelled);
    // Wrong: numbers that are none, and plates that are none, get through to the mesh.
    QCOMPARE(plateMesh({{{0, 0}, {NAN, 0}, {1, 1}}, {}}).error().code, ErrorCode::NonFinite);
    QCOMPARE(plateMesh({{{0, 0}, {1, 0}, {2, 0}}, {}}).error().code, ErrorCode::EmptyContour);
    QCOMPARE(plateMesh({}).error().code, ErrorCode::EmptyContour);
    QCOMPARE(
        PlateModel::make(plateMesh(slitPlate()).value(), {0.0, 3200.0, 0.37, 0.0}).error().code,
        ErrorCode::NotWorkedOut);
}

FFF_TEST(TestPlateMesh)
#include "tst_plate_mesh.moc"
