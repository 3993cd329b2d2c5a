#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/geometry/boolean.h"
#include "core/stroke/meant_shape.h"
#include "core/stroke/stroke_contour.h"
#include "core/stroke/twitch.h"
#include "tests/core/stroke/sloppy_hand.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;

// What would be wrong: a circle that is not offered, a blob that is; a figure that lies elsewhere
// than what was drawn; curves that are changed by making lines straight.

namespace {

constexpr double kTolerance = 2.0;
constexpr double kPi = std::numbers::pi;
using Kind = MeantShape::Kind;

/// Round a middle, radius times what the waves of a hand make of it: it is not round, does not end
/// where it began, and trembles.
Samples roundByHand(SloppyHand &hand, double radius, double aspect, double waves, int bays = 0,
                    double bay = 0.0)
{
    const double turn = hand.any(0.0, kPi), start = hand.any(0.0, 2.0 * kPi);
    const double drift = hand.any(-0.06, 0.06), more = hand.any(-0.03, 0.06);
    double size[3], phase[3];
    for (int k = 0; k < 3; ++k) {
        size[k] = waves * hand.any(0.3, 1.0) / (k + 1);
        phase[k] = hand.any(0.0, 2.0 * kPi);
    }
    const int count = static_cast<int>(2.0 * kPi * radius / hand.any(3.0, 9.0));
    Samples samples;
    for (int i = 0; i <= count; ++i) {
        const double t = (1.0 + more) * i / count, a = start + 2.0 * kPi * t;
        double r = radius * (1.0 + drift * (t - 0.5));
        for (int k = 0; k < 3; ++k)
            r += radius * size[k] * std::sin((k + 2) * a + phase[k]);
        if (bays > 0)
            r += radius * bay * std::cos(bays * a + phase[0]);
        const Vec2 p(r * std::cos(a), aspect * r * std::sin(a));
        const double x = hand.normal(), y = hand.normal();
        samples.push_back(Vec2(200, 100) + std::cos(turn) * p + std::sin(turn) * perpendicular(p) +
                          0.4 * Vec2(x, y));
    }
    return samples;
}

std::optional<MeantShape> meantBy(const Samples &samples)
{
    const StrokeContour stroke = strokeContour(samples, {.tolerance = kTolerance});
    return stroke.contour ? meantShape(*stroke.contour, kTolerance) : std::nullopt;
}

bool isRound(const std::optional<MeantShape> &meant)
{
    return meant && (meant->kind == Kind::Circle || meant->kind == Kind::Ellipse);
}

Contour contourOfHand(const Samples &samples)
{
    return *strokeContour(samples, {.tolerance = kTolerance}).contour;
}

} // namespace

class TestMeantShape : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void fiftyCirclesAreOfferedOne();
    void ellipsesAreOfferedOne();
    void blobsAreNot();
    void figureIsWhereItWasDrawn();
    void boxByHandHasRightAngles();
    void bentLineIsStraight();
    void whatNobodySeesIsNotOffered();
    void curvesStay();
    void nothingBetterIsNothing();
    void smallLoopsAreNoTwitches();
};

void TestMeantShape::fiftyCirclesAreOfferedOne()
{
    int offered = 0;
    for (unsigned seed = 1; seed <= 50; ++seed) {
        SloppyHand hand(1.0, 0.0, seed);
        const double radius = hand.any(15.0, 220.0);
        const auto meant = meantBy(roundByHand(hand, radius, hand.any(0.92, 1.0), 0.025));
        offered += meant && meant->kind == Kind::Circle ? 1 : 0;
    }
    QVERIFY2(offered >= 48, qPrintable(QString::number(offered)));
}

void TestMeantShape::ellipsesAreOfferedOne()
{
    int offered = 0;
    for (unsigned seed = 1; seed <= 50; ++seed) {
        SloppyHand hand(1.0, 0.0, seed);
        const double radius = hand.any(60.0, 220.0);
        const auto meant = meantBy(roundByHand(hand, radius, hand.any(0.4, 0.75), 0.02));
        offered += meant && meant->kind == Kind::Ellipse ? 1 : 0;
    }
    QVERIFY2(offered >= 44, qPrintable(QString::number(offered)));
}

