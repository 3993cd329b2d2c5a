#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/geometry/settled_fit.h"
#include "core/stroke/stroke.h"
#include "tests/core/geometry/polyline_distance.h"
#include "tests/test_program.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

using namespace fff;
using namespace fff::test;

// Strokes of a mouse that tells of its place a thousand times a second, and of hands that rest,
// tremble or scribble. What would be wrong: an event that costs more the longer the stroke is, a
// sample that is lost, a curve that changes under what was drawn long ago, or one that depends on
// how often somebody looked. Work is counted, not timed.

namespace {

constexpr double kTolerance = 2.0;
constexpr double kThinned = Stroke::kThinning * kTolerance;
using Line = std::vector<Vec2>;

double any(std::mt19937 &random, double low, double high)
{
    return low + (high - low) * (static_cast<double>(random() >> 5) / 134217728.0);
}

/// Round a middle with bays, once.
Vec2 bays(double u)
{
    const double a = 2.0 * std::numbers::pi * u;
    const double radius = 250.0 + 40.0 * std::sin(3.0 * a) + 20.0 * std::cos(7.0 * a + 0.4);
    return radius * Vec2(std::cos(a), 0.9 * std::sin(a));
}

Line along(const std::function<Vec2(double)> &at, int samples)
{
    Line line;
    for (int i = 0; i <= samples; ++i)
        line.push_back(at(double(i) / samples));
    return line;
}

Line shaken(Line line, double by, unsigned seed = 11)
{
    std::mt19937 random(seed);
    for (Vec2 &p : line) {
        p.x() += any(random, -by, by);
        p.y() += any(random, -by, by);
    }
    return line;
}

Line scribble(int samples)
{
    return along(
        [samples](double u) -> Vec2 {
            const double a = u * samples / 110.0;
            return Vec2(420.0 * std::cos(0.311 * a) * std::cos(a),
                        300.0 * std::sin(0.277 * a + 0.3) * std::sin(1.37 * a));
        },
        samples);
}

Line spiral(int samples)
{
    return along(
        [](double u) -> Vec2 {
            const double a = 2.0 * std::numbers::pi * 12.0 * u;
            return (10.0 + 300.0 * u) * Vec2(std::cos(a), std::sin(a));
        },
        samples);
}

Line straight(int samples)
{
    return along([](double u) -> Vec2 { return Vec2(4000.0 * u, 1000.0 * u); }, samples);
}

Line leaping(int samples)
{
    std::mt19937 random(5);
    Line line = along(bays, samples);
    for (std::size_t i = 0; i < line.size(); i += 97)
        line[i] += Vec2(any(random, -300, 300), any(random, -300, 300));
    return line;
}

Stroke drawn(const Line &line, const std::optional<MirrorAxis> &axis = {})
{
    Stroke::Options options;
    options.contour.tolerance = kTolerance;
    options.contour.axis = axis;
    Stroke stroke(options);
    stroke.beginOnCanvas({0.0, line.front()});
    for (const Vec2 &p : line)
        stroke.move({0.0, p});
    return stroke;
}

Line flattened(const std::vector<CubicBezier> &chain)
{
    Line line;
    for (const CubicBezier &s : chain)
        for (int i = line.empty() ? 0 : 1; i <= 40; ++i)
            line.push_back(s.at(i / 40.0));
    return line;
}

bool isSame(const CubicBezier &a, const CubicBezier &b)
{
    return a.p0 == b.p0 && a.p1 == b.p1 && a.p2 == b.p2 && a.p3 == b.p3;
}

} // namespace

