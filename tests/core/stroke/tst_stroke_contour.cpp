#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/geometry/fit.h"
#include "core/stroke/stroke_contour.h"
#include "tests/core/geometry/polyline_distance.h"
#include "tests/core/geometry/samples.h"
#include "tests/core/geometry/turns.h"
#include "tests/test_program.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

using Refusal = StrokeContour::Refusal;

constexpr double kPi = std::numbers::pi;
constexpr double kTolerance = 2.0;

/// Once round at radius 100; `round` is how far, `widening` by how much further out at the end.
Samples circle(double round, double widening)
{
    return curve([=](double t) {
        const double angle = 0.3 + 2.0 * kPi * round * t;
        const double radius = 100.0 + widening * t;
        return Vec2(radius * std::cos(angle), radius * std::sin(angle));
    });
}

StrokeContour contourOf(const Samples &samples)
{
    return strokeContour(samples, {.tolerance = kTolerance});
}

/// The sharpest curve of the contour: least radius, mm. Corners are none.
double leastRadius(const Contour &contour)
{
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < contour.segmentCount(); ++i) {
        const CubicBezier s = contour.segment(i);
        for (int k = 0; k <= 100; ++k) {
            const Vec2 d1 = s.derivative(k / 100.0), d2 = s.secondDerivative(k / 100.0);
            const double bend = std::abs(cross(d1, d2));
            if (bend > 0.0)
                least = std::min(least, std::pow(d1.norm(), 3.0) / bend);
        }
    }
    return least;
}

double sharpestJoint(const Contour &contour)
{
    const std::vector<double> turns = turnsOf(contour);
    return *std::max_element(turns.begin(), turns.end());
}

} // namespace

class TestStrokeContour : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void closesWithoutADent_data();
    void closesWithoutADent();
    void oneLongMoveEndsIt();
    void straightEdgeWhereThePenBeganIsOne_data();
    void straightEdgeWhereThePenBeganIsOne();
    void wideGapIsClosedTangentially();
    void crossingKeepsTheLargestLoop();
    void refusals_data();
    void refusals();
    void staysWithinTheBound();
};

void TestStrokeContour::closesWithoutADent_data()
{
    QTest::addColumn<double>("round");
    QTest::addColumn<double>("widening");
    QTest::newRow("ends where it began") << 1.0 << 0.0;
    QTest::newRow("stops short") << 0.985 << 0.0;
    QTest::newRow("goes on beside its start") << 1.02 << 0.0;
    QTest::newRow("ends further out") << 1.0 << 5.0;
    QTest::newRow("stops short, further in") << 0.985 << -5.0;
    QTest::newRow("goes on, further out") << 1.02 << 6.0;
    QTest::newRow("goes on, further in") << 1.02 << -6.0;
}

/// A circle by hand never ends where it began.
void TestStrokeContour::closesWithoutADent()
{
    QFETCH(double, round);
    QFETCH(double, widening);
    const StrokeContour stroke = contourOf(circle(round, widening));
    QVERIFY(stroke.contour && !stroke.wasCrossing && !stroke.closing);
    QVERIFY2(stroke.contour->segmentCount() <= 4,
             qPrintable(QString::number(stroke.contour->segmentCount())));
    QVERIFY(sharpestJoint(*stroke.contour) < 1e-9);
    QVERIFY2(leastRadius(*stroke.contour) > 40.0,
             qPrintable(QString::number(leastRadius(*stroke.contour))));
    const double area = std::abs(stroke.contour->signedArea());
    QVERIFY(std::abs(area - kPi * 100.0 * 100.0) < 2.0 * kPi * 100.0 * (1.5 + std::abs(widening)));
}

// Wrong: with a last move so long that no sample lies near the start, the line is cut after its
// last one, where there is nothing to read (seen under the address sanitizer).
void TestStrokeContour::oneLongMoveEndsIt()
{
    for (const double far : {1e3, 1e6}) { // mm
        Samples samples = circle(0.9, 0.0);
        samples.push_back({-far, 0.0});
        samples.push_back(samples.front());
        const StrokeContour drawn = contourOf(samples);
        QVERIFY(drawn.contour);
        QVERIFY(std::abs(drawn.contour->signedArea()) > 100.0 * 100.0);
    }
}

void TestStrokeContour::straightEdgeWhereThePenBeganIsOne_data()
{
    QTest::addColumn<Samples>("way");
    const Samples corners{{200, 0}, {200, 120}, {0, 120}, {0, 0}};
    const auto row = [&](const char *name, const Vec2 &start, const Vec2 &end) {
        Samples way{start};
        way.insert(way.end(), corners.begin(), corners.end());
        way.push_back(end);
        QTest::newRow(name) << way;
    };
    row("ends where it began", {90, 0}, {90, 0});
    row("stops short", {90, 0}, {72, 0});
    row("goes on beside its start", {90, 0}, {105, 1});
    row("ends higher", {90, 0}, {88, 3});
    QTest::newRow("from a corner") << Samples{{0, 0}, {200, 0}, {200, 120}, {0, 120}, {0, 0}};
    QTest::newRow("from a corner, stops short of it")
        << Samples{{0, 0}, {200, 0}, {200, 120}, {0, 120}, {0, 9}};
    QTest::newRow("from a corner, goes beyond it")
        << Samples{{0, 0}, {200, 0}, {200, 120}, {0, 120}, {0, -8}};
    QTest::newRow("from a corner, ends beside it")
        << Samples{{0, 0}, {200, 0}, {200, 120}, {-2, 120}, {-2, 3}};
}