/// Beans, eggs, clover leaves, pebbles.
void TestMeantShape::blobsAreNot()
{
    int offered = 0;
    for (unsigned seed = 1; seed <= 60; ++seed) {
        SloppyHand hand(1.0, 0.0, seed);
        const double radius = hand.any(40.0, 220.0);
        const int bays = 2 + static_cast<int>(seed % 3);
        const double bay = bays == 2 ? hand.any(0.25, 0.4) : hand.any(0.11, 0.3);
        const auto meant = meantBy(roundByHand(hand, radius, hand.any(0.7, 1.0), 0.06, bays, bay));
        offered += isRound(meant) ? 1 : 0;
    }
    QVERIFY2(offered <= 3, qPrintable(QString::number(offered)));
}

/// As large as what was drawn, in the same place; its contour is what its numbers make.
void TestMeantShape::figureIsWhereItWasDrawn()
{
    for (unsigned seed = 1; seed <= 20; ++seed) {
        SloppyHand hand(1.0, 0.0, seed);
        const double radius = hand.any(40.0, 200.0), aspect = seed % 2 ? 1.0 : 0.5;
        const Samples samples = roundByHand(hand, radius, aspect, 0.015);
        const auto meant = meantBy(samples);
        if (!isRound(meant))
            continue;
        QVERIFY(meant->figure && isOf(meant->contour, *meant->figure));
        const Contour drawn = contourOfHand(samples);
        const Vec2 off =
            bounds(meant->contour.polygon(0.1)).center() - bounds(drawn.polygon(0.1)).center();
        QVERIFY2(off.norm() < 0.06 * radius, qPrintable(QString::number(off.norm() / radius)));
        const double area = std::abs(meant->contour.signedArea() / drawn.signedArea());
        QVERIFY2(std::abs(area - 1.0) < 0.04, qPrintable(QString::number(area)));
    }
}

void TestMeantShape::boxByHandHasRightAngles()
{
    int right = 0;
    for (unsigned seed = 1; seed <= 30; ++seed) {
        SloppyHand hand(4.0, 0.4, seed);
        Samples corners{{0, 0}, {280, 0}, {280, 170}, {0, 170}};
        for (Vec2 &p : corners) {
            const double x = hand.any(-9.0, 9.0), y = hand.any(-9.0, 9.0);
            p += Vec2(x, y);
        }
        hand.start(corners[0]);
        for (const int i : {1, 2, 3, 0})
            hand.to(corners[static_cast<std::size_t>(i)]);
        const auto meant = meantBy(hand.samples());
        if (!meant || meant->kind != Kind::RightAngles)
            continue;
        ++right;
        QCOMPARE(meant->contour.segmentCount(), 4);
        for (const double turn : turnsOf(meant->contour))
            QVERIFY(std::abs(turn - 0.5 * kPi) < 1e-9);
        const Misfit off = misfit(meant->contour, polygonOutline("drawn", corners), 25.0);
        QVERIFY2(off.distance < 14.0, qPrintable(QString::number(off.distance)));
    }
    QVERIFY2(right >= 28, qPrintable(QString::number(right)));
}

/// A triangle with one bowed side.
void TestMeantShape::bentLineIsStraight()
{
    SloppyHand hand(4.0, 0.3, 5);
    hand.start({0, 0});
    for (double t = 0.0; t < 1.0; t += 0.02)
        hand.to({300.0 * t, 26.0 * t * (1.0 - t)});
    hand.to({300, 0});
    hand.to({120, 230});
    hand.to({0, 0});
    const auto meant = meantBy(hand.samples());
    QVERIFY(meant && meant->kind == Kind::StraightLines);
    QCOMPARE(meant->contour.segmentCount(), 3);
    QVERIFY(resolveCrossings(meant->contour) && !resolveCrossings(meant->contour)->wasCrossing);
}

// Wrong: "make its lines straight" was offered where nobody could see what it does.
void TestMeantShape::whatNobodySeesIsNotOffered()
{
    const Vec2 corners[] = {{0, 0}, {300, 0}, {120, 230}};
    const auto bentBy = [&corners](double bent) {
        std::vector<CubicBezier> sides;
        for (int i = 0; i < 3; ++i) {
            const Vec2 &from = corners[i], &to = corners[(i + 1) % 3];
            CubicBezier side = CubicBezier::line(from, to);
            const Vec2 off = bent / 0.75 * perpendicular((to - from).normalized());
            side.p1 += off;
            side.p2 += off;
            sides.push_back(side);
        }
        return *Contour::fromSegments(sides);
    };
    QVERIFY(!meantShape(bentBy(0.15 * kTolerance), kTolerance));
    const auto seen = meantShape(bentBy(kTolerance), kTolerance);
    QVERIFY(seen && seen->kind == Kind::StraightLines);
}