class TestLongStrokes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingIsLost_data() { rows(); }
    void nothingIsLost();
    void fitHoldsForAllSamples_data() { rows(); }
    void fitHoldsForAllSamples();
    void settledPiecesStay_data() { rows(); }
    void settledPiecesStay();
    void looksChangeNothing_data() { rows(); }
    void looksChangeNothing();
    void aTrembleIsNoLine_data();
    void aTrembleIsNoLine();
    void steadyHandsAreFollowed();
    void anEventCostsTheSame_data();
    void anEventCostsTheSame();
    void aHandThatRestsAddsNothing();
    void shortStrokesAreFittedAsOne();
    void closedLongStrokesHaveNoDent();
    void mirroredHalvesKeepWhatIsSettled();
    void scribblesComeApart();

private:
    void rows();
};

void TestLongStrokes::rows()
{
    QTest::addColumn<Line>("line");
    QTest::newRow("a mouse of 1,000 Hz") << along(bays, 10000);
    QTest::newRow("a hand that trembles a little") << shaken(along(bays, 2000), 0.3);
    QTest::newRow("jitter of a tenth of a pixel") << shaken(along(bays, 10000), 0.1);
    QTest::newRow("a scribble") << scribble(6000);
    QTest::newRow("a spiral") << spiral(6000);
    QTest::newRow("a straight line") << straight(8000);
    QTest::newRow("leaps") << leaping(5000);
}

/// No sample is further from the line that is kept than it may be.
void TestLongStrokes::nothingIsLost()
{
    QFETCH(Line, line);
    const Stroke stroke = drawn(line);
    const PolylineDistance toKept(stroke.samples());
    double worst = 0.0;
    for (const Vec2 &p : line)
        worst = std::max(worst, toKept(p));
    QVERIFY2(worst <= kThinned + 1e-9, qPrintable(QString::number(worst)));
    QCOMPARE(stroke.samples().front(), line.front());
}

/// The curve is as near to what the hand drew as ever, also to samples that were left out.
void TestLongStrokes::fitHoldsForAllSamples()
{
    QFETCH(Line, line);
    const Stroke stroke = drawn(line);
    const std::vector<CubicBezier> chain = fitAround(
        stroke.meant().points(), stroke.meant().settled().pieces(), {.tolerance = kTolerance});
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
        QCOMPARE(chain[i].p3, chain[i + 1].p0);
    const Line flat = flattened(chain);
    const PolylineDistance toCurve(flat), toLine(line);
    double off = 0.0, over = 0.0;
    for (const Vec2 &p : line)
        off = std::max(off, toCurve(p));
    for (const Vec2 &p : flat)
        over = std::max(over, toLine(p));
    constexpr double kChord = 0.02;
    QVERIFY2(off <= kTolerance + kThinned + kChord, qPrintable(QString::number(off)));
    QVERIFY2(over <= kTolerance + kThinned + kChord, qPrintable(QString::number(over)));
}

/// What is settled is never touched again, and is part of what is shown.
void TestLongStrokes::settledPiecesStay()
{
    QFETCH(Line, line);
    Stroke::Options options;
    options.contour.tolerance = kTolerance;
    Stroke stroke(options);
    stroke.beginOnCanvas({0.0, line.front()});
    std::vector<FittedPiece> before;
    for (std::size_t i = 0; i < line.size(); ++i) {
        stroke.move({0.0, line[i]});
        const std::vector<FittedPiece> &now = stroke.meant().settled().pieces();
        QVERIFY(now.size() >= before.size());
        if (now.size() == before.size())
            continue;
        for (std::size_t k = 0; k < before.size(); ++k)
            QVERIFY(isSame(now[k].curve, before[k].curve));
        before = now;
        const std::vector<CubicBezier> chain =
            fitAround(stroke.meant().points(), now, {.tolerance = kTolerance});
        for (std::size_t k = 0; k < now.size(); ++k)
            QVERIFY(isSame(chain[k], now[k].curve));
    }
    QVERIFY(stroke.samples().size() <= SettledFit::kLargestWindow || !before.empty());
}

