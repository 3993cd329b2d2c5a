#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/geometry/contour.h"
#include "core/geometry/fit.h"
#include "tests/core/geometry/polyline_distance.h"
#include "tests/core/geometry/samples.h"
#include "tests/test_program.h"

#include <cmath>
#include <numbers>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

constexpr double kChord = 0.02; // mm, of the curves in the comparisons below

Samples circle(double radius, int count)
{
    Samples samples;
    for (int i = 0; i <= count; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / count;
        samples.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return samples;
}

Samples scribble(unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> count(3, 200);
    std::normal_distribution<double> step(0.0, 3.0);
    Samples samples{Vec2::Zero()};
    Vec2 velocity(1.0, 0.0);
    for (int i = count(random); i > 0; --i) {
        velocity = 0.7 * velocity + Vec2(step(random), step(random));
        samples.push_back(samples.back() + velocity);
    }
    return samples;
}

/// Pixel positions: what a mouse gives.
Samples rounded(Samples samples)
{
    for (Vec2 &p : samples)
        p = p.array().round().matrix();
    return samples;
}

Samples flattened(const std::vector<CubicBezier> &chain)
{
    Samples line;
    for (const CubicBezier &s : chain) {
        const int count = s.chordCount(kChord);
        for (int i = 0; i <= count; ++i)
            line.push_back(s.at(double(i) / count));
    }
    return line;
}

} // namespace

class TestFit : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void staysWithinTolerance_data();
    void staysWithinTolerance();
    void circleNeedsFewSegments();
    void rectangleKeepsItsCorners_data();
    void rectangleKeepsItsCorners();
    void sparseRectangleKeepsItsEdges();
    void isSmoothBetweenCorners();
    void keepsGivenDirections();
    void straightRunsAreLines();
    void closedCurveIsSmoothAllRound();
    void closedCurveStartsAtACorner();
    void repeatedPointsChangeNothing();
    void degenerateInput_data();
    void degenerateInput();
    void aClosingEdgeIsStraight();
    void closingSegmentIsTangentAndDoesNotLoop();
};

void TestFit::staysWithinTolerance_data()
{
    QTest::addColumn<Samples>("samples");
    QTest::addColumn<double>("tolerance");
    QTest::newRow("circle") << circle(50.0, 300) << 0.5;
    QTest::newRow("circle in pixels") << rounded(circle(200.0, 300)) << 2.0;
    QTest::newRow("tiny circle") << circle(2.0, 40) << 1.0;
    QTest::newRow("sparse circle") << circle(50.0, 9) << 0.5;
    QTest::newRow("line") << Samples{{0, 0}, {100, 30}} << 0.5;
    QTest::newRow("there and back") << lines({{0, 0}, {50, 0}, {0, 0}}, 2.0) << 0.5;
    QTest::newRow("figure of eight") << [] {
        Samples samples;
        for (int i = 0; i <= 300; ++i)
            samples.emplace_back(80.0 * std::sin(i * 0.02), 40.0 * std::sin(i * 0.04));
        return samples;
    }() << 1.0;
    QTest::newRow("halts at the end") << [] {
        // A hand that trembles on the spot makes many samples that are nowhere further on.
        Samples samples = lines({{0, 0}, {20, 0}}, 1.0);
        for (int i = 0; i < 200; ++i)
            samples.emplace_back(20.0 + 0.3 * std::sin(1.7 * i), 0.3 * std::cos(2.3 * i));
        return samples;
    }() << 1.0;
    QTest::newRow("back and forth on the spot")
        << lines({{0, 0}, {3, 0}, {0, 0}, {3, 0}, {0, 0}}, 1.0) << 2.0;
    QTest::newRow("there and back, pixels")
        << rounded(lines({{0, 0}, {0.1, 9}, {0, 0}, {9, 0}}, 1.0)) << 2.0;
    QTest::newRow("leaps across the whole drawing") << [] {
        Samples samples;
        for (int i = 0; i < 60; ++i)
            samples.emplace_back(1e4 * std::sin(7.0 * i), 1e4 * std::cos(11.0 * i));
        return samples;
    }() << 2.0;
    QTest::newRow("zigzag") << lines({{0, 0}, {10, 20}, {20, 0}, {30, 20}, {40, 0}}, 1.0) << 0.5;
    for (unsigned seed = 1; seed <= 40; ++seed)
        QTest::addRow("scribble, seed %u", seed) << scribble(seed) << (seed % 2 ? 0.5 : 2.0);
    for (unsigned seed = 41; seed <= 50; ++seed)
        QTest::addRow("scribble in pixels, seed %u", seed) << rounded(scribble(seed)) << 2.0;
}

