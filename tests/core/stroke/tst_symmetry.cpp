#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/stroke/stroke_contour.h"
#include "tests/core/geometry/polyline_distance.h"
#include "tests/core/geometry/samples.h"
#include "tests/core/geometry/turns.h"
#include "tests/test_program.h"

#include <cmath>
#include <numbers>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

using Refusal = StrokeContour::Refusal;

constexpr double kPi = std::numbers::pi;
constexpr double kTolerance = 0.5;

/// Of an ellipse about the origin, from one angle to another.
Samples arc(double from, double to, double rx = 50.0, double ry = 30.0, const Vec2 &middle = {0, 0})
{
    return curve([=](double t) {
        const double angle = from + t * (to - from);
        return Vec2(middle + Vec2(rx * std::cos(angle), ry * std::sin(angle)));
    });
}

/// The stroke of one bump of `high` mm on the left and one of `low` mm on the right of the x axis.
Samples bumps(double high, double low)
{
    return lines({{0, 0}, {10, high}, {40, high}, {60, -low}, {70, -low}, {80, 0}}, 1.0);
}

StrokeContour mirroredAt(const Samples &samples, const MirrorAxis &axis = {})
{
    return strokeContour(samples, {.tolerance = kTolerance, .axis = axis});
}

/// Largest distance between a control point of the copy and the mirror image of the one it is of.
/// Of contours that were not cut.
double largestDifference(const StrokeContour &stroke)
{
    const std::vector<Vec2> &points = stroke.contour->points();
    const std::size_t half = points.size() / 2;
    double difference = 0.0;
    for (std::size_t i = 0; i <= half; ++i) {
        const Vec2 &other = points[(points.size() - i) % points.size()];
        difference = std::max(difference, (stroke.axis->mirrored(points[i]) - other).norm());
    }
    return difference;
}

/// By how much the contour turns where it passes the axis, at its start and in the middle.
std::vector<double> turnsAtAxis(const StrokeContour &stroke)
{
    const std::vector<double> turns = turnsOf(*stroke.contour);
    return {turns.front(), turns[turns.size() / 2]};
}

bool crossesItself(const Contour &contour)
{
    const Result<ResolvedContour> resolved = resolveCrossings(contour);
    return !resolved || resolved->wasCrossing;
}

} // namespace

class TestSymmetry : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void verdict_data();
    void verdict();
    void limitIsWhatSwitchesItOff();
    void switchedOffIsOnlyJudged();
    void halvesAreMirrorImages_data();
    void halvesAreMirrorImages();
    void tipsStaySharp();
    void staysOnTheStroke();
    void strayEndsAreCutOff();
    void theOtherSideIsMeantWhereAnEndGoesOn_data();
    void theOtherSideIsMeantWhereAnEndGoesOn();
    void severalCrossingsKeepTheLargestHalf();
    void closedBesideTheAxisGetsANeck();
    void sideAlongTheAxisIsLeftOut();
    void nothingToMirror_data();
    void nothingToMirror();
    void randomStrokes_data();
    void randomStrokes();
};

void TestSymmetry::verdict_data()
{
    QTest::addColumn<double>("larger");
    QTest::addColumn<double>("smaller");
    QTest::addColumn<bool>("isMirrored");
    QTest::newRow("ratio 5.9") << 59.0 << 10.0 << false;
    QTest::newRow("ratio just below 6") << 59.999999 << 10.0 << false;
    QTest::newRow("ratio 6 exactly") << 60.0 << 10.0 << true;
    QTest::newRow("ratio 6.1") << 61.0 << 10.0 << true;
    QTest::newRow("nothing on the other side") << 30.0 << 0.0 << true;
    QTest::newRow("both alike") << 30.0 << 30.0 << false;
}

/// The paper's number, on either side and on whichever axis.
void TestSymmetry::verdict()
{
    QFETCH(double, larger);
    QFETCH(double, smaller);
    QFETCH(bool, isMirrored);
    for (const double angle : {0.0, kPi / 2, 0.7, -2.4}) {
        const Vec2 direction(std::cos(angle), std::sin(angle));
        const Vec2 up = perpendicular(direction), point(17.0, -4.0);
        for (const double side : {1.0, -1.0}) {
            Samples samples = bumps(larger, smaller);
            for (Vec2 &p : samples)
                p = point + p.x() * direction + side * p.y() * up;
            const StrokeContour stroke = mirroredAt(samples, {point, direction});
            QVERIFY(stroke.symmetry);
            QCOMPARE(stroke.isMirrored, isMirrored);
            QCOMPARE(stroke.symmetry->isOneSided, isMirrored);
            QCOMPARE(stroke.symmetry->isLeft(), side > 0.0 || larger == smaller);
            const double left = side > 0.0 ? larger : smaller;
            QVERIFY(std::abs(stroke.symmetry->left - left) < 1e-9);
            QVERIFY(std::abs(stroke.symmetry->right - (larger + smaller - left)) < 1e-9);
            QVERIFY(stroke.contour);
            QCOMPARE(stroke.mirrored.empty(), !isMirrored);
        }
    }
}