/// A stroke that was looked at after every sample, after some, or at its end only, and the same
/// samples all at once, are one contour.
void TestLongStrokes::looksChangeNothing()
{
    QFETCH(Line, line);
    const Stroke once = drawn(line);
    Stroke::Options options;
    options.contour.tolerance = kTolerance;
    Stroke often(options);
    often.beginOnCanvas({0.0, line.front()});
    for (std::size_t i = 0; i < line.size(); ++i) {
        often.move({0.0, line[i]});
        if (i % 501 == 7)
            (void)often.contour();
    }
    QVERIFY(once.samples() == often.samples());
    const StrokeContour batch = strokeContour(once.samples(), options.contour);
    for (const StrokeContour *other : {&often.contour(), &batch}) {
        QCOMPARE(other->fitted.size(), once.contour().fitted.size());
        for (std::size_t k = 0; k < other->fitted.size(); ++k)
            QVERIFY(isSame(other->fitted[k], once.contour().fitted[k]));
        QCOMPARE(other->contour.has_value(), once.contour().contour.has_value());
        QVERIFY(!other->contour || *other->contour == *once.contour().contour);
    }
}

void TestLongStrokes::aTrembleIsNoLine_data()
{
    QTest::addColumn<int>("samples");
    QTest::addColumn<double>("by");
    QTest::addColumn<unsigned>("seed");
    for (const int samples : {2500, 10000, 40000, 100000})
        for (const double by : {1.0, 1.5, 2.0})
            for (unsigned seed = 1; seed <= (samples < 40000 ? 40u : 2u); ++seed)
                QTest::addRow("%d samples, %g px, seed %u", samples, by, seed)
                    << samples << by << seed;
}

/// What a hand means that trembles by up to a fit's tolerance is what it would draw without: no
/// scribble, as many pieces, and within the tolerance of it.
void TestLongStrokes::aTrembleIsNoLine()
{
    QFETCH(int, samples);
    QFETCH(double, by);
    QFETCH(unsigned, seed);
    const auto meant = [](double u) { return bays(0.995 * u); };
    const Stroke stroke = drawn(shaken(along(meant, samples), by, seed));
    const StrokeContour &contour = stroke.contour(), steady = drawn(along(meant, 400)).contour();
    QVERIFY(contour.contour && steady.contour);
    QVERIFY(!contour.wasCrossing);
    QVERIFY(contour.contour->segmentCount() <= steady.contour->segmentCount() + 6);
    Line flat = contour.contour->polygon(0.05), line = along(meant, 4000);
    flat.push_back(flat.front());
    const Line closed = along(bays, 4000);
    const PolylineDistance toMeant(closed), toCurve(flat);
    double off = 0.0;
    for (const Vec2 &p : flat)
        off = std::max(off, toMeant(p));
    for (const Vec2 &p : line)
        off = std::max(off, toCurve(p));
    QVERIFY2(off <= 1.5 * kTolerance, qPrintable(QString::number(off)));
    QVERIFY2(stroke.samples().size() < 4000, qPrintable(QString::number(stroke.samples().size())));
}

/// Corners, hairs, teeth and pixels are drawn on purpose: each sample is where the hand is.
void TestLongStrokes::steadyHandsAreFollowed()
{
    const auto hair = [](double u) -> Vec2 { return Vec2(100.0 * std::abs(u - 0.5), 0.5 * u); };
    const auto teeth = [](double u) -> Vec2 {
        const double tooth = 50.0 * u - std::floor(50.0 * u);
        return Vec2(300.0 * u, 14.0 * std::abs(tooth - 0.5));
    };
    Line pixels = along(bays, 10000);
    for (Vec2 &p : pixels)
        p = p.array().round();
    Line resting = along(bays, 300);
    resting.insert(resting.begin() + 100, 5000, resting[100]);
    const std::vector<Line> lines = {
        along(bays, 300),  along(bays, 30000), along(hair, 400), along(hair, 20),
        along(teeth, 500), along(teeth, 5000), pixels,           resting,
        scribble(20000),   leaping(3000)};
    for (std::size_t i = 0; i < lines.size(); ++i) {
        SteadyHand hand(kTolerance);
        for (const Vec2 &p : lines[i]) {
            const double off = (hand.follow(p) - p).norm();
            QVERIFY2(off <= 1e-12 * p.norm(),
                     qPrintable(QStringLiteral("line %1: %2").arg(i).arg(off)));
        }
    }
}