/// A sample off the curve by more than the tolerance, or a curve that swings out between samples,
/// is not what was drawn.
void TestFit::staysWithinTolerance()
{
    QFETCH(Samples, samples);
    QFETCH(double, tolerance);
    const auto chain = fitCurve(samples, {.tolerance = tolerance});
    QVERIFY(!chain.empty());
    QCOMPARE(chain.front().p0, samples.front());
    QCOMPARE(chain.back().p3, samples.back());
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
        QCOMPARE(chain[i].p3, chain[i + 1].p0);
    const Samples line = flattened(chain);
    const PolylineDistance toCurve(line), toSamples(samples);
    for (const Vec2 &p : samples)
        QVERIFY2(toCurve(p) <= tolerance + kChord, qPrintable(QString::number(toCurve(p))));
    for (const Vec2 &p : line)
        QVERIFY2(toSamples(p) <= 1.001 * tolerance, qPrintable(QString::number(toSamples(p))));
}

void TestFit::circleNeedsFewSegments()
{
    for (const double noise : {0.0, 0.3}) {
        Samples samples = circle(100.0, 250);
        std::mt19937 random(7);
        std::uniform_real_distribution<double> jitter(-noise, noise);
        for (Vec2 &p : samples)
            p += Vec2(jitter(random), jitter(random));
        const auto chain = fitCurve(samples, {.tolerance = 1.0});
        QVERIFY2(chain.size() <= 4, qPrintable(QString::number(chain.size())));
    }
}

void TestFit::rectangleKeepsItsCorners_data()
{
    QTest::addColumn<Vec2>("start");
    QTest::addColumn<double>("step");
    QTest::newRow("from the middle of an edge") << Vec2(50, 0) << 1.0;
    QTest::newRow("coarse") << Vec2(50, 0) << 5.0;
    QTest::newRow("uneven") << Vec2(37, 0) << 3.7;
}

void TestFit::rectangleKeepsItsCorners()
{
    QFETCH(Vec2, start);
    QFETCH(double, step);
    const Samples corners{{100, 0}, {100, 60}, {0, 60}, {0, 0}};
    Samples way{start};
    way.insert(way.end(), corners.begin(), corners.end());
    way.push_back(start);
    const auto chain = fitCurve(lines(way, step), {.tolerance = 1.0});
    int kept = 0;
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
        const Vec2 in = endDirection(chain[i]), out = startDirection(chain[i + 1]);
        for (const Vec2 &corner : corners)
            if ((chain[i].p3 - corner).norm() < 1e-9 && std::abs(in.dot(out)) < 1e-6)
                ++kept;
    }
    QCOMPARE(kept, 4);
    for (const CubicBezier &s : chain)
        QVERIFY(s.isStraight(1e-6));
    QCOMPARE(chain.size(), std::size_t(5));
}

/// Five clicks' worth of samples are a rectangle, not a balloon.
void TestFit::sparseRectangleKeepsItsEdges()
{
    const auto chain = fitCurve({{50, 0}, {100, 0}, {100, 60}, {0, 60}, {0, 0}, {49, 0}});
    QCOMPARE(chain.size(), std::size_t(5));
    for (const CubicBezier &s : chain)
        QVERIFY(s.isStraight(1e-6));
}

