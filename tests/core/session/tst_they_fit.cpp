// Parts as they are cut, put in place: made-up pairs of sections at all angles, with contours that
// run in and out, windows, arms and equal heights. If this fails, what was cut does not go
// together.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/base/units.h"
#include "core/session/assembly_plan.h"
#include "tests/core/assembly/plates.h"

#include <numbers>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

constexpr int kPairs = 200;
constexpr double kDepth = 1e-3; // mm

using Random = std::mt19937_64;

double between(Random &random, double low, double high)
{
    return std::uniform_real_distribution<double>(low, high)(random);
}

/// About the origin, in and out three to seven times.
Polygon wavy(Random &random, double radius)
{
    Polygon polygon;
    const double waves = std::floor(between(random, 3.0, 8.0));
    const double phase = between(random, 0.0, 6.0), height = between(random, 0.1, 0.35);
    constexpr int kPoints = 90;
    for (int i = 0; i < kPoints; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kPoints;
        const double r = radius * (1.0 + height * std::sin(waves * angle + phase));
        polygon.push_back(r * Vec2(std::cos(angle), std::sin(angle)));
    }
    return polygon;
}

/// A post at the left with arms to the right, each of which crosses the middle.
Polygon arms(Random &random, double size)
{
    const int count = 2 + static_cast<int>(random() % 2);
    const double step = 2.0 * size / (2 * count - 1);
    Polygon polygon{{-size, -size}};
    for (int i = 0; i < count; ++i) {
        const double reach = between(random, 0.5, 1.0) * size, low = -size + 2 * i * step;
        polygon.push_back({reach, low});
        polygon.push_back({reach, low + step});
        if (i + 1 < count) {
            const double inner = -between(random, 0.4, 0.7) * size;
            polygon.push_back({inner, low + step});
            polygon.push_back({inner, low + 2 * step});
        }
    }
    polygon.push_back({-size, size});
    return polygon;
}

ShapePointer madeUpShape(Random &random)
{
    const double size = between(random, 30.0, 80.0);
    switch (random() % 5) {
    case 0:
        return polygonShape(rectangle(-size, -40, size, 40)); // often as high as the other
    case 1:
        return polygonShape(arms(random, size));
    case 2: { // a window beside the middle
        const double at = between(random, 0.3, 0.5) * size, half = between(random, 3.0, 8.0);
        return polygonShape(wavy(random, size), {rectangle(at - half, -half, at + half, half)});
    }
    default:
        return polygonShape(wavy(random, size));
    }
}

struct Pair
{
    Analysis analysis;
    std::vector<PartRef> parts;
    std::vector<Solid> solids;
    ModelPlan plan;
};

/// Two sections that a joint holds.
Pair madeUpPair(Random &random)
{
    while (true) {
        Document document = newDocument();
        Stock stock = *document.stocks.front();
        stock.thickness = between(random, 2.0, 6.0);
        stock.clearance = 0.0;
        document = *setStock(std::move(document), stock);
        document = withSection(std::move(document), madeUpShape(random), front());
        const double angle = random() % 3 == 0 ? 90.0 : between(random, 20.0, 160.0);
        Frame frame = turned(radians(angle));
        if (random() % 2 == 0)
            frame.origin.y() = between(random, -40.0, 40.0);
        document = withSection(std::move(document), madeUpShape(random), frame);
        AnalysisCaches caches;
        Pair pair{analyse(evaluate(document), caches), {}, {}, {}};
        const JointList &joints = pair.analysis.assembly.joints;
        if (joints.size() != 1 || joints.front().kind == JointKind::None)
            continue; // they do not meet, or only between windows
        pair.solids = solidsOf(pair.analysis, pair.parts);
        pair.plan = planOf(pair.analysis);
        return pair;
    }
}

/// The deepest that solids are in each other, when those of the second section are moved. mm
double depthOf(const Pair &pair, const Vec3 &by = Vec3::Zero())
{
    double deepest = 0.0;
    for (std::size_t i = 0; i < pair.solids.size(); ++i) {
        for (std::size_t k = 0; k < pair.solids.size(); ++k) {
            if (pair.parts[i].section != 0 || pair.parts[k].section != 1)
                continue;
            const auto how =
                interpenetration(pair.solids[i], movedBy(pair.solids[k], by), 0.1 * kDepth);
            if (how)
                deepest = std::max(deepest, how->depth);
        }
    }
    return deepest;
}

} // namespace

class TestTheyFit : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void madeUpPairs_data();
    void madeUpPairs();
};

void TestTheyFit::madeUpPairs_data()
{
    QTest::addColumn<quint64>("seed");
    constexpr int kOfRow = 20;
    for (int first = 0; first < kPairs; first += kOfRow)
        QTest::addRow("pairs %d to %d", first, first + kOfRow - 1)
            << static_cast<quint64>(first + 1);
}

void TestTheyFit::madeUpPairs()
{
    QFETCH(quint64, seed);
    Random random(seed);
    // Contours that meet within the thickness, but beside the line where the middles of both
    // sections cross: there is no overlap on the axis, and so no slit yet.
    int besideTheAxis = 0;
    int withPlan = 0;
    for (int i = 0; i < 20; ++i) {
        const Pair pair = madeUpPair(random);
        const QByteArray name = "pair " + QByteArray::number(i);
        const double depth = depthOf(pair);
        QVERIFY2((depth <= kDepth) == pair.plan.overlaps.empty(),
                 name + ": in each other by " + QByteArray::number(depth));
        if (depth > kDepth) { // and said to be so
            ++besideTheAxis;
            continue;
        }

        // The slits' bottoms touch: a little further and they are in each other.
        const Joint &joint = pair.analysis.assembly.joints.front();
        const std::vector<Slide> slides = slidesOf(pair.analysis, pair.parts);
        const double angle = joint.crossing->angle;
        if (joint.kind != JointKind::Mortise && std::abs(angle - radians(90.0)) < 1e-9) {
            const Vec3 onwards = -3.0 * kDepth * slides.front().direction;
            QVERIFY2(depthOf(pair, onwards) > kDepth, name + ": its slits leave a gap");
        }

        if (pair.plan.plan.verdict != AssemblyPlan::Verdict::Possible || pair.parts.size() != 2)
            continue;
        ++withPlan;
        const AssemblyStep &step = pair.plan.plan.steps.back();
        const double sense = step.parts.front() == 1 ? 1.0 : -1.0;
        Vec3 place = Vec3::Zero();
        for (auto move = step.moves.rbegin(); move != step.moves.rend(); ++move) {
            for (int k = 0; k <= 50; ++k) {
                const Vec3 by = place - move->direction * (move->distance * k / 50.0);
                QVERIFY2(depthOf(pair, sense * by) <= kDepth,
                         name + ": they run into each other on their way");
            }
            place -= move->direction * move->distance;
        }
    }
    QVERIFY2(besideTheAxis <= 1, QByteArray::number(besideTheAxis) + " of 20 are in each other");
    QVERIFY2(withPlan >= 15, QByteArray::number(withPlan) + " of 20 had a plan");
}

QTEST_APPLESS_MAIN(TestTheyFit)
#include "tst_they_fit.moc"
