// One side of a section, drawn by a hand that does not care how it ends.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/geometry/boolean.h"
#include "core/stroke/stroke_contour.h"
#include "tests/core/geometry/samples.h"
#include "tests/core/stroke/sloppy_hand.h"
#include "tests/test_program.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace fff;
using namespace fff::test;

namespace {

constexpr double kHalfTurn = std::numbers::pi;

/// Half a disc of 100 px about the origin, on the left of the x axis, and what a hand does at its
/// end: px that it goes on straight, past the axis, and then back, or round.
struct HastyEnd
{
    const char *name;
    double on = 0.0;   // past the axis straight on; negative: stops short of it
    double back = 0.0; // then, turned by `turn` radians
    double turn = 0.0;
    double curl = 0.0; // then, the radius of most of a circle; negative: to the other side
};

constexpr double kDisc = 100.0, kPixels = 2.0; // px: of the radius, and the tolerance

Samples halfDisc(const HastyEnd &end, double shake, unsigned seed, bool isBackwards)
{
    SloppyHand hand(4.0, shake, seed);
    const Outline disc = roundOutline(kDisc, kDisc);
    const double half = kHalfTurn * kDisc, down = -kHalfTurn / 2.0;
    hand.along(disc, 0.0, half + std::min(end.on, 0.0));
    if (end.on > 0.0)
        hand.by(end.on, down);
    if (end.back > 0.0)
        hand.by(end.back, down + end.turn);
    constexpr int kSteps = 10;
    const double sense = end.curl < 0.0 ? -1.0 : 1.0, step = 1.6 * kHalfTurn / kSteps;
    for (int i = 0; i < kSteps && end.curl != 0.0; ++i)
        hand.by(std::abs(end.curl) * step, down + sense * (i + 0.5) * step);
    Samples samples = hand.samples();
    if (isBackwards)
        std::reverse(samples.begin(), samples.end());
    return samples;
}

bool isCrossing(const Contour &contour)
{
    const Result<ResolvedContour> resolved = resolveCrossings(contour);
    return !resolved || resolved->wasCrossing;
}

} // namespace

class TestSymmetryInHaste : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void endsInHaste_data();
    void endsInHaste();
    void aTrembleIsNoOtherSide();
    void aWaistKeepsBothLobes_data();
    void aWaistKeepsBothLobes();
};

void TestSymmetryInHaste::endsInHaste_data()
{
    constexpr HastyEnd kEnds[] = {{"at the axis"},
                                  {"6 px short", -6.0},
                                  {"12 px short", -12.0},
                                  {"8 px too far", 8.0},
                                  {"17 px too far", 17.0},
                                  {"25 px too far", 25.0},
                                  {"10 px too far, hooked back", 10.0, 12.0, 2.6},
                                  {"6 px too far, hooked out", 6.0, 12.0, -2.2},
                                  {"a curl inwards", 3.0, 0.0, 0.0, 5.0},
                                  {"a curl outwards", 3.0, 0.0, 0.0, -5.0}};
    QTest::addColumn<HastyEnd>("end");
    QTest::addColumn<double>("shake");
    for (const HastyEnd &end : kEnds)
        for (const double shake : {0.0, 0.3, 0.6, 1.0, 1.3, 1.6, 2.0})
            QTest::addRow("%s, tremble %.1f px", end.name, shake) << end << shake;
}

/// Half of a disc gives all of it, however hastily the hand stops.
void TestSymmetryInHaste::endsInHaste()
{
    QFETCH(HastyEnd, end);
    QFETCH(double, shake);
    for (const unsigned seed : {3U, 7U, 11U})
        for (const bool isBackwards : {false, true}) {
            const StrokeContour stroke =
                strokeContour(halfDisc(end, shake, seed, isBackwards),
                              {.tolerance = kPixels, .axis = MirrorAxis()});
            QVERIFY(stroke.isMirrored && stroke.contour);
            const Vec2 size = bounds(stroke.contour->flatten(0.1).points).size();
            const double area = std::abs(stroke.contour->signedArea());
            const QByteArray got = QByteArray::number(size.x()) + " × " +
                                   QByteArray::number(size.y()) + ", " +
                                   QByteArray::number(area / (kHalfTurn * kDisc * kDisc));
            QVERIFY2(std::abs(size.x() - 2.0 * kDisc) <= 8.0, got);
            QVERIFY2(std::abs(size.y() - 2.0 * kDisc) <= 8.0, got);
            QVERIFY2(std::abs(area / (kHalfTurn * kDisc * kDisc) - 1.0) <= 0.05, got);
        }
}

/// A fin of 20 px, whose sides run near the axis for long.
void TestSymmetryInHaste::aTrembleIsNoOtherSide()
{
    for (const double shake : {0.5, 1.0, 1.5})
        for (unsigned seed = 1; seed <= 8; ++seed) {
            SloppyHand hand(6.0, shake, seed);
            hand.start({0.0, 0.0});
            for (const Vec2 &to :
                 {Vec2(60.0, 12.0), Vec2(200.0, 20.0), Vec2(340.0, 12.0), Vec2(400.0, 0.0)})
                hand.to(to);
            const StrokeContour stroke =
                strokeContour(hand.samples(), {.tolerance = kPixels, .axis = MirrorAxis()});
            QVERIFY2(stroke.isMirrored && stroke.contour, QByteArray::number(seed));
            const Vec2 size = bounds(stroke.contour->flatten(0.1).points).size();
            QVERIFY2(std::abs(size.x() - 400.0) <= 30.0, QByteArray::number(size.x()));
            QVERIFY2(std::abs(size.y() - 40.0) <= 8.0, QByteArray::number(size.y()));
        }
}

void TestSymmetryInHaste::aWaistKeepsBothLobes_data()
{
    QTest::addColumn<double>("waist"); // px, over the axis
    for (const double waist : {6.0, 2.0, 0.5, 0.0, -2.0, -4.0})
        QTest::addRow("%g px", waist) << waist;
}

/// A large lobe and a small one, between them a waist that is meant to be thin: wrong was that the
/// small one went without a word.
void TestSymmetryInHaste::aWaistKeepsBothLobes()
{
    QFETCH(double, waist);
    const Samples smooth = curve([&](double t) {
        const double u = 300.0 * t, high = t < 0.6 ? 80.0 : 40.0;
        const double share = t < 0.6 ? t / 0.6 : (1.0 - t) / 0.4;
        const double floor = t < 0.6 ? share * waist : waist - (1.0 - share) * waist;
        return Vec2(u, floor + high * std::sin(kHalfTurn * share));
    });
    for (const double shake : {0.0, 1.0})
        for (unsigned seed = 1; seed <= 4; ++seed)
            for (const bool isBackwards : {false, true}) {
                SloppyHand hand(4.0, shake, seed);
                hand.start(smooth.front());
                for (std::size_t i = 4; i < smooth.size(); i += 4)
                    hand.to(smooth[i]);
                hand.to(smooth.back());
                Samples samples = hand.samples();
                if (isBackwards)
                    std::reverse(samples.begin(), samples.end());
                const StrokeContour stroke =
                    strokeContour(samples, {.tolerance = kPixels, .axis = MirrorAxis()});
                QVERIFY(stroke.isMirrored && stroke.contour);
                const Vec2 size = bounds(stroke.contour->flatten(0.1).points).size();
                QVERIFY2(std::abs(size.x() - 300.0) <= 12.0, QByteArray::number(size.x()));
                QVERIFY(!isCrossing(*stroke.contour));
            }
}

FFF_TEST(TestSymmetryInHaste)
#include "tst_symmetry_in_haste.moc"