void TestFit::isSmoothBetweenCorners()
{
    Samples samples;
    for (int i = 0; i <= 400; ++i)
        samples.emplace_back(0.5 * i, 30.0 * std::sin(i * 0.03));
    const auto chain = fitCurve(samples, {.tolerance = 0.2});
    QVERIFY(chain.size() > 2);
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
        QVERIFY((endDirection(chain[i]) - startDirection(chain[i + 1])).norm() < 1e-9);
}

/// Where a chain has to go on in a certain direction, as at an axis of symmetry.
void TestFit::keepsGivenDirections()
{
    const Samples samples = circle(50.0, 100);
    for (const double slant : {0.0, 0.3, 0.7}) {
        const Vec2 start(std::sin(slant), std::cos(slant)), end(-std::sin(slant), std::cos(slant));
        const auto chain =
            fitCurve(samples, {.tolerance = 1.0, .startDirection = start, .endDirection = end});
        QVERIFY((startDirection(chain.front()) - start).norm() < 1e-12);
        QVERIFY((endDirection(chain.back()) - end).norm() < 1e-12);
        const PolylineDistance toSamples(samples);
        for (const Vec2 &p : flattened(chain))
            QVERIFY(toSamples(p) <= 1.001);
    }
}

/// A side that wavers by a pixel looks like a mistake.
void TestFit::straightRunsAreLines()
{
    Samples samples = lines({{-80, 0}, {80, 0}}, 2.0); // then half a circle, then back
    for (int i = 1; i < 60; ++i) {
        const double angle = -0.5 * std::numbers::pi + std::numbers::pi * i / 60;
        samples.emplace_back(80 + 40 * std::cos(angle), 40 + 40 * std::sin(angle));
    }
    for (const Vec2 &p : lines({{80, 80}, {-80, 80}}, 2.0))
        samples.push_back(p);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> jitter(-0.4, 0.4);
    for (Vec2 &p : samples)
        p += Vec2(jitter(random), jitter(random));
    const auto chain = fitCurve(samples, {.tolerance = 2.0});
    QVERIFY(chain.size() <= 4);
    for (const CubicBezier &s : {chain.front(), chain.back()}) {
        const CubicBezier line = CubicBezier::line(s.p0, s.p3);
        QVERIFY((s.p1 - line.p1).norm() < 1e-9 && (s.p2 - line.p2).norm() < 1e-9);
        QVERIFY((s.p3 - s.p0).norm() > 120.0);
    }
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
        QVERIFY((endDirection(chain[i]) - startDirection(chain[i + 1])).norm() < 1e-9);
}

void TestFit::closedCurveIsSmoothAllRound()
{
    Samples samples = circle(60.0, 150);
    samples.pop_back();
    const auto chain = fitClosedCurve(samples, {.tolerance = 1.0});
    QVERIFY(chain.size() >= 2 && chain.size() <= 4);
    for (std::size_t i = 0; i < chain.size(); ++i) {
        const CubicBezier &next = chain[(i + 1) % chain.size()];
        QCOMPARE(chain[i].p3, next.p0);
        QVERIFY((endDirection(chain[i]) - startDirection(next)).norm() < 1e-9);
    }
    for (const Vec2 &p : flattened(chain))
        QVERIFY(std::abs(p.norm() - 60.0) <= 1.0);
}

void TestFit::closedCurveStartsAtACorner()
{
    const auto chain = fitClosedCurve(
        lines({{50, 0}, {100, 0}, {100, 60}, {0, 60}, {0, 0}, {49, 0}}, 1.0), {.tolerance = 1.0});
    QCOMPARE(chain.size(), std::size_t(4));
    for (std::size_t i = 0; i < 4; ++i) {
        QCOMPARE(chain[i].p3, chain[(i + 1) % 4].p0);
        QVERIFY(chain[i].isStraight(1e-9));
    }
}

