// Where loads that are spread act: shares that press, all of them together where the load is.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/load_points.h"
#include "core/analysis/strength.h"
#include "core/io/document_file.h"
#include "core/model/load_edits.h"
#include "core/operations/evaluate.h"
#include "tests/core/analysed.h"
#include "tests/test_program.h"

#include <numbers>
#include <random>

using namespace fff;
using namespace fff::test;

// What would be wrong: a patch that pulls, one that presses beside the section, or a mass that
// becomes another one by being spread.

namespace {

Load spreadOver(Spread spread, double width)
{
    Load load;
    load.spread = spread;
    load.width = width;
    return load;
}

Region rectangle(double width, double height)
{
    return {{{0, 0}, {width, 0}, {width, height}, {0, height}}, {}};
}

Vec2 middleOf(const std::vector<LoadPoint> &points)
{
    Vec2 middle = Vec2::Zero();
    for (const LoadPoint &point : points)
        middle += point.share * point.at;
    return middle;
}

double sumOf(const std::vector<LoadPoint> &points)
{
    double sum = 0.0;
    for (const LoadPoint &point : points)
        sum += point.share;
    return sum;
}

} // namespace

class TestLoadPoints : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void wholePatchIsEven();
    void patchAtAnEdgeStillActsWhereItIs();
    void besideTheMaterialItIsAPoint();
    void edgeGoesRoundCorners();
    void edgeOfAHole();
    void longerThanTheEdge();
    void feetBearTheSame();
};

void TestLoadPoints::wholePatchIsEven()
{
    const Vec2 at(50, 40);
    const auto points = loadPoints(spreadOver(Spread::Patch, 30), at, rectangle(100, 80));
    QCOMPARE(points.size(), std::size_t(19));
    double inertia = 0.0;
    for (const LoadPoint &point : points) {
        QVERIFY(std::abs(point.share - 1.0 / 19.0) < 1e-12);
        QVERIFY((point.at - at).norm() < 15.0);
        inertia += point.share * (point.at - at).squaredNorm();
    }
    // Of a disc it is half the square of its radius.
    QVERIFY(std::abs(inertia - 0.5 * 15.0 * 15.0) < 0.05 * 0.5 * 15.0 * 15.0);
}

void TestLoadPoints::patchAtAnEdgeStillActsWhereItIs()
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> x(0.0, 100.0), y(0.0, 80.0), width(1.0, 200.0);
    Region region = rectangle(100, 80);
    region.holes.push_back({{30, 30}, {30, 50}, {60, 50}, {60, 30}});
    for (int i = 0; i < 2000; ++i) {
        const Vec2 at(x(random), y(random));
        if (locate(at, region) == Side::Outside)
            continue;
        const auto points = loadPoints(spreadOver(Spread::Patch, width(random)), at, region);
        QVERIFY(std::abs(sumOf(points) - 1.0) < 1e-9);
        QVERIFY((middleOf(points) - at).norm() < 1e-6);
        for (const LoadPoint &point : points) {
            QVERIFY(point.share >= 0.0);
            QVERIFY(locate(point.at, region) != Side::Outside);
        }
    }
}

void TestLoadPoints::besideTheMaterialItIsAPoint()
{
    const Vec2 at(200, 200);
    const auto points = loadPoints(spreadOver(Spread::Patch, 20), at, rectangle(100, 80));
    QCOMPARE(points.size(), std::size_t(1));
    QCOMPARE(points[0].at, at);
    QCOMPARE(points[0].share, 1.0);
}

/// 40 mm about the corner at (100, 80): 20 mm of each side.
void TestLoadPoints::edgeGoesRoundCorners()
{
    const auto points = loadPoints(spreadOver(Spread::Edge, 40), Vec2(100, 80), rectangle(100, 80));
    QVERIFY(std::abs(sumOf(points) - 1.0) < 1e-12);
    Box2 box;
    for (const LoadPoint &point : points) {
        box.extend(point.at);
        QVERIFY(std::abs(point.at.x() - 100.0) < 1e-9 || std::abs(point.at.y() - 80.0) < 1e-9);
    }
    QVERIFY(box.min.x() > 80.0 && box.min.x() < 84.0);
    QVERIFY(box.min.y() > 60.0 && box.min.y() < 64.0);
}

void TestLoadPoints::edgeOfAHole()
{
    Region region = rectangle(100, 80);
    region.holes.push_back({{40, 30}, {40, 50}, {60, 50}, {60, 30}});
    const auto points = loadPoints(spreadOver(Spread::Edge, 10), Vec2(50, 32), region);
    for (const LoadPoint &point : points) {
        QVERIFY(std::abs(point.at.y() - 30.0) < 1e-9);
        QVERIFY(std::abs(point.at.x() - 50.0) <= 5.0);
    }
    QVERIFY((middleOf(points) - Vec2(50, 30)).norm() < 1e-9);
}

void TestLoadPoints::longerThanTheEdge()
{
    const auto points = loadPoints(spreadOver(Spread::Edge, 1e4), Vec2(10, 0), rectangle(100, 80));
    QVERIFY(std::abs(sumOf(points) - 1.0) < 1e-12);
    QVERIFY((middleOf(points) - Vec2(50, 40)).norm() < 10.0); // all the way round
}

/// What a glass presses on with, the feet of its stand carry in any case.
void TestLoadPoints::feetBearTheSame()
{
    Document document =
        io::readDocument(QStringLiteral(FFF_SAMPLES "/glass_four_legs.fff")).value().document;
    std::vector<double> first;
    for (const Spread spread : {Spread::Point, Spread::Patch, Spread::Hanging}) {
        for (Load &load : document.loads) {
            load.spread = spread;
            load.width = 40.0;
            load.position += Vec2(0.01, 0.02); // beside all symmetries
        }
        const Analysis analysis = analysed(evaluate(document));
        StrengthCaches caches;
        const Strength strength = forcesIn(analysis, {}, caches);
        std::vector<double> forces;
        double sum = 0.0;
        for (const FootForce &foot : strength.equilibrium().feet) {
            forces.push_back(foot.force.y());
            sum += foot.force.y();
        }
        double weight = document.loads.front().mass;
        for (const Body &body : analysis.bodies)
            weight += body.mass().mass;
        QVERIFY(std::abs(sum - 9.81 * weight) < 1e-9 * sum);
        for (Load &load : document.loads)
            load.position -= Vec2(0.01, 0.02);
        if (first.empty())
            first = forces;
        QCOMPARE(forces.size(), first.size());
        for (std::size_t i = 0; i < first.size(); ++i)
            QVERIFY(std::abs(forces[i] - first[i]) < 1e-6);
    }
}

FFF_TEST(TestLoadPoints)
#include "tst_load_points.moc"
