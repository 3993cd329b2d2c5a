#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/base/units.h"
#include "core/stroke/stroke.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <cmath>
#include <numbers>
#include <random>

using namespace fff;
using State = Stroke::State;

namespace {

bool isNear(const Vec2 &a, const Vec2 &b)
{
    return (a - b).norm() < 1e-9;
}

ShapePointer plate()
{
    return *Shape::make(*Contour::fromPolygon({{-50, -50}, {50, -50}, {50, 50}, {-50, 50}}),
                        {*Contour::fromPolygon({{10, -5}, {10, 5}, {20, 5}, {20, -5}})});
}

Contour disc()
{
    return test::circle({0, 0}, 50);
}

const Stroke::Options kOptions{800.0, 5.0, {.tolerance = 0.5}};

/// Out through the right edge at y = -20, 60 mm long, leaving at 10 ms.
Stroke leftAtTheRight()
{
    Stroke stroke(kOptions);
    stroke.beginInSection(plate(), {0.0, {-10, -20}});
    stroke.move({5.0, {30, -20}});
    stroke.move({10.0, {70, -20}});
    return stroke;
}

void circle(Stroke &stroke, const Vec2 &centre, double radius, double time)
{
    for (int i = 0; i <= 100; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 100.0;
        stroke.move({time + i, centre + radius * Vec2(std::cos(angle), std::sin(angle))});
    }
}

} // namespace

class TestStroke : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void leavingPointLiesOnTheCurve();
    void leavesIntoAHole();
    void jumpsOverAHoleStillLeave();
    void edgeOfThePlate();
    void goesThroughAllStates();
    void contourBeginsOnTheDeadZonesBorder();
    void turnPositionsAreNotDrawn();
    void refusals();
    void cancelsInEveryState();
    void turnIsEased();
    void withoutATurnTime();
    void contourIsAFunctionOfTheSamples();
    void lineEnclosesNothing_data();
    void lineEnclosesNothing();
    void crossingKeepsTheLargestLoop();
};

void TestStroke::leavingPointLiesOnTheCurve()
{
    const Interior inside(*Shape::make(disc()));
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (int i = 0; i < 200; ++i) {
        const Vec2 from(30 * any(random), 30 * any(random));
        const Vec2 to = from + 200.0 * Vec2(any(random), any(random)).normalized();
        const std::optional<Vec2> point = inside.leavingPoint(from, to);
        QVERIFY(point);
        QVERIFY(std::abs(cross(to - from, *point - from)) / (to - from).norm() < 1e-9);
        // The cubic circle itself is off by 0.014 mm; the point is on it, not on chords: a Newton
        // search for the nearest curve point finds none further than rounding.
        double best = 1e9;
        for (int s = 0; s < 4; ++s) {
            const CubicBezier curve = disc().segment(s);
            for (int k = 0; k <= 20; ++k) {
                double t = k / 20.0;
                for (int n = 0; n < 20; ++n) {
                    const Vec2 off = curve.at(t) - *point, d = curve.derivative(t);
                    t = std::clamp(t - off.dot(d) / d.squaredNorm(), 0.0, 1.0);
                }
                best = std::min(best, (curve.at(t) - *point).norm());
            }
        }
        QVERIFY2(best < 1e-9, qPrintable(QString::number(best)));
    }
    QVERIFY(!inside.leavingPoint({0, 0}, {20, 20}));
}

void TestStroke::leavesIntoAHole()
{
    const Interior inside(plate());
    QVERIFY(isNear(*inside.leavingPoint({0, 0}, {15, 0}), {10, 0}));
}

void TestStroke::jumpsOverAHoleStillLeave()
{
    const Interior inside(plate());
    QVERIFY(isNear(*inside.leavingPoint({0, 0}, {40, 0}), {10, 0}));
}

/// Begun on the very edge: inwards is a way inside, outwards leaves at once.
void TestStroke::edgeOfThePlate()
{
    const Interior inside(plate());
    QVERIFY(!inside.leavingPoint({50, 20}, {30, 20}));
    QCOMPARE(*inside.leavingPoint({50, 20}, {60, 20}), Vec2(50, 20));
    QVERIFY(isNear(*inside.leavingPoint({50, 20}, {-70, 20}), {-50, 20}));
}

