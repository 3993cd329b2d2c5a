#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/stroke/stroke.h"
#include "core/stroke/stroke_contour.h"
#include "tests/core/stroke/sloppy_hand.h"
#include "tests/test_program.h"

#include <functional>

using namespace fff;
using namespace fff::test;

Q_DECLARE_METATYPE(fff::test::Outline)

// What would be wrong: a hasty circle that becomes a polygon, a polygon that becomes a potato,
// wiggles that are noise, a small eye with corners.

namespace {

constexpr double kTolerance = 2.0;
constexpr double kPi = std::numbers::pi;

/// As the view does it: sample by sample.
StrokeContour drawnBy(const Samples &samples)
{
    Stroke::Options options;
    options.contour.tolerance = kTolerance;
    Stroke stroke(options);
    stroke.beginOnCanvas({0.0, samples.front()});
    for (std::size_t i = 1; i < samples.size(); ++i)
        stroke.move({double(i), samples[i]});
    return stroke.contour();
}

QString text(const Misfit &off)
{
    return QStringLiteral("%1 px off, %2 segments, %3 false corners (%4°), %5 lost")
        .arg(off.distance, 0, 'f', 2)
        .arg(off.segments)
        .arg(off.falseCorners)
        .arg(off.sharpestFalse, 0, 'f', 0)
        .arg(off.lostCorners);
}

/// Samples as far apart in time, once round and a little less or more.
Samples sampled(const std::function<Vec2(double)> &at, int count, double round, double shake,
                unsigned seed)
{
    SloppyHand hand(1.0, 0.0, seed);
    const double phase = hand.any(0.0, 1.0);
    Samples result;
    for (int i = 0; i < count; ++i) {
        const double x = hand.normal(), y = hand.normal();
        result.push_back(at(phase + round * i / (count - 1)) + shake * Vec2(x, y));
    }
    return result;
}

} // namespace

class TestForgivingShapes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void fewFastPointsAreRound_data();
    void fewFastPointsAreRound();
    void fewPointsWithCornersKeepThem_data();
    void fewPointsWithCornersKeepThem();
    void noiseMakesNothing_data();
    void noiseMakesNothing();
    void smallOnesStayRound_data();
    void smallOnesStayRound();
    void smallCornersStay();
};

void TestForgivingShapes::fewFastPointsAreRound_data()
{
    QTest::addColumn<int>("count");
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("share");
    for (const int count : {8, 9, 10, 12, 16, 24})
        for (const double radius : {40.0, 100.0, 220.0})
            for (const double share : {1.0, 0.6})
                if (share == 1.0 || (count > 9 && count < 24)) // of fewer its tips are corners
                    QTest::addRow("%d points, %g px, %g", count, radius, share)
                        << count << radius << share;
}

void TestForgivingShapes::fewFastPointsAreRound()
{
    QFETCH(int, count);
    QFETCH(double, radius);
    QFETCH(double, share);
    for (unsigned seed = 1; seed <= 12; ++seed) {
        const auto at = [&](double t) {
            return Vec2(radius * std::cos(2 * kPi * t), radius * share * std::sin(2 * kPi * t));
        };
        for (const double round : {0.9, 0.97, 1.0, 1.06}) {
            const StrokeContour stroke = drawnBy(sampled(at, count, round, 0.007 * radius, seed));
            QVERIFY(stroke.contour);
            const Misfit off = misfit(*stroke.contour, roundOutline(radius, radius * share));
            QVERIFY2(
                off.falseCorners == 0 && off.distance < 3.0 + 0.09 * radius &&
                    off.segments <= (count > 16 ? 16 : 10),
                qPrintable(
                    QStringLiteral("round %1, hand %2: %3").arg(round).arg(seed).arg(text(off))));
        }
    }
}

void TestForgivingShapes::fewPointsWithCornersKeepThem_data()
{
    QTest::addColumn<Samples>("corners");
    QTest::addColumn<int>("between");
    const Samples box{{0, 0}, {240, 0}, {240, 150}, {0, 150}};
    const Samples triangle{{0, 0}, {260, 20}, {110, 210}};
    const Samples house{{0, 0}, {200, 0}, {200, 140}, {100, 220}, {0, 140}};
    const Samples arrow{{0, 0}, {150, 90}, {0, 180}, {45, 90}};
    for (const int between : {0, 1, 2, 3}) {
        QTest::addRow("box, %d between", between) << box << between;
        QTest::addRow("triangle, %d between", between) << triangle << between;
        if (between > 0)
            QTest::addRow("house, %d between", between) << house << between;
        QTest::addRow("arrow, %d between", between) << arrow << between;
    }
}

void TestForgivingShapes::fewPointsWithCornersKeepThem()
{
    QFETCH(Samples, corners);
    QFETCH(int, between);
    Samples samples;
    SloppyHand hand;
    for (std::size_t i = 0; i < corners.size(); ++i)
        for (int k = 0; k <= between; ++k) {
            const double x = hand.normal(), y = hand.normal();
            samples.push_back(corners[i] +
                              (corners[(i + 1) % corners.size()] - corners[i]) *
                                  (double(k) / (between + 1)) +
                              1.0 * Vec2(x, y));
        }
    samples.push_back(corners.front() + Vec2(2, 3));
    const StrokeContour stroke = drawnBy(samples);
    QVERIFY(stroke.contour);
    const Misfit off = misfit(*stroke.contour, polygonOutline("drawn", corners));
    QVERIFY2(off.falseCorners == 0 && off.lostCorners == 0 && off.distance < 7.0,
             qPrintable(text(off)));
}

