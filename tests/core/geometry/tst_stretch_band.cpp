// A plane that is stretched between two places: lengths, what only moves, and that curves stay
// smooth and lines straight.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/geometry/contour_points.h"
#include "core/geometry/mapped_contour.h"
#include "core/geometry/stretch_band.h"
#include "tests/core/shapes.h"
#include "tests/rounds.h"
#include "tests/test_program.h"

#include <algorithm>
#include <cmath>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

/// mm
constexpr double kRounding = 1e-9;

double apart(const Contour &a, const Contour &b)
{
    if (a.points().size() != b.points().size())
        return 1e9;
    double most = 0.0;
    for (std::size_t i = 0; i < a.points().size(); ++i)
        most = std::max(most, (a.points()[i] - b.points()[i]).norm());
    return most;
}

} // namespace

class TestStretchBand : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aRectangleStaysOne();
    void aCircleBecomesAnEllipse();
    void aNotchWidens();
    void theOtherHalfDoesTheSame();
    void whatLiesAsideIsMovedOnly();
    void smoothStaysSmooth();
    void thereAndBack();
};

// Wrong: only the points nearest to the places would move, and a rectangle would lean.
void TestStretchBand::aRectangleStaysOne()
{
    const Contour board = polygonContour(rectangleAt(0, 0, 100, 300));
    const StretchBand band{{0, 0}, {100, 0}, 140.0, {0, 0}};
    const Contour wide = mapped(board, band).value();
    QVERIFY(apart(wide, polygonContour(rectangleAt(0, 0, 140, 300))) < kRounding);
    const StretchBand aboutMiddle{{0, 0}, {100, 0}, 140.0, {50, 10}};
    QVERIFY(apart(mapped(board, aboutMiddle).value(),
                  polygonContour(rectangleAt(-20, 0, 140, 300))) < kRounding);
}

void TestStretchBand::aCircleBecomesAnEllipse()
{
    const StretchBand band{{-50, 0}, {50, 0}, 180.0, {0, 0}};
    Eigen::Matrix2d matrix = Eigen::Matrix2d::Identity();
    matrix(0, 0) = 1.8;
    QVERIFY(apart(mapped(circle({0, 0}, 50), band).value(),
                  mapped(circle({0, 0}, 50), matrix, Vec2(0, 0)).value()) < kRounding);
}

// A notch of 20 in an edge: its walls stay upright, and what is beside it keeps its form.
void TestStretchBand::aNotchWidens()
{
    const Contour board = polygonContour(
        {{0, 0}, {100, 0}, {100, 60}, {60, 60}, {60, 40}, {40, 40}, {40, 60}, {0, 60}});
    const StretchBand band{{40, 60}, {60, 60}, 26.0, {40, 60}};
    const Contour wide = mapped(board, band).value();
    QVERIFY(
        apart(wide,
              polygonContour(
                  {{0, 0}, {106, 0}, {106, 60}, {66, 60}, {66, 40}, {40, 40}, {40, 60}, {0, 60}})) <
        kRounding);
}

// From the middle of a circle or beside it, either way round: it stays the same on both sides.
void TestStretchBand::theOtherHalfDoesTheSame()
{
    for (const auto &[from, to] : {std::pair{10.0, 40.0}, std::pair{40.0, 10.0},
                                   std::pair{0.0, 50.0}, std::pair{-50.0, -20.0}}) {
        StretchBand band{{from, 3}, {to, 3}, 44.0, {0, 0}, Vec2(0, 7)};
        const Contour wide = mapped(circle({0, 0}, 50), band).value();
        QVERIFY(std::abs((band(band.to) - band(band.from)).norm() - 44.0) < kRounding);
        for (const double x : {5.0, 20.0, 45.0, 60.0}) {
            const Vec2 right = band(Vec2(x, 9)), left = band(Vec2(-x, 9));
            QVERIFY((right - Vec2(-left.x(), left.y())).norm() < kRounding);
        }
        QVERIFY((band(Vec2(0, 9)) - Vec2(0, 9)).norm() < kRounding);
        const Box2 box = wide.bounds();
        QVERIFY(std::abs(box.min.x() + box.max.x()) < kRounding);
        QVERIFY(std::abs(box.size().y() - 100.0) < kRounding);
        band.stays = {30, 0};
        QVERIFY((band(band.stays) - band.stays).norm() < kRounding);
    }
}

