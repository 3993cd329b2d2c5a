#include "core/base/tolerances.h"
#include "core/geometry/bezier.h"
#include "tests/test_program.h"

#include <QTest>

#include <random>

using namespace fff;

namespace {

CubicBezier randomCurve(std::mt19937 &random)
{
    std::uniform_real_distribution<double> place(-100, 100);
    const auto p = [&] { return Vec2(place(random), place(random)); };
    return {p(), p(), p(), p()};
}

} // namespace

class TestBezier : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void endsAreExact();
    void pieceIsTheSameCurve();
    void wholePieceIsTheCurveItself();
    void backwardPieceIsReversed();
    void derivativesAreSlopes();
    void chordsStayWithinTheTolerance();
    void straightness_data();
    void straightness();
};

// Wrong: neighbouring segments would not meet to the last bit.
void TestBezier::endsAreExact()
{
    std::mt19937 random(1);
    for (int i = 0; i < 100; ++i) {
        const CubicBezier c = randomCurve(random);
        QVERIFY(c.at(0.0) == c.p0 && c.at(1.0) == c.p3);
        const CubicBezier piece = c.piece(0.2, 0.7);
        QVERIFY(piece.p0 == c.at(0.2) && piece.p3 == c.at(0.7));
    }
}

// Wrong: cutting a curve would bend it.
void TestBezier::pieceIsTheSameCurve()
{
    std::mt19937 random(2);
    for (int i = 0; i < 100; ++i) {
        const CubicBezier c = randomCurve(random);
        const CubicBezier piece = c.piece(0.15, 0.85);
        for (double t : {0.1, 0.5, 0.9})
            QVERIFY((piece.at(t) - c.at(0.15 + 0.7 * t)).norm() < 1e-12 * 100);
    }
}

// Wrong: curves that nothing cuts would change by rounding.
void TestBezier::wholePieceIsTheCurveItself()
{
    std::mt19937 random(3);
    const CubicBezier c = randomCurve(random), same = c.piece(0.0, 1.0);
    QVERIFY(same.p0 == c.p0 && same.p1 == c.p1 && same.p2 == c.p2 && same.p3 == c.p3);
}

// Wrong: holes, which are run through backwards, would be cut from the wrong end.
void TestBezier::backwardPieceIsReversed()
{
    std::mt19937 random(4);
    const CubicBezier c = randomCurve(random);
    const CubicBezier back = c.piece(0.8, 0.3);
    for (double t : {0.0, 0.4, 1.0})
        QVERIFY((back.at(t) - c.at(0.8 - 0.5 * t)).norm() < 1e-12 * 100);
}

// Wrong: Newton's steps and offsets would go astray.
void TestBezier::derivativesAreSlopes()
{
    constexpr double kStep = 1e-5;
    std::mt19937 random(5);
    for (int i = 0; i < 20; ++i) {
        const CubicBezier c = randomCurve(random);
        for (double t : {0.1, 0.6}) {
            const Vec2 slope = (c.at(t + kStep) - c.at(t - kStep)) / (2.0 * kStep);
            QVERIFY((c.derivative(t) - slope).norm() < 1e-5);
            const Vec2 bend = (c.derivative(t + kStep) - c.derivative(t - kStep)) / (2.0 * kStep);
            QVERIFY((c.secondDerivative(t) - bend).norm() < 1e-5);
        }
    }
}

// Wrong: "within 0.01 mm" would be a promise without ground.
void TestBezier::chordsStayWithinTheTolerance()
{
    std::mt19937 random(6);
    for (int i = 0; i < 50; ++i) {
        const CubicBezier c = randomCurve(random);
        const int count = c.chordCount(kCutChord);
        QVERIFY(count >= 1 && count <= CubicBezier::kMaxChords);
        for (int k = 0; k < count; ++k) {
            const Vec2 a = c.at(static_cast<double>(k) / count);
            const Vec2 b = c.at((k + 1.0) / count);
            const Vec2 middle = c.at((k + 0.5) / count);
            QVERIFY((0.5 * (a + b) - middle).norm() <= kCutChord);
        }
    }
}

void TestBezier::straightness_data()
{
    QTest::addColumn<Vec2>("h1");
    QTest::addColumn<Vec2>("h2");
    QTest::addColumn<bool>("straight");
    QTest::newRow("handles at the thirds") << Vec2(1, 0) << Vec2(2, 0) << true;
    QTest::newRow("handles on the ends") << Vec2(0, 0) << Vec2(3, 0) << true;
    QTest::newRow("a handle off the chord") << Vec2(1, 0.1) << Vec2(2, 0) << false;
    QTest::newRow("a handle beyond the end") << Vec2(4, 0) << Vec2(2, 0) << false;
    QTest::newRow("a handle before the start") << Vec2(-1, 0) << Vec2(2, 0) << false;
}

// Wrong: an edge that runs back on itself would be one chord, or a straight one hundreds.
void TestBezier::straightness()
{
    QFETCH(Vec2, h1);
    QFETCH(Vec2, h2);
    QFETCH(bool, straight);
    QCOMPARE(CubicBezier({Vec2(0, 0), h1, h2, Vec2(3, 0)}).isStraight(kClipGrid), straight);
    QVERIFY(CubicBezier::line({0, 0}, {3, 4}).isStraight(kClipGrid));
}

FFF_TEST(TestBezier)
#include "tst_bezier.moc"