/// A rectangle has four edges, wherever one begins to draw it.
void TestStrokeContour::straightEdgeWhereThePenBeganIsOne()
{
    QFETCH(Samples, way);
    const StrokeContour stroke = contourOf(lines(way, 2.0));
    QVERIFY(stroke.contour && !stroke.wasCrossing);
    QCOMPARE(stroke.contour->segmentCount(), 4);
    for (int i = 0; i < 4; ++i) {
        const CubicBezier edge = stroke.contour->segment(i),
                          line = CubicBezier::line(edge.p0, edge.p3);
        QVERIFY((edge.p1 - line.p1).norm() < 1e-9 && (edge.p2 - line.p2).norm() < 1e-9);
    }
    QVERIFY(std::abs(std::abs(stroke.contour->signedArea()) - 200.0 * 120.0) < 1200.0);
}

void TestStrokeContour::wideGapIsClosedTangentially()
{
    const StrokeContour stroke = contourOf(circle(0.8, 0.0));
    QVERIFY(stroke.contour && stroke.closing);
    QCOMPARE(stroke.closing->p0, stroke.fitted.back().p3);
    QCOMPARE(stroke.closing->p3, stroke.fitted.front().p0);
    QVERIFY((startDirection(*stroke.closing) - endDirection(stroke.fitted.back())).norm() < 1e-9);
    QVERIFY((endDirection(*stroke.closing) - startDirection(stroke.fitted.front())).norm() < 1e-9);
    QVERIFY(sharpestJoint(*stroke.contour) < 1e-9);
}

void TestStrokeContour::crossingKeepsTheLargestLoop()
{
    // A figure of eight, its right loop larger.
    const Samples samples = curve([](double t) {
        const double a = 2.0 * kPi * t;
        const double size = std::cos(a) > 0.0 ? 240.0 : 100.0;
        return Vec2(size * std::cos(a), 0.7 * size * std::sin(2.0 * a));
    });
    const StrokeContour stroke = contourOf(samples);
    QVERIFY(stroke.contour && stroke.wasCrossing);
    const Box2 box = bounds(stroke.contour->polygon(0.1));
    QVERIFY(box.min.x() > -kTolerance && std::abs(box.max.x() - 240.0) < 1.5 * kTolerance);
    const Result<ResolvedContour> again = resolveCrossings(*stroke.contour);
    QVERIFY(again && !again->wasCrossing);
}

void TestStrokeContour::refusals_data()
{
    QTest::addColumn<Samples>("samples");
    QTest::addColumn<int>("refusal");
    const auto row = [](const char *name, const Samples &samples, Refusal refusal) {
        QTest::newRow(name) << samples << static_cast<int>(refusal);
    };
    const double nan = std::nan("");
    row("nothing", {}, Refusal::TooShort);
    row("one sample", {{3, 4}}, Refusal::TooShort);
    row("one sample many times", Samples(50, Vec2(3, 4)), Refusal::TooShort);
    row("no numbers", {{nan, 0}, {0, nan}, {nan, nan}}, Refusal::TooShort);
    row("a dot", {{0, 0}, {4, 0}, {4, 4}, {0, 4}}, Refusal::TooShort);
    row("a line", {{0, 0}, {100, 0}}, Refusal::NoArea);
    row("there and back", lines({{0, 0}, {100, 30}, {0, 0}}, 2.0), Refusal::NoArea);
    row("a shaky line", {{0, 0}, {60, 1}, {120, -1}, {180, 0.5}}, Refusal::NoArea);
    row("crosses itself, encloses dots",
        curve([](double t) { return Vec2(100 * t, 1.8 * std::sin(2 * kPi * t)); }),
        Refusal::NoArea);
    row("an eight of two dots", curve([](double t) {
            const double a = 2.0 * kPi * t + 0.4;
            return Vec2(4.8 * std::cos(a), 2.9 * std::sin(2.0 * a));
        }),
        Refusal::CrossesWithoutLoop);
}

/// Nothing is refused without a reason, nothing made of what has no area.
void TestStrokeContour::refusals()
{
    QFETCH(Samples, samples);
    QFETCH(int, refusal);
    const StrokeContour stroke = contourOf(samples);
    QVERIFY(!stroke.contour);
    QCOMPARE(static_cast<int>(stroke.refusal), refusal);
}

/// The whole chain, on samples that are as far apart as those of a quick hand.
void TestStrokeContour::staysWithinTheBound()
{
    std::mt19937 random(4);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (int i = 0; i < 40; ++i) {
        const double a = any(random), b = any(random), c = any(random);
        const Samples samples = curve(
            [&](double t) {
                const double u = 2.0 * kPi * 0.9 * t;
                const double r = 150 + 50 * a * std::sin(2 * u) + 30 * b * std::sin(3 * u + c);
                return Vec2(r * std::cos(u), r * std::sin(u));
            },
            30 + 10 * i);
        const StrokeContour stroke = contourOf(samples);
        QVERIFY(stroke.contour);
        const PolylineDistance toSamples(samples);
        // Between few samples the line bends (filled_line.h).
        const double bend = i < 10 ? 0.5 * kTolerance : 0.0;
        for (const CubicBezier &s : stroke.fitted)
            for (int k = 0; k <= 40; ++k)
                QVERIFY2(
                    toSamples(s.at(k / 40.0)) <= kTolerance + bend,
                    qPrintable(QStringLiteral("%1 in %2").arg(toSamples(s.at(k / 40.0))).arg(i)));
    }
}

FFF_TEST(TestStrokeContour)
#include "tst_stroke_contour.moc"