void TestStretchBand::whatLiesAsideIsMovedOnly()
{
    const StretchBand band{{0, 0}, {30, 40}, 80.0, {0, 0}};
    const Vec2 by = 30.0 * Vec2(0.6, 0.8);
    const Contour behind = circle({90, 120}, 20), before = circle({-60, -80}, 20);
    QVERIFY(apart(mapped(before, band).value(), before) < kRounding);
    std::vector<Vec2> shifted = behind.points();
    for (Vec2 &p : shifted)
        p += by;
    QVERIFY(apart(mapped(behind, band).value(), Contour::fromPoints(shifted).value()) < kRounding);
    QVERIFY((*band.shiftOf({{60, 90}, {70, 100}}) - by).norm() < kRounding);
    QVERIFY(band.shiftOf({{-70, -90}, {-60, -80}})->norm() < kRounding);
    QVERIFY(!band.shiftOf({{-70, -90}, {70, 80}}));
    QVERIFY(!band.shiftOf({{10, 10}, {11, 12}}));
    QVERIFY(!band.shiftOf({{40, -40}, {41, -10}})); // a corner reaches in
}

void TestStretchBand::smoothStaysSmooth()
{
    std::mt19937 random(7);
    const auto between = [&random](double least, double most) {
        return std::uniform_real_distribution<double>(least, most)(random);
    };
    for (int round = 0; round < rounds(2000); ++round) {
        const Contour before = blob(random, 3 + round % 9, 60.0);
        // From one anchor to another one, as a person measures, or anywhere.
        const int last = before.segmentCount() - 1;
        const bool isAtAnchors = round % 2;
        const StretchBand band{
            isAtAnchors ? anchor(before, 0) : Vec2(between(-60, 60), between(-60, 60)),
            isAtAnchors ? anchor(before, last / 2 + 1) : Vec2(between(61, 90), between(61, 90)),
            between(10, 200), anchor(before, last)};
        const Contour after = mapped(before, band).value();
        QVERIFY(std::abs((band(band.to) - band(band.from)).norm() - band.length) < kRounding);
        QVERIFY((band(band.stays) - band.stays).norm() < kRounding);
        for (int i = 0; i <= last; ++i) {
            QVERIFY((anchor(after, i) - band(anchor(before, i))).norm() < kRounding);
            if (kindOf(before, i) != PointKind::Corner)
                QVERIFY2(kindOf(after, i) != PointKind::Corner, qPrintable(QString::number(round)));
            QCOMPARE(isLine(after.segment(i)), isLine(before.segment(i)));
        }
    }
}

/// Twice by half is once by all, and back is as it was: a slider comes back to where it was.
void TestStretchBand::thereAndBack()
{
    std::mt19937 random(8);
    for (int round = 0; round < rounds(500); ++round) {
        const Contour before = blob(random, 3 + round % 9, 60.0);
        const Vec2 from = anchor(before, 0), to = anchor(before, before.segmentCount() / 2);
        const double length = (to - from).norm();
        const StretchBand out{from, to, 1.7 * length, from};
        const StretchBand on{from, out(to), 2.3 * length, from},
            back{from, on(out(to)), length, from};
        const Contour all = mapped(mapped(before, out).value(), on).value();
        QVERIFY(apart(all, mapped(before, StretchBand{from, to, 2.3 * length, from}).value()) <
                1e-6);
        QVERIFY(apart(mapped(all, back).value(), before) < 1e-6);
    }
}

FFF_TEST(TestStretchBand)
#include "tst_stretch_band.moc"
