#include "tests/core/interaction/desk.h"

#include "core/geometry/mirrored_boundaries.h"
#include "core/interaction/offer_words.h"
#include "core/model/figures.h"
#include "core/model/symmetric_section.h"
#include "tests/test_program.h"

#include <cmath>
#include <numbers>

using namespace fff;
using namespace fff::test;

// What would be wrong: an offer that stays when something else is done, one that takes two steps to
// undo, or makes what could not be drawn there.

namespace {

/// A little further than once round.
void drawRound(Desk &desk, const Vec2 &middle, const Vec2 &radii)
{
    const auto at = [&](double t) {
        const double a = 2.0 * std::numbers::pi * t;
        return Vec2(middle.x() + radii.x() * std::cos(a), middle.y() + radii.y() * std::sin(a));
    };
    desk.moveTo(at(0.0));
    desk.press(at(0.0));
    for (int i = 1; i <= 80; ++i)
        desk.moveTo(at(i / 78.0), {}, 1);
    desk.release(desk.cursor);
}

bool isOffered(const Desk &desk)
{
    const bool isShown = !desk.interaction.overlay().offered.isEmpty();
    return desk.interaction.hasOffer() && isShown && desk.commands.isEnabled("section.takeOffer");
}

} // namespace

class TestShapeOffers : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void circleIsTakenInOneStep();
    void ellipseHasItsNumbers();
    void offerGoesWithTheNextThing();
    void holeIsOffered();
    void groundStillCuts();
    void whatIsMirroredStaysSo();
    void blobIsNot();
};

void TestShapeOffers::circleIsTakenInOneStep()
{
    Desk desk;
    QVERIFY(!desk.commands.isEnabled("section.takeOffer"));
    drawRound(desk, {640, 300}, {90, 90});
    QCOMPARE(desk.sections().size(), std::size_t(1));
    QVERIFY(isOffered(desk));
    const Contour drawn = desk.sections()[0]->shape->contour();
    const int steps = desk.steps();
    desk.run("section.takeOffer");
    QCOMPARE(desk.hint(), hints::kIsCircle);
    QVERIFY(!desk.interaction.hasOffer() && desk.interaction.overlay().offered.isEmpty());
    QCOMPARE(desk.sections().size(), std::size_t(1));
    QCOMPARE(desk.steps(), steps + 1);
    const Figure *figure = figureOf(*desk.sections()[0], 0);
    QVERIFY(figure && figure->kind == "circle");
    const double scale = desk.interaction.camera().millimetresPerPixel;
    QVERIFY(std::abs(figure->numbers[0] - 180.0 * scale) < 3.0 * scale);
    desk.run("edit.undo");
    QVERIFY(desk.sections()[0]->shape->contour() == drawn);
}

void TestShapeOffers::ellipseHasItsNumbers()
{
    Desk desk;
    drawRound(desk, {640, 300}, {150, 70});
    QVERIFY(isOffered(desk));
    desk.run("section.takeOffer");
    const Figure *figure = figureOf(*desk.sections()[0], 0);
    QVERIFY(figure && figure->kind == "ellipse");
    const double scale = desk.interaction.camera().millimetresPerPixel;
    QVERIFY(std::abs(figure->numbers[0] - 300.0 * scale) < 4.0 * scale);
    QVERIFY(std::abs(figure->numbers[1] - 140.0 * scale) < 4.0 * scale);
}

void TestShapeOffers::offerGoesWithTheNextThing()
{
    const auto offered = [](Desk &desk) { drawRound(desk, {640, 300}, {90, 90}); };
    Desk pressed, escaped, undone, held;
    for (Desk *desk : {&pressed, &escaped, &undone, &held}) {
        offered(*desk);
        QVERIFY(isOffered(*desk));
    }
    pressed.press({640, 300});
    QVERIFY(!pressed.interaction.hasOffer());
    QVERIFY(escaped.interaction.escape(escaped.time += 8.0));
    QVERIFY(!escaped.interaction.hasOffer());
    QCOMPARE(escaped.sections().size(), std::size_t(1)); // what was drawn stays
    undone.run("edit.undo");
    QVERIFY(!undone.interaction.hasOffer());
    held.run("section.pen");
    QVERIFY(!held.interaction.hasOffer());
    held.run("section.takeOffer"); // does nothing
    QCOMPARE(held.sections().size(), std::size_t(1));
    QVERIFY(held.sections()[0]->figures.empty());
}