void TestFit::repeatedPointsChangeNothing()
{
    const Samples samples = circle(50.0, 60);
    Samples repeated;
    for (const Vec2 &p : samples)
        repeated.insert(repeated.end(), 3, p);
    repeated.insert(repeated.begin() + 10, Vec2(std::nan(""), 0.0));
    const auto a = fitCurve(samples), b = fitCurve(repeated);
    QCOMPARE(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        QVERIFY(a[i].p1 == b[i].p1 && a[i].p2 == b[i].p2 && a[i].p3 == b[i].p3);
}

void TestFit::degenerateInput_data()
{
    QTest::addColumn<Samples>("samples");
    QTest::addColumn<int>("segments");
    QTest::newRow("nothing") << Samples{} << 0;
    QTest::newRow("one point") << Samples{{3, 4}} << 0;
    QTest::newRow("one point many times") << Samples(20, Vec2(3, 4)) << 0;
    QTest::newRow("not a number") << Samples{{std::nan(""), 0}, {0, 0}} << 0;
    QTest::newRow("two points") << Samples{{0, 0}, {1, 1}} << 1;
}

void TestFit::degenerateInput()
{
    QFETCH(Samples, samples);
    QFETCH(int, segments);
    QCOMPARE(static_cast<int>(fitCurve(samples).size()), segments);
}

/// An edge that was not drawn to its end ends there, at the corner that it points to.
void TestFit::aClosingEdgeIsStraight()
{
    const auto closingOf = [](const Samples &line) {
        std::vector<CubicBezier> chain;
        for (std::size_t i = 0; i + 1 < line.size(); ++i)
            chain.push_back(CubicBezier::line(line[i], line[i + 1]));
        return closingSegment(chain);
    };
    QVERIFY(closingOf({{0, 0}, {80, 0}, {80, 60}, {0, 60}, {0, 10}}).isStraight(1e-9));
    QVERIFY(closingOf({{0, 0}, {80, 0}, {80, 60}, {-1, 61}, {1, 10}}).isStraight(1e-9));
    QVERIFY(closingOf({{0, 10}, {0, 60}, {80, 60}, {80, 0}, {0, 0}}).isStraight(1e-9));
    // A smooth line goes on smoothly.
    QVERIFY(!closingOf({{0, 0}, {40, 0}, {60, 20}, {60, 60}, {0, 60}, {-10, 10}}).isStraight(1e-9));
}

/// Whatever the directions at its ends, however short it is.
void TestFit::closingSegmentIsTangentAndDoesNotLoop()
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (int i = 0; i < 200; ++i) {
        const double size = i % 2 ? 10.0 : 1e-3;
        const Vec2 from(any(random), any(random));
        const Vec2 to = from + size * Vec2(any(random), any(random));
        const Vec2 in(any(random), any(random)), out(any(random), any(random));
        const std::vector<CubicBezier> chain{CubicBezier::line(to, to + out),
                                             CubicBezier::line(to + out, from - in),
                                             CubicBezier::line(from - in, from)};
        const CubicBezier closing = closingSegment(chain);
        QCOMPARE(closing.p0, from);
        QCOMPARE(closing.p3, to);
        if (closing.isStraight(1e-9))
            continue;
        QVERIFY(std::abs(cross(closing.p1 - closing.p0, in)) < 1e-9 * size);
        QVERIFY((closing.p1 - closing.p0).dot(in) > 0.0);
        QVERIFY((closing.p3 - closing.p2).dot(out) > 0.0);
        // A loop would make two chords that are no neighbours meet.
        Samples line;
        for (int k = 0; k <= 64; ++k)
            line.push_back(closing.at(k / 64.0));
        for (std::size_t a = 0; a + 1 < line.size(); ++a)
            for (std::size_t b = a + 2; b + 1 < line.size(); ++b) {
                const auto side = [](const Vec2 &p, const Vec2 &q, const Vec2 &r) {
                    return cross(q - p, r - p);
                };
                const bool meets =
                    side(line[a], line[a + 1], line[b]) * side(line[a], line[a + 1], line[b + 1]) <
                        0.0 &&
                    side(line[b], line[b + 1], line[a]) * side(line[b], line[b + 1], line[a + 1]) <
                        0.0;
                QVERIFY(!meets);
            }
    }
}

FFF_TEST(TestFit)
#include "tst_fit.moc"