/// Three sides of a box that lean, and a bow in place of the fourth.
void TestMeantShape::curvesStay()
{
    SloppyHand hand(4.0, 0.3, 5);
    hand.start({0, 12});
    hand.to({-6, 160});
    hand.to({240, 166});
    hand.to({236, 8});
    for (double t = 0.0; t < 1.0; t += 0.02)
        hand.to({236.0 * (1.0 - t), 8.0 + 4.0 * t - 240.0 * t * (1.0 - t)});
    hand.to({0, 12});
    const Contour drawn = contourOfHand(hand.samples());
    const auto meant = meantShape(drawn, kTolerance);
    QVERIFY(meant && meant->kind == Kind::RightAngles);
    const double lowest = bounds(drawn.polygon(0.05)).min.y();
    QVERIFY(std::abs(bounds(meant->contour.polygon(0.05)).min.y() - lowest) < 0.5);
    int lines = 0;
    for (int i = 0; i < meant->contour.segmentCount(); ++i)
        lines += meant->contour.segment(i).isStraight(1e-9) ? 1 : 0;
    QVERIFY(lines >= 3);
}

/// What is as it is meant already is not offered again.
void TestMeantShape::nothingBetterIsNothing()
{
    for (const Outline &outline :
         {spikyOutline(150.0, 65.0, 5), concaveOutline(140.0),
          polygonOutline("house", {{0, 0}, {200, 0}, {200, 140}, {100, 240}, {0, 140}})}) {
        const Contour drawn = outline.corners.empty() ? Contour::ofPolygon(outline.line)
                                                      : Contour::ofPolygon(outline.corners);
        QVERIFY2(!meantShape(drawn, kTolerance), outline.name.c_str());
    }
    SloppyHand hand(4.0, 0.4, 3);
    hand.start({0, 0});
    for (const Vec2 &p : {Vec2(280, 6), Vec2(284, 170), Vec2(3, 160), Vec2(0, 0)})
        hand.to(p);
    const auto meant = meantBy(hand.samples());
    QVERIFY(meant);
    const auto again = meantShape(meant->contour, kTolerance);
    QVERIFY(!again);
}

/// 6 mm and no loop is a slip of the hand; an eye of 5 mm is a shape.
void TestMeantShape::smallLoopsAreNoTwitches()
{
    for (const double diameter : {3.0, 5.0, 5.9}) {
        const double r = 0.5 * diameter;
        for (const double round : {0.9, 1.0, 1.1})
            QVERIFY(!isTwitch(curve(
                [=](double t) {
                    const double a = 2.0 * kPi * round * t;
                    return Vec2(r * std::cos(a), r * std::sin(a));
                },
                20)));
        QVERIFY(isTwitch(curve(
            [=](double t) { return Vec2(r * std::cos(kPi * t), r * std::sin(kPi * t)); }, 20)));
        QVERIFY(isTwitch(lines({{0, 0}, {diameter, 0}, {0, 0.4}}, 0.3)));
        QVERIFY(isTwitch(lines({{0, 0}, {diameter, 0.5}}, 0.3)));
    }
    QVERIFY(!isTwitch(lines({{0, 0}, {6.0, 0}}, 0.3)));
    QVERIFY(isTwitch({{3, 4}}));
    QVERIFY(isTwitch({}));
    // Whatever draws it: refused with its own reason, and an eye is made.
    const StrokeContourOptions fine{.tolerance = 0.2};
    QCOMPARE(strokeContour(lines({{0, 0}, {3, 2}, {5, 0}}, 0.2), fine).refusal,
             StrokeContour::Refusal::Twitch);
    const auto eye = [](double t) -> Vec2 {
        return 2.5 * Vec2(std::cos(6.4 * t), std::sin(6.4 * t));
    };
    for (const double tolerance : {0.2, 1.0})
        QVERIFY(strokeContour(curve(eye, 40), {.tolerance = tolerance}).contour);
}

FFF_TEST(TestMeantShape)
#include "tst_meant_shape.moc"