void TestForgivingShapes::noiseMakesNothing_data()
{
    QTest::addColumn<Outline>("truth");
    QTest::addColumn<double>("step");
    QTest::addColumn<int>("most");
    QTest::addColumn<double>("shake");
    const auto row = [](const char *name, const Outline &truth, double step, int most,
                        double shake = 1.5) {
        QTest::addRow("%s, every %g px", name, step) << truth << step << most << shake;
    };
    for (const double step : {3.0, 5.0, 8.0}) {
        row("circle", roundOutline(120.0, 120.0), step, 6);
        row("ellipse", roundOutline(200.0, 90.0), step, 8);
    }
    for (const double step : {3.0, 5.0})
        row("bays", concaveOutline(130.0), step, 14);
    row("box", polygonOutline("box", {{0, 0}, {300, 0}, {300, 180}, {0, 180}}), 3.0, 13, 0.87);
}

/// White noise of 1.5 px (beside corners, of no more than that), as far from one sample to the next
/// as a hand goes: no wiggles, few segments, no false corners, none lost.
void TestForgivingShapes::noiseMakesNothing()
{
    QFETCH(Outline, truth);
    QFETCH(double, step);
    QFETCH(int, most);
    QFETCH(double, shake);
    for (unsigned seed = 1; seed <= 8; ++seed) {
        SloppyHand hand(step, shake, seed);
        hand.along(truth, 30.0, truth.length() + 30.0);
        const StrokeContour stroke = drawnBy(hand.samples());
        QVERIFY(stroke.contour);
        const Misfit off = misfit(*stroke.contour, truth);
        QVERIFY2(off.falseCorners == 0 && off.lostCorners == 0 && off.distance < 6.0 &&
                     off.segments <= most,
                 qPrintable(QStringLiteral("hand %1: %2").arg(seed).arg(text(off))));
    }
}

void TestForgivingShapes::smallOnesStayRound_data()
{
    QTest::addColumn<double>("diameter");
    QTest::addColumn<int>("count");
    QTest::addColumn<bool>("isRounded");
    for (const double diameter : {10.0, 12.0, 16.0, 20.0, 30.0, 40.0})
        for (const int count : {10, 16, 30, 60})
            if (diameter > 10.0 || count < 60) // that slow on a spot it is a tremble
                for (const bool isRounded : {false, true})
                    QTest::addRow("%g px, %d points%s", diameter, count,
                                  isRounded ? ", whole px" : "")
                        << diameter << count << isRounded;
}

/// An eye of 5 mm is 10 px where a pixel is half a millimetre, as when the program starts.
void TestForgivingShapes::smallOnesStayRound()
{
    QFETCH(double, diameter);
    QFETCH(int, count);
    QFETCH(bool, isRounded);
    for (unsigned seed = 1; seed <= 10; ++seed) {
        const double r = 0.5 * diameter;
        const auto at = [&](double t) {
            return Vec2(r * std::cos(2 * kPi * t), r * std::sin(2 * kPi * t));
        };
        for (const double round : {0.95, 1.0, 1.08}) {
            Samples samples = sampled(at, count, round, 0.2, seed);
            if (isRounded)
                for (Vec2 &p : samples)
                    p = p.array().round().matrix();
            const StrokeContour stroke = drawnBy(samples);
            QVERIFY2(stroke.contour,
                     qPrintable(QStringLiteral("%1, hand %2").arg(round).arg(seed)));
            const Misfit off = misfit(*stroke.contour, roundOutline(r, r));
            QVERIFY2(
                off.falseCorners == 0 && off.distance < 1.2 + 0.03 * diameter && off.segments <= 6,
                qPrintable(QStringLiteral("%1, hand %2: %3").arg(round).arg(seed).arg(text(off))));
        }
    }
}

/// What has corners and is small keeps them.
void TestForgivingShapes::smallCornersStay()
{
    for (const double side : {16.0, 24.0, 40.0}) {
        const Samples corners{{0, 0}, {side, 0}, {side, side}, {0, side}};
        const Outline box = polygonOutline("box", corners);
        for (unsigned seed = 1; seed <= 5; ++seed) {
            SloppyHand hand(1.0, 0.1, seed);
            hand.along(box, 0.0, box.length());
            const StrokeContour stroke = drawnBy(hand.samples());
            QVERIFY(stroke.contour);
            const Misfit off = misfit(*stroke.contour, box, 0.2 * side);
            QVERIFY2(off.falseCorners == 0 && off.lostCorners == 0,
                     qPrintable(QStringLiteral("%1 px: %2").arg(side).arg(text(off))));
        }
    }
}

FFF_TEST(TestForgivingShapes)
#include "tst_forgiving_shapes.moc"
