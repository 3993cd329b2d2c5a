#include "core/interaction/stroke_gesture.h"
#include "tests/core/interaction/desk.h"
#include "tests/test_program.h"

#include <cmath>
#include <numbers>

using namespace fff;
using namespace fff::test;

// A stroke of thousands of moves in the view. What would be wrong: a section that is not the one
// that was shown, one that depends on how moves come in bursts, or a preview for every move of a
// stroke without end.

namespace {

constexpr int kMoves = 6000;

Vec2 bays(double u)
{
    const double a = 2.0 * std::numbers::pi * 0.99 * u;
    const double radius = 250.0 + 40.0 * std::sin(3.0 * a) + 30.0 * std::cos(37.0 * a);
    return 0.5 * kViewport + radius * Vec2(std::cos(a), std::sin(a));
}

Vec2 scribble(int i)
{
    const double a = i / 160.0;
    return 0.5 * kViewport + Vec2(420.0 * std::cos(0.311 * a) * std::cos(a),
                                  300.0 * std::sin(0.277 * a + 0.3) * std::sin(1.37 * a));
}

/// All of it but the release.
void draw(Desk &desk, int burst)
{
    desk.interaction.settings().mirrorsFirst = false;
    desk.press(bays(0.0));
    for (int i = 1; i <= kMoves; ++i) {
        desk.isBursting = burst > 1 && i % burst != 0;
        desk.send(Desk::Type::Move, bays(double(i) / kMoves));
    }
    desk.isBursting = false;
}

} // namespace

class TestLongStrokesShown : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aFrameShowsAllOfIt();
    void burstsChangeNothing();
    void aScribbleWaitsForTheHandToRest();
};

/// The line of the cursor is there with every move, the section with those that it is paid for by;
/// a frame shows the section that a release makes.
void TestLongStrokesShown::aFrameShowsAllOfIt()
{
    Desk desk;
    const std::uint64_t before = desk.session.revision();
    draw(desk, 1);
    QVERIFY2(desk.session.revision() - before < kMoves / 2,
             qPrintable(QString::number(desk.session.revision() - before)));
    // Until there is a move that is not paid for: then it asks for a frame.
    for (int more = 0; more < 100 && !desk.interaction.isAnimating(); ++more)
        desk.send(Desk::Type::Move, bays(1.0 - 0.001 * (more % 2)));
    QVERIFY(desk.interaction.isAnimating());
    const Vec2 end = desk.interaction.overlay().find<sign::Stroke>()->samples.back();
    desk.wait(16.0);
    QVERIFY(!desk.interaction.isAnimating());
    QCOMPARE(desk.interaction.overlay().find<sign::Stroke>()->samples.back(), end);
    QVERIFY(desk.session.hasPreview());
    const ShapePointer shown = desk.session.model().document.sections.back()->shape;
    desk.release(desk.cursor);
    QCOMPARE(desk.steps(), 1);
    QVERIFY(*desk.sections().back()->shape == *shown);
}

void TestLongStrokesShown::burstsChangeNothing()
{
    Desk one, many;
    draw(one, 1);
    draw(many, 16);
    one.release(bays(1.0));
    many.release(bays(1.0));
    QCOMPARE(one.steps(), 1);
    QVERIFY(*one.sections().back()->shape == *many.sections().back()->shape);
}

/// What takes longer than a frame would hold up the line of the cursor.
void TestLongStrokesShown::aScribbleWaitsForTheHandToRest()
{
    Desk desk;
    desk.interaction.settings().mirrorsFirst = false;
    desk.press(scribble(0));
    std::uint64_t half = 0;
    for (int i = 1; i <= 20000; ++i) {
        if (i == 10000)
            half = desk.session.revision();
        desk.send(Desk::Type::Move, scribble(i));
    }
    QCOMPARE(desk.session.revision(), half);
    QVERIFY(desk.interaction.isAnimating());
    desk.wait(16.0);
    QCOMPARE(desk.session.revision(), half);
    desk.wait(StrokeGesture::kRest);
    QVERIFY(!desk.interaction.isAnimating());
    QVERIFY(desk.session.revision() > half);
    const ShapePointer shown = desk.session.model().document.sections.back()->shape;
    desk.release(scribble(20000));
    QCOMPARE(desk.steps(), 1);
    QVERIFY(*desk.sections().back()->shape == *shown);
}

FFF_TEST(TestLongStrokesShown)
#include "tst_long_strokes_shown.moc"