void TestSymmetry::limitIsWhatSwitchesItOff()
{
    const StrokeContour stroke = mirroredAt(bumps(42.5, 0.0));
    QCOMPARE(stroke.symmetry->limit, 42.5 / 6.0);
    QVERIFY(judgeSymmetry(bumps(42.5, stroke.symmetry->limit - 1e-6), {}).isOneSided);
    QVERIFY(!judgeSymmetry(bumps(42.5, stroke.symmetry->limit + 1e-6), {}).isOneSided);
}

void TestSymmetry::switchedOffIsOnlyJudged()
{
    const Samples samples = arc(0.1, kPi - 0.1);
    const StrokeContour plain = strokeContour(samples, {.tolerance = kTolerance});
    const StrokeContour off = strokeContour(
        samples, {.tolerance = kTolerance, .axis = MirrorAxis(), .isSymmetryOn = false});
    QVERIFY(off.symmetry && off.symmetry->isOneSided && !off.isMirrored && off.mirrored.empty());
    QVERIFY(*off.contour == *plain.contour);
}

void TestSymmetry::halvesAreMirrorImages_data()
{
    QTest::addColumn<Samples>("samples");
    QTest::newRow("from axis to axis") << arc(0.0, kPi);
    QTest::newRow("stops short at both ends") << arc(0.2, kPi - 0.25);
    QTest::newRow("strays over at both ends") << arc(-0.1, kPi + 0.1);
    QTest::newRow("one end short, one astray") << arc(-0.1, kPi - 0.3);
    QTest::newRow("legs of a chair") << lines(
        {{0, 5}, {-5, 20}, {-40, 20}, {-40, 30}, {30, 30}, {30, 20}, {10, 20}, {8, 6}}, 1.0);
    QTest::newRow("arch that ends far from the axis")
        << curve([](double t) { return Vec2(60 * t, 12 + 40 * std::sin(kPi * t)); });
    QTest::newRow("ends head away from the axis")
        << lines({{0, 10}, {0, 30}, {40, 40}, {80, 30}, {80, 10}, {79, 14}}, 1.0);
    QTest::newRow("runs along the axis at its ends")
        << lines({{30, 3}, {0, 3}, {0, 40}, {90, 40}, {90, 3}, {60, 3}}, 1.0);
}

/// A half that is not the other's image is not cut from the same outline.
void TestSymmetry::halvesAreMirrorImages()
{
    QFETCH(Samples, samples);
    for (const double angle : {0.0, kPi / 2, 2.1}) {
        const MirrorAxis axis{{3, -20}, {std::cos(angle), std::sin(angle)}};
        for (const bool isLeft : {true, false}) {
            Samples placed;
            for (const Vec2 &p : samples)
                placed.push_back(axis.point + p.x() * axis.direction +
                                 (isLeft ? 1.0 : -1.0) * p.y() * perpendicular(axis.direction));
            const StrokeContour stroke = mirroredAt(placed, axis);
            QVERIFY(stroke.isMirrored && stroke.contour);
            QVERIFY(!stroke.wasCrossing && !stroke.wasCutAtAxis);
            QVERIFY2(largestDifference(stroke) < 1e-9,
                     qPrintable(QString::number(largestDifference(stroke))));
            for (const double turn : turnsAtAxis(stroke))
                QVERIFY2(turn < 1e-6, qPrintable(QString::number(turn)));
            QVERIFY(!crossesItself(*stroke.contour));
        }
    }
}

/// A leaf has tips: the stroke meets the axis at 30°.
void TestSymmetry::tipsStaySharp()
{
    const double radius = 60.0, slant = kPi / 6;
    const auto leaf = [&](double t) {
        const double angle = kPi / 2 + slant - 2.0 * slant * t;
        return Vec2(radius * std::cos(angle), radius * (std::sin(angle) - std::cos(slant)));
    };
    for (const double shorter : {0.0, 0.02}) { // by 1.2 mm at each end
        const StrokeContour stroke =
            mirroredAt(curve([&](double t) { return leaf(shorter + (1.0 - 2 * shorter) * t); }));
        QVERIFY(stroke.contour && !stroke.opening && !stroke.closing);
        for (const double turn : turnsAtAxis(stroke))
            QVERIFY2(std::abs(turn - 2.0 * slant) < 0.25 ||
                         std::abs(kPi - turn - 2.0 * slant) < 0.25,
                     qPrintable(QString::number(turn)));
        QVERIFY(largestDifference(stroke) < 1e-9);
        QVERIFY(!crossesItself(*stroke.contour));
    }
}