void TestStroke::goesThroughAllStates()
{
    Stroke stroke(kOptions);
    QCOMPARE(stroke.state(), State::Idle);
    stroke.beginInSection(plate(), {0.0, {-10, -20}});
    QCOMPARE(stroke.state(), State::Slit);
    stroke.move({5.0, {30, -20}});
    QCOMPARE(stroke.state(), State::Slit);
    QCOMPARE(stroke.slitTo(), Vec2(30, -20));
    stroke.move({10.0, {70, -20}});
    QCOMPARE(stroke.state(), State::Turn);
    QVERIFY(isNear(stroke.slitTo(), {50, -20}));
    QVERIFY(std::abs(stroke.slitLength() - 60.0) < 1e-9);
    stroke.advance(809.0);
    QCOMPARE(stroke.state(), State::Turn);
    stroke.advance(810.0);
    QCOMPARE(stroke.state(), State::DeadZone);
    stroke.move({820.0, {30, 4}});
    QCOMPARE(stroke.state(), State::DeadZone);
    stroke.move({830.0, {30, 30}});
    QCOMPARE(stroke.state(), State::Contour);
    circle(stroke, {30, 60}, 30.0, 840.0);
    stroke.release();
    QCOMPARE(stroke.state(), State::Done);
    QVERIFY(stroke.contour().contour);
    const double area = std::abs(stroke.contour().contour->signedArea());
    // The largest loop: the disc but for what the way across it to where the circle begins cuts
    // off. The end of the circle, beyond where it comes nearest to the start of the way, goes.
    QVERIFY(area > 780.0 * std::numbers::pi);
    QVERIFY(area < 1000.0 * std::numbers::pi);
}

void TestStroke::contourBeginsOnTheDeadZonesBorder()
{
    Stroke stroke = leftAtTheRight();
    stroke.advance(900.0);
    stroke.move({910.0, {80, 40}}); // one jump, out beyond the slit's end
    QCOMPARE(stroke.samples().size(), std::size_t(2));
    QVERIFY(std::abs((stroke.samples().front() - Vec2(60, 0)).norm() - 5.0) < 1e-9);
    QVERIFY(std::abs(cross(Vec2(20, 40), stroke.samples().front() - Vec2(60, 0))) < 1e-9);
}

void TestStroke::turnPositionsAreNotDrawn()
{
    Stroke stroke = leftAtTheRight();
    stroke.move({100.0, {500, 500}});
    stroke.move({200.0, {-500, 500}});
    stroke.advance(900.0);
    QCOMPARE(stroke.state(), State::DeadZone);
    QVERIFY(stroke.samples().empty());
    QVERIFY(isNear(stroke.slitTo(), {50, -20}));
}

void TestStroke::refusals()
{
    Stroke inSlit(kOptions);
    inSlit.beginInSection(plate(), {0.0, {0, 0}});
    inSlit.move({5.0, {5, 5}});
    inSlit.release();
    QCOMPARE(inSlit.state(), State::Cancelled);
    QCOMPARE(inSlit.refusal(), Stroke::Refusal::NeverLeft);

    Stroke inTurn = leftAtTheRight();
    inTurn.release();
    QCOMPARE(inTurn.refusal(), Stroke::Refusal::TooShort);

    Stroke inDeadZone = leftAtTheRight();
    inDeadZone.advance(900.0);
    inDeadZone.move({910.0, {40, 1}});
    inDeadZone.release();
    QCOMPARE(inDeadZone.refusal(), Stroke::Refusal::TooShort);

    Stroke tiny = leftAtTheRight();
    tiny.advance(900.0);
    tiny.move({910.0, {40, 5.5}});
    tiny.release();
    QCOMPARE(tiny.refusal(), Stroke::Refusal::TooShort);

    Stroke fromTheEdge(kOptions);
    fromTheEdge.beginInSection(plate(), {0.0, {50, 20}});
    fromTheEdge.move({5.0, {70, 20}});
    QCOMPARE(fromTheEdge.refusal(), Stroke::Refusal::TooShort);
}