void TestShapeOffers::holeIsOffered()
{
    Desk desk;
    desk.addPlate();
    desk.click(desk.plate(0, 0));
    desk.run("section.addHole");
    desk.wait(kTurnTime);
    drawRound(desk, desk.plate(0, 0), {40, 40});
    QCOMPARE(desk.sections()[0]->shape->holes().size(), std::size_t(1));
    QVERIFY(isOffered(desk));
    desk.run("section.takeOffer");
    QCOMPARE(desk.sections()[0]->shape->holes().size(), std::size_t(1));
    const Figure *figure = figureOf(*desk.sections()[0], 1);
    QVERIFY(figure && figure->kind == "circle");
}

/// A circle that the ground cuts stays cut, and is no figure.
void TestShapeOffers::groundStillCuts()
{
    Desk desk;
    const Vec2 ground = desk.front(0, 0);
    drawRound(desk, ground - Vec2(0, 60), {110, 110});
    QCOMPARE(desk.sections().size(), std::size_t(1));
    if (!desk.interaction.hasOffer())
        QFAIL("a circle is offered as one wherever it lies");
    const sign::Curve *shown = desk.interaction.overlay().offered.find<sign::Curve>();
    QVERIFY(shown);
    for (const Vec2 &p : shown->contour.points())
        QVERIFY(shown->frame.toWorld(p).y() > -0.01); // it is what comes, not what was meant
    desk.run("section.takeOffer");
    const Section &section = *desk.sections()[0];
    double lowest = 1e9;
    for (const Vec2 &p : section.shape->contour().points())
        lowest = std::min(lowest, section.frame.toWorld(p).y());
    QVERIFY2(lowest > -1e-6, qPrintable(QString::number(lowest)));
    QVERIFY(section.figures.empty());
}

/// Half a circle beside the axis: the whole one has its middle on it, and both sides go on alike.
void TestShapeOffers::whatIsMirroredStaysSo()
{
    Desk desk;
    desk.interaction.settings().mirrorsFirst = true;
    const auto at = [](double t) {
        const double a = std::numbers::pi * (t - 0.5);
        return Vec2(640.0 + 102.0 * std::cos(a), 300.0 + 98.0 * std::sin(a));
    };
    desk.moveTo(at(0.0));
    desk.press(at(0.0));
    for (int i = 1; i <= 60; ++i)
        desk.moveTo(at(i / 60.0), {}, 1);
    desk.release(desk.cursor);
    QCOMPARE(desk.sections().size(), std::size_t(1));
    const std::optional<MirrorAxis> axis = desk.sections()[0]->symmetry;
    QVERIFY(axis && isOffered(desk));
    desk.run("section.takeOffer");
    const Section &section = *desk.sections()[0];
    const Figure *figure = figureOf(section, 0);
    QVERIFY(figure && figure->kind == "circle");
    QVERIFY(symmetryOf(section));
    QVERIFY(std::abs(symmetryOf(section)->height(figure->centre)) < kSameImage);
}

void TestShapeOffers::blobIsNot()
{
    Desk desk;
    const auto at = [](double t) {
        const double a = 2.0 * std::numbers::pi * t;
        const double r = 100.0 * (1.0 + 0.3 * std::cos(2.0 * a) + 0.15 * std::sin(3.0 * a));
        return Vec2(640.0 + r * std::cos(a), 300.0 + r * std::sin(a));
    };
    desk.moveTo(at(0.0));
    desk.press(at(0.0));
    for (int i = 1; i <= 90; ++i)
        desk.moveTo(at(i / 90.0), {}, 1);
    desk.release(desk.cursor);
    QCOMPARE(desk.sections().size(), std::size_t(1));
    QVERIFY(!desk.interaction.hasOffer());
}

FFF_TEST(TestShapeOffers)
#include "tst_shape_offers.moc"
