// Arcs in place of curves. If this fails, what is cut is not what was drawn.
#include "core/geometry/arc_fit.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <QTest>

#include <algorithm>
#include <random>

using namespace fff;
using namespace fff::test;

class TestArcFit : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void arcsStayWithinTheTolerance_data();
    void arcsStayWithinTheTolerance();
    void circlesAreArcs();
    void edgesStayEdges();
    void pathsAreClosedAndWithoutDust();
    void boundsAndLengthAreThoseOfTheArcs();
    void reversedIsTheSameLine();
};

namespace {

double distanceToArcs(const Vec2 &p, const Vec2 &start, const ArcStep &step)
{
    if (step.bulge == 0.0) {
        const Vec2 way = step.end - start;
        const double t = std::clamp((p - start).dot(way) / way.squaredNorm(), 0.0, 1.0);
        return (p - start - t * way).norm();
    }
    const Arc arc = arcOf(start, step);
    const Vec2 out = p - arc.center;
    const double middle = arc.from + 0.5 * arc.sweep;
    const double off = std::remainder(std::atan2(out.y(), out.x()) - middle, 2.0 * M_PI);
    return std::abs(off) <= 0.5 * std::abs(arc.sweep)
               ? std::abs(out.norm() - arc.radius)
               : std::min((p - start).norm(), (p - step.end).norm());
}

double distanceToArcs(const Vec2 &p, const Vec2 &start, const std::vector<ArcStep> &steps)
{
    double least = 1e9;
    Vec2 at = start;
    for (const ArcStep &step : steps) {
        least = std::min(least, distanceToArcs(p, at, step));
        at = step.end;
    }
    return least;
}

Vec2 pointOf(const Vec2 &start, const ArcStep &step, double share)
{
    return step.bulge == 0.0 ? Vec2(start + share * (step.end - start))
                             : arcOf(start, step).at(share);
}

/// Plain, with loops and cusps, without handles, flat, tiny.
std::vector<CubicBezier> curvesOf(const char *kind)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> anywhere(-50.0, 50.0), near(-0.004, 0.004);
    const auto point = [&] { return Vec2(anywhere(random), anywhere(random)); };
    const std::string_view name = kind;
    std::vector<CubicBezier> curves;
    for (int i = 0; i < 60; ++i) {
        CubicBezier curve{point(), point(), point(), point()};
        if (name == "without a handle")
            curve.p1 = curve.p0;
        else if (name == "without handles")
            curve = {curve.p0, curve.p0, curve.p3, curve.p3};
        else if (name == "loops")
            curve.p3 = curve.p0;
        else if (name == "nearly straight")
            for (Vec2 *handle : {&curve.p1, &curve.p2})
                *handle = curve.p0 + 0.5 * (curve.p3 - curve.p0) +
                          Vec2(20.0 * near(random), 20.0 * near(random));
        else if (name == "smaller than the tolerance")
            for (Vec2 *p : {&curve.p1, &curve.p2, &curve.p3})
                *p = curve.p0 + Vec2(near(random), near(random));
        else if (name == "back and forth")
            curve = {curve.p0, curve.p0 + 2.0 * (curve.p3 - curve.p0),
                     curve.p0 - (curve.p3 - curve.p0), curve.p3};
        curves.push_back(curve);
    }
    return curves;
}

} // namespace

void TestArcFit::arcsStayWithinTheTolerance_data()
{
    QTest::addColumn<double>("tolerance");
    for (const char *kind : {"anyhow", "without a handle", "without handles", "loops",
                             "nearly straight", "smaller than the tolerance", "back and forth"})
        QTest::newRow(kind) << kArcError;
    QTest::newRow("anyhow, finely") << 1e-4;
}