/// Bending the ends to the axis stays within the fit's bound.
void TestSymmetry::staysOnTheStroke()
{
    for (const double lean : {0.0, 10.0, 25.0}) { // the ends meet the axis obliquely
        const Samples samples = lines({{-40 - lean, 0}, {-40, 30}, {40, 30}, {40 + lean, 0}}, 1.0);
        const StrokeContour stroke = mirroredAt(samples);
        QVERIFY(stroke.contour);
        for (const double turn : turnsAtAxis(stroke))
            QVERIFY(turn < 1e-6);
        const PolylineDistance toSamples(samples);
        for (const CubicBezier &s : stroke.fitted)
            for (int k = 0; k <= 50; ++k)
                QVERIFY(toSamples(s.at(k / 50.0)) <= kTolerance * 1.001);
    }
}

void TestSymmetry::strayEndsAreCutOff()
{
    const StrokeContour stroke = mirroredAt(arc(-0.15, kPi + 0.15));
    QVERIFY(stroke.contour);
    QVERIFY(!stroke.opening && !stroke.closing);
    QVERIFY(std::abs(stroke.fitted.front().p0.y()) < 1e-12);
    QVERIFY(std::abs(stroke.fitted.back().p3.y()) < 1e-12);
    QVERIFY(std::abs(std::abs(stroke.contour->signedArea()) - kPi * 50.0 * 30.0) < 60.0);
}

void TestSymmetry::theOtherSideIsMeantWhereAnEndGoesOn_data()
{
    QTest::addColumn<Samples>("samples");
    QTest::newRow("most of a circle") << arc(0.0, 1.7 * kPi, 50.0, 50.0);
    QTest::newRow("an end that closes it") << arc(-0.15 * kPi, 1.15 * kPi, 50.0, 50.0);
    QTest::newRow("back to the axis") << bumps(59.0, 10.0);
    QTest::newRow("a long end") << lines({{50, 0}, {50, 40}, {-50, 40}, {-50, -45}}, 1.0);
    QTest::newRow("a lobe first") << lines({{60, -25}, {0, -25}, {0, 100}, {250, 100}, {250, 0}},
                                           1.0);
    QTest::newRow("an S") << lines({{0, 0}, {0, 40}, {40, 40}, {40, -40}, {80, -40}, {80, 0}}, 1.0);
    QTest::newRow("between two bumps") << lines(
        {{0, 0}, {0, 40}, {30, 40}, {30, -12}, {50, -12}, {50, 40}, {80, 40}, {80, 0}}, 1.0);
}

void TestSymmetry::theOtherSideIsMeantWhereAnEndGoesOn()
{
    QFETCH(Samples, samples);
    for (const bool isBackwards : {false, true}) {
        QVERIFY(!judgeSymmetry(samples, {}, kMirrorRatio, kTolerance).isOneSided);
        if (!isBackwards)
            std::reverse(samples.begin(), samples.end());
    }
}

void TestSymmetry::severalCrossingsKeepTheLargestHalf()
{
    // Three bumps of 20, 40 and 10 mm, between them 2 mm under the axis.
    const Samples samples = lines({{0, 0},
                                   {10, 20},
                                   {20, -2},
                                   {24, -2},
                                   {40, 40},
                                   {60, 40},
                                   {70, -2},
                                   {74, -2},
                                   {80, 10},
                                   {90, 0}},
                                  1.0);
    const StrokeContour stroke = mirroredAt(samples);
    QVERIFY(stroke.contour);
    QVERIFY(stroke.wasCutAtAxis);
    QVERIFY(largestDifference(stroke) < 1e-9);
    const Box2 box = bounds(stroke.contour->polygon(0.01));
    QVERIFY(box.min.x() > 23.0 && box.max.x() < 71.0);
    QVERIFY(std::abs(box.max.y() - 40.0) < 1.0);
}