void TestLongStrokes::anEventCostsTheSame_data()
{
    QTest::addColumn<Line>("line");
    QTest::newRow("a scribble without end") << scribble(60000);
    QTest::newRow("jitter without end") << shaken(along(bays, 100000), 1.5);
    QTest::newRow("a straight line without end")
        << along([](double u) -> Vec2 { return Vec2(40000.0 * u, 0.0); }, 20000);
}

/// Samples that cubics are held against: for an event no more at the end of a long stroke than in
/// its beginning, whatever there is behind it.
void TestLongStrokes::anEventCostsTheSame()
{
    QFETCH(Line, line);
    Stroke::Options options;
    options.contour.tolerance = kTolerance;
    Stroke stroke(options);
    stroke.beginOnCanvas({0.0, line.front()});
    std::size_t early = 0, late = 0, settledEarly = 0, settledLate = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const std::size_t before = stroke.meant().settled().work();
        stroke.move({0.0, line[i]});
        const std::size_t settling = stroke.meant().settled().work() - before;
        std::size_t &most = i < line.size() / 4 ? settledEarly : settledLate;
        most = std::max(most, settling);
        if (i % 499 != 0)
            continue;
        std::size_t work = 0;
        fitAround(stroke.meant().points(), stroke.meant().settled().pieces(),
                  {.tolerance = kTolerance, .work = &work});
        std::size_t &mostWork = i < line.size() / 4 ? early : late;
        mostWork = std::max(mostWork, work);
    }
    const auto text = [](std::size_t a, std::size_t b) {
        return QStringLiteral("%1, later %2").arg(a).arg(b);
    };
    QVERIFY2(late <= 3 * early, qPrintable(text(early, late)));
    QVERIFY2(settledLate <= 3 * settledEarly + 1000, qPrintable(text(settledEarly, settledLate)));
    // A settled sample is looked at a few hundred times in all.
    QVERIFY2(stroke.meant().settled().work() <= 600 * stroke.samples().size(),
             qPrintable(text(stroke.samples().size(), stroke.meant().settled().work())));
}

/// A hundred thousand samples on one spot, or trembling on it, take no memory and make no joints.
void TestLongStrokes::aHandThatRestsAddsNothing()
{
    Line line = along(bays, 400);
    const std::size_t kept = drawn(line).samples().size();
    const Vec2 spot = line[200];
    Line resting(line.begin(), line.begin() + 200), trembling = resting;
    std::mt19937 random(3);
    for (int i = 0; i < 100000; ++i) {
        resting.push_back(spot);
        trembling.push_back(spot + Vec2(any(random, -0.1, 0.1), any(random, -0.1, 0.1)));
    }
    resting.insert(resting.end(), line.begin() + 200, line.end());
    trembling.insert(trembling.end(), line.begin() + 200, line.end());
    QVERIFY(drawn(resting).samples().size() <= kept + 1);
    QVERIFY(drawn(trembling).samples().size() <= kept + 3);
    // On the same way again and again, nothing but the way is kept.
    const std::size_t shaking = drawn(shaken(Line(100000, spot), 1.5)).samples().size();
    QVERIFY2(shaking <= 2000, qPrintable(QString::number(shaking)));
}

/// A usual stroke has nothing settled, and is what its samples make all at once.
void TestLongStrokes::shortStrokesAreFittedAsOne()
{
    const Stroke stroke = drawn(along(bays, 450));
    QCOMPARE(stroke.samples().size(), std::size_t(451));
    QVERIFY(stroke.meant().settled().pieces().empty());
}