// Both ways: the curve near the arcs, and the arcs near the curve.
void TestArcFit::arcsStayWithinTheTolerance()
{
    QFETCH(double, tolerance);
    const double most = tolerance * (1.0 + 1e-6);
    for (const CubicBezier &curve : curvesOf(QTest::currentDataTag())) {
        std::vector<ArcStep> steps;
        appendArcs(curve, tolerance, steps);
        if (curve.p0 != curve.p3)
            QVERIFY(!steps.empty() && steps.back().end == curve.p3);
        if (steps.empty())
            continue;
        constexpr int kSamples = 400;
        std::vector<Vec2> points;
        for (int i = 0; i <= kSamples; ++i) {
            points.push_back(curve.at(static_cast<double>(i) / kSamples));
            const double away = distanceToArcs(points.back(), curve.p0, steps);
            QVERIFY2(away <= most, qPrintable(QString::number(away)));
        }
        Vec2 at = curve.p0;
        for (const ArcStep &step : steps) {
            QVERIFY(step.end != at);
            for (const double share : {0.25, 0.5, 0.75}) {
                const Vec2 p = pointOf(at, step, share);
                double least = 1e9; // to the chords of the samples, which are off by little
                for (std::size_t i = 0; i + 1 < points.size(); ++i)
                    if (points[i] != points[i + 1])
                        least = std::min(least, distanceToArcs(p, points[i], {points[i + 1], 0.0}));
                QVERIFY2(least <= most + 0.01, qPrintable(QString::number(least)));
            }
            at = step.end;
        }
    }
}

// A quarter of a circle that four cubics stand for is one arc, as long as they are good enough.
void TestArcFit::circlesAreArcs()
{
    const Contour round = circle({3, 4}, 10.0);
    std::vector<CubicBezier> curves;
    for (int i = 0; i < 4; ++i)
        curves.push_back(round.segment(i));
    const ArcPath path = arcsAlong(curves, true);
    QCOMPARE(path.steps.size(), std::size_t(4));
    for (const ArcStep &step : path.steps)
        QVERIFY(std::abs(step.bulge - std::tan(M_PI / 8.0)) < 1e-3);
    QVERIFY(std::abs(path.length() - 20.0 * M_PI) < 0.01);
}

void TestArcFit::edgesStayEdges()
{
    std::vector<ArcStep> steps;
    appendArcs(CubicBezier::line({0, 0}, {500, 1}), kArcError, steps);
    QCOMPARE(steps.size(), std::size_t(1));
    QCOMPARE(steps[0].bulge, 0.0);
}

void TestArcFit::pathsAreClosedAndWithoutDust()
{
    const Vec2 a(0, 0), b(10, 0), c(10, 10);
    const Vec2 dust = b + Vec2(3e-6, 0);
    const ArcPath path = arcsAlong(std::vector{CubicBezier::line(a, b), CubicBezier::line(b, dust),
                                               CubicBezier::line(dust, c), CubicBezier::line(c, a)},
                                   true);
    QCOMPARE(path.steps.size(), std::size_t(3));
    QVERIFY(path.end() == path.start);
    QVERIFY(arcsAlong({}, false).steps.empty());
}

void TestArcFit::boundsAndLengthAreThoseOfTheArcs()
{
    // Three quarters of the unit circle, from the right counter-clockwise to below.
    const ArcPath path{{1, 0}, {{{-1, 0}, 1.0}, {{0, -1}, std::tan(M_PI / 8.0)}}, false};
    QVERIFY(std::abs(path.length() - 1.5 * M_PI) < 1e-12);
    const Box2 box = path.bounds();
    QVERIFY((box.min - Vec2(-1, -1)).norm() < 1e-12 && (box.max - Vec2(1, 1)).norm() < 1e-12);
}

void TestArcFit::reversedIsTheSameLine()
{
    std::vector<ArcStep> steps;
    appendArcs({{0, 0}, {10, 30}, {40, -30}, {50, 10}}, kArcError, steps);
    const ArcPath path{{0, 0}, steps, false}, back = path.reversed();
    QVERIFY(back.start == path.end() && back.end() == path.start);
    QVERIFY(std::abs(back.length() - path.length()) < 1e-9);
    QVERIFY((back.bounds().max - path.bounds().max).norm() < 1e-9);
}

FFF_TEST(TestArcFit)
#include "tst_arc_fit.moc"