void TestStroke::cancelsInEveryState()
{
    for (int phase = 0; phase < 4; ++phase) {
        Stroke stroke(kOptions);
        stroke.beginInSection(plate(), {0.0, {-10, -20}});
        if (phase > 0)
            stroke.move({10.0, {70, -20}});
        if (phase > 1)
            stroke.advance(900.0);
        if (phase > 2)
            stroke.move({910.0, {80, 40}});
        stroke.cancel();
        QCOMPARE(stroke.state(), State::Cancelled);
        QCOMPARE(stroke.refusal(), Stroke::Refusal::None);
        stroke.move({920.0, {90, 50}});
        stroke.release();
        QCOMPARE(stroke.state(), State::Cancelled);
    }
}

void TestStroke::turnIsEased()
{
    Stroke stroke = leftAtTheRight(); // leaves at 10 ms
    QCOMPARE(stroke.turnProgress(10.0), 0.0);
    QCOMPARE(stroke.turnProgress(410.0), 0.5);
    QVERIFY(stroke.turnProgress(210.0) < 0.25);
    QVERIFY(stroke.turnProgress(610.0) > 0.75);
    stroke.advance(810.0);
    QCOMPARE(stroke.turnProgress(810.0), 1.0);
}

void TestStroke::withoutATurnTime()
{
    Stroke stroke({0.0, 5.0, {.tolerance = 0.5}});
    stroke.beginInSection(plate(), {0.0, {-10, -20}});
    stroke.move({10.0, {70, -20}});
    QCOMPARE(stroke.state(), State::Turn);
    stroke.advance(10.0);
    QCOMPARE(stroke.state(), State::DeadZone);
}

/// What is seen before the release is what is made by it; repeated and broken samples do nothing.
void TestStroke::contourIsAFunctionOfTheSamples()
{
    Stroke once(kOptions), twice(kOptions);
    once.beginOnCanvas({0.0, {30, 0}});
    twice.beginOnCanvas({0.0, {30, 0}});
    for (int i = 1; i <= 90; ++i) {
        const double angle = radians(4.0 * i);
        const Vec2 p(30 * std::cos(angle), 30 * std::sin(angle));
        once.move({8.0 * i, p});
        twice.move({8.0 * i, p});
        twice.move({8.0 * i, p});
        twice.move({8.0 * i, {std::nan(""), 0.0}});
        QVERIFY(!twice.contour().fitted.empty());
    }
    const Contour before = *once.contour().contour;
    once.release();
    QCOMPARE(once.state(), State::Done);
    QVERIFY(*once.contour().contour == before);
    QVERIFY(*twice.contour().contour == before);
}

void TestStroke::lineEnclosesNothing_data()
{
    QTest::addColumn<std::vector<Vec2>>("way");
    QTest::newRow("one sample") << std::vector<Vec2>{{0, 0}};
    QTest::newRow("straight") << std::vector<Vec2>{{0, 0}, {50, 0}, {100, 0}};
    QTest::newRow("there and back") << std::vector<Vec2>{{0, 0}, {100, 0}, {0, 0}};
    QTest::newRow("shaky line") << std::vector<Vec2>{{0, 0}, {30, 0.3}, {60, -0.2}, {90, 0.1}};
    QTest::newRow("dot") << std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
}

void TestStroke::lineEnclosesNothing()
{
    QFETCH(std::vector<Vec2>, way);
    Stroke stroke(kOptions);
    stroke.beginOnCanvas({0.0, way.front()});
    for (const Vec2 &p : way)
        stroke.move({0.0, p});
    QVERIFY(!stroke.contour().contour);
    stroke.release();
    QCOMPARE(stroke.refusal(), Stroke::Refusal::TooShort);
}

void TestStroke::crossingKeepsTheLargestLoop()
{
    // A figure of eight, its right loop larger.
    std::vector<Vec2> samples;
    for (int i = 0; i < 200; ++i) {
        const double a = 2.0 * std::numbers::pi * i / 200.0;
        const double size = std::cos(a) > 0.0 ? 60.0 : 25.0;
        samples.emplace_back(size * std::cos(a), 0.7 * size * std::sin(2.0 * a));
    }
    const StrokeContour stroke = strokeContour(samples, {.tolerance = 0.3});
    QVERIFY(stroke.contour);
    QVERIFY(stroke.wasCrossing);
    const Box2 box = bounds(stroke.contour->flatten(0.1).points);
    QVERIFY2(box.min.x() > -1.0, qPrintable(QString::number(box.min.x())));
    QVERIFY(std::abs(box.max.x() - 60.0) < 0.5);
}

FFF_TEST(TestStroke)
#include "tst_stroke.moc"