/// Drawn as a wheel beside the slit, the two wings have to hang together.
void TestSymmetry::closedBesideTheAxisGetsANeck()
{
    for (const double start : {-kPi / 2, 0.4, 2.0}) {
        const StrokeContour stroke = mirroredAt(arc(start, start + 2 * kPi, 30.0, 30.0, {0, 36}));
        QVERIFY(stroke.contour);
        QVERIFY(largestDifference(stroke) < 1e-9);
        QVERIFY(!crossesItself(*stroke.contour));
        QVERIFY(std::abs(stroke.contour->signedArea()) > 2 * kPi * 900.0);
        const Box2 box = bounds(stroke.contour->polygon(0.01));
        QVERIFY(std::abs(box.min.y() + 66.0) < 1.0 && std::abs(box.max.y() - 66.0) < 1.0);
    }
}

/// Who draws the whole half comes back along the slit, more or less on it: no wedge stays open
/// there.
void TestSymmetry::sideAlongTheAxisIsLeftOut()
{
    for (const bool isClosed : {true, false}) {
        const double last = isClosed ? 2.0 : 40.0;
        const StrokeContour stroke = mirroredAt(lines(
            {{0, 1}, {0, 50}, {30, 70}, {70, 70}, {100, 50}, {100, 1}, {50, -1}, {last, 1}}, 1.0));
        QVERIFY(stroke.isMirrored && stroke.contour && !stroke.wasCrossing);
        QVERIFY(largestDifference(stroke) < 1e-9);
        QVERIFY2(std::abs(std::abs(stroke.contour->signedArea()) - 12800.0) < 150.0,
                 qPrintable(QString::number(stroke.contour->signedArea())));
        const Box2 box = bounds(stroke.contour->polygon(0.01));
        QVERIFY(box.min.x() > -1.0 && box.max.x() < 101.0);
        for (const Vec2 &p : stroke.contour->polygon(0.01))
            QVERIFY(std::abs(p.y()) > 0.8 || p.x() < 0.8 || p.x() > 99.2);
    }
}

void TestSymmetry::nothingToMirror_data()
{
    QTest::addColumn<Samples>("samples");
    QTest::addColumn<int>("refusal");
    const auto row = [](const char *name, const Samples &samples, Refusal refusal) {
        QTest::newRow(name) << samples << static_cast<int>(refusal);
    };
    row("nothing", {}, Refusal::TooShort);
    row("a point", {{0, 3}}, Refusal::TooShort);
    row("all on the axis", {{0, 0}, {20, 0}, {50, 0}}, Refusal::NoArea);
    row("there and back on the axis", {{0, 0}, {50, 0}, {0, 0}}, Refusal::NoArea);
    row("straight away from the axis", lines({{0, 0}, {0, 30}}, 1.0), Refusal::NoArea);
    row("away and back", lines({{0, 0}, {0, 30}, {0.1, 0}}, 1.0), Refusal::NoArea);
    row("a hook alone over the axis", lines({{0, -0.1}, {20, -0.1}, {19.5, 0.7}}, 0.5),
        Refusal::NoArea);
}

void TestSymmetry::nothingToMirror()
{
    QFETCH(Samples, samples);
    QFETCH(int, refusal);
    const StrokeContour stroke = mirroredAt(samples);
    QVERIFY(!stroke.contour);
    QCOMPARE(static_cast<int>(stroke.refusal), refusal);
}

void TestSymmetry::randomStrokes_data()
{
    QTest::addColumn<unsigned>("seed");
    for (unsigned seed = 1; seed <= 100; ++seed)
        QTest::addRow("seed %u", seed) << seed;
}

/// Whatever is drawn on one side: a contour with equal halves, or a reason.
void TestSymmetry::randomStrokes()
{
    QFETCH(unsigned, seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    const double a = any(random), b = any(random), c = any(random), height = 10.0 * any(random);
    Samples samples = curve([&](double t) {
        return Vec2(50 * std::cos(kPi * t) + 10 * a * std::sin(3 * kPi * t),
                    height + 60 * std::sin(kPi * t) * (1.2 + 0.6 * b * std::cos(5 * t)) +
                        8 * c * std::sin(7 * t));
    });
    for (Vec2 &p : samples)
        p += 0.3 * Vec2(any(random), any(random));
    const StrokeContour stroke = mirroredAt(samples);
    QCOMPARE(stroke.contour.has_value(), stroke.refusal == Refusal::None);
    if (!stroke.contour)
        return;
    QVERIFY(!crossesItself(*stroke.contour));
    if (!stroke.isMirrored)
        return;
    QVERIFY(largestDifference(stroke) < 1e-9);
    // Smooth, or a tip of a right angle at most.
    for (const double turn : turnsAtAxis(stroke))
        QVERIFY2(turn < 1e-6 || turn > 0.499 * kPi, qPrintable(QString::number(turn)));
}

FFF_TEST(TestSymmetry)
#include "tst_symmetry.moc"