/// A long stroke that comes back to where it began is closed as smoothly as a short one, and no
/// joint is left over but those that the settled pieces need.
void TestLongStrokes::closedLongStrokesHaveNoDent()
{
    const auto closedBays = [](double u) { return bays(0.993 * u); };
    const StrokeContour usual = drawn(along(closedBays, 480)).contour();
    const Stroke stroke = drawn(along(closedBays, 40000));
    QVERIFY(stroke.meant().settled().pieces().size() > 2);
    const StrokeContour &contour = stroke.contour();
    QVERIFY(contour.contour);
    QVERIFY(!usual.closing && !contour.closing);
    QVERIFY(!contour.wasCrossing);
    for (std::size_t i = 0; i < contour.fitted.size(); ++i) {
        const CubicBezier &a = contour.fitted[i];
        const CubicBezier &b = contour.fitted[(i + 1) % contour.fitted.size()];
        QCOMPARE(a.p3, b.p0);
        const Vec2 in = endDirection(a), out = startDirection(b);
        QVERIFY2(std::abs(std::atan2(cross(in, out), in.dot(out))) < 1e-9,
                 qPrintable(QString::number(i)));
    }
    QVERIFY2(contour.contour->segmentCount() <= usual.contour->segmentCount() * 3 / 2 + 2,
             qPrintable(QStringLiteral("%1, usually %2")
                            .arg(contour.contour->segmentCount())
                            .arg(usual.contour->segmentCount())));
}

/// Both halves are mirror images of each other, and what was settled is in the half as it was.
void TestLongStrokes::mirroredHalvesKeepWhatIsSettled()
{
    const auto half = [](double u) -> Vec2 {
        const double a = std::numbers::pi * u;
        const double radius = 900.0 + 80.0 * std::sin(9.0 * a);
        return Vec2(radius * std::cos(a), radius * std::sin(a));
    };
    const Stroke stroke = drawn(along(half, 30000), MirrorAxis());
    const StrokeContour &contour = stroke.contour();
    QVERIFY(contour.isMirrored && contour.contour);
    const std::vector<FittedPiece> &settled = stroke.meant().settled().pieces();
    QVERIFY(settled.size() > 8);
    std::size_t found = 0;
    for (const FittedPiece &piece : settled) {
        for (const CubicBezier &s : contour.fitted)
            found += (s.p0 - piece.curve.p0).norm() < 1e-9 &&
                             (s.p1 - piece.curve.p1).norm() < 1e-9 &&
                             (s.p2 - piece.curve.p2).norm() < 1e-9 &&
                             (s.p3 - piece.curve.p3).norm() < 1e-9
                         ? 1
                         : 0;
    }
    QVERIFY2(found + 6 >= settled.size(),
             qPrintable(QStringLiteral("%1 of %2").arg(found).arg(settled.size())));
    for (const Vec2 &p : contour.contour->points()) {
        bool hasImage = false;
        for (const Vec2 &q : contour.contour->points())
            hasImage = hasImage || (Vec2(p.x(), -p.y()) - q).norm() < 1e-9;
        QVERIFY(hasImage);
    }
}

/// A scribble across itself a thousand times still makes one contour that crosses itself nowhere.
void TestLongStrokes::scribblesComeApart()
{
    const Stroke stroke = drawn(scribble(12000));
    const StrokeContour &contour = stroke.contour();
    QVERIFY(contour.contour && contour.wasCrossing);
    QVERIFY(contour.fitted.size() > 100);
    QVERIFY(isPlain(*contour.contour, {}, kCutChord));
    const Result<ResolvedContour> again = resolveCrossings(*contour.contour);
    QVERIFY(again && !again->wasCrossing);
}

FFF_TEST(TestLongStrokes)
#include "tst_long_strokes.moc"
