#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/geometry/fit.h"
#include "core/interaction/contour_words.h"
#include "core/interaction/pen_tool.h"
#include "core/interaction/pen_words.h"
#include "core/interaction/stroke_words.h"
#include "tests/core/interaction/desk.h"
#include "tests/test_program.h"

#include <cmath>

using namespace fff;
using namespace fff::test;
using Type = PointerEvent::Type;

namespace {

/// A person with the pen in hand, before the front view.
class PenDesk : public Desk
{
public:
    /// Where the canvas has this place.
    Vec2 onCanvas(double x, double y) const { return screen(marks().canvas.toWorld({x, y})); }
    const PenMarks &marks() const { return *interaction.overlay().find<PenMarks>(); }
    std::size_t pointCount() const
    {
        return interaction.overlay().find<PenMarks>() ? marks().points.size() : 0;
    }
    Vec3 point(std::size_t i) const { return marks().canvas.toWorld(marks().points[i].at); }
    bool key(ToolKey key) { return interaction.key(key, time += 8.0); }
};

/// 60 × 40 mm in the front view.
void setRectangle(PenDesk &desk)
{
    for (const Vec2 &corner : {Vec2(-30, 60), Vec2(30, 60), Vec2(30, 100), Vec2(-30, 100)})
        desk.click(desk.front(corner.x(), corner.y()));
}

/// Out of the plate's right edge at its middle height, to where clicks set points.
void turnToCanvas(PenDesk &desk)
{
    const Vec2 from = desk.front(20, kFirstPlaneHeight), to = desk.front(110, kFirstPlaneHeight);
    desk.moveTo(from);
    desk.press(from);
    desk.moveTo(to);
    desk.wait(kTurnTime);
    desk.wait(kTurnTime);
}

} // namespace

class TestPen : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void clicksMakeTheFirstSection();
    void closing_data();
    void closing();
    void whatEnclosesNothingIsRefused();
    void dragsBendSmoothly();
    void controlBreaksHandles();
    void shiftHoldsDirections();
    void setPointsCanBeMoved();
    void snappedPointsLieOnTheGrid();
    void controlLeavesTheGrid();
    void slitsBeginACanvas();
    void releasingInTheTurnGoesOn();
    void aClickOnASectionSelects();
    void besideSectionsTheViewTurns();
    void theViewMovesUnderThePath();
    void nothingFollowsACursorThatIsElsewhere();
    void backspaceTakesOneBack();
    void escapeGoesBackStepByStep();
    void undoGoesThroughThePathFirst();
    void previewIsWhatIsCommitted();
    void crossingPathsAreSaid();
    void numbersSetPoints();
    void canvasesAreShared_data();
    void canvasesAreShared();
    void anotherCanvasWaitsForThePath();
    void aParallelPlaneMoves();
    void editsElsewhereKeepThePath();
    void aLostCanvasIsSaid();
    void strokesAreAsEverWithoutThePen();
};

void TestPen::clicksMakeTheFirstSection()
{
    PenDesk desk;
    desk.run("section.pen");
    setRectangle(desk);
    QCOMPARE(desk.pointCount(), std::size_t(4));
    QVERIFY(desk.session.hasPreview());
    QVERIFY(desk.sections().empty());
    QVERIFY(desk.key(ToolKey::Enter));
    QCOMPARE(desk.sections().size(), std::size_t(1));
    QCOMPARE(desk.steps(), 1);
    QCOMPARE(desk.session.history()->undoText(), QStringLiteral("Draw Section 1"));
    const Section &section = *desk.sections().front();
    QCOMPARE(section.shape->contour().segmentCount(), 4);
    QVERIFY(std::abs(section.shape->area() - 2400.0) < 1e-9);
    QVERIFY(std::abs(section.frame.normal().z()) > 1.0 - 1e-12);
    QVERIFY(!desk.session.hasPreview());
    // The pen stays in the hand.
    QVERIFY(desk.interaction.tool());
    QVERIFY(!desk.interaction.overlay().find<PenMarks>());
}

void TestPen::closing_data()
{
    QTest::addColumn<int>("way");
    QTest::newRow("Enter") << 0;
    QTest::newRow("a click on the first point") << 1;
    QTest::newRow("a double click at the last point") << 2;
    QTest::newRow("a double click that Qt has found") << 3;
}

/// All ways to close make the same section, in one step.
void TestPen::closing()
{
    QFETCH(int, way);
    PenDesk desk;
    desk.run("section.pen");
    for (const Vec2 &corner : {Vec2(-30, 60), Vec2(30, 60), Vec2(30, 100)})
        desk.click(desk.front(corner.x(), corner.y()));
    const Vec2 last = desk.front(-30, 100);
    desk.moveTo(last);
    desk.press(last);
    desk.release(last);
    if (way == 0) {
        desk.key(ToolKey::Enter);
    } else if (way == 1) {
        desk.moveTo(desk.front(-29, 61));
        QCOMPARE(desk.hint(), hints::kPenClosing);
        QVERIFY(desk.marks().isClosing);
        QCOMPARE(int(desk.interaction.cursor()), int(Cursor::PenCloses));
        desk.press(desk.front(-29, 61));
        desk.release(desk.front(-29, 61));
    } else {
        desk.send(way == 2 ? Type::Press : Type::DoubleClick, last, Button::Left);
        desk.release(last);
    }
    QCOMPARE(desk.sections().size(), std::size_t(1));
    QCOMPARE(desk.steps(), 1);
    QCOMPARE(desk.sections().front()->shape->contour().segmentCount(), 4);
    QVERIFY(std::abs(desk.sections().front()->shape->area() - 2400.0) < 1e-9);
}

void TestPen::whatEnclosesNothingIsRefused()
{
    PenDesk desk;
    desk.run("section.pen");
    QVERIFY(!desk.key(ToolKey::Enter)); // nothing to close yet, nothing said
    desk.click(desk.front(0, 60));
    desk.click(desk.front(50, 60));
    QVERIFY(desk.key(ToolKey::Enter));
    QCOMPARE(desk.hint(), hints::kNothingToClose);
    QVERIFY(desk.interaction.hint().isRefusal);
    QCOMPARE(desk.pointCount(), std::size_t(2));
    QCOMPARE(desk.steps(), 0);
    // Two clicks at one place are no point twice.
    desk.click(desk.front(50, 100));
    desk.click(desk.front(50, 100));
    QCOMPARE(desk.pointCount(), std::size_t(3));
}

void TestPen::dragsBendSmoothly()
{
    PenDesk desk;
    desk.run("section.pen");
    desk.drag({desk.front(-50, 80), desk.front(-50, 120)});
    desk.drag({desk.front(50, 80), desk.front(50, 40)});
    QCOMPARE(desk.pointCount(), std::size_t(2));
    const PathPoint &bent = desk.marks().points[1];
    QVERIFY(bent.in && bent.out && (*bent.in + *bent.out).norm() < 1e-12);
    QVERIFY((*bent.out - Vec2(0, -40)).norm() < 1e-6);
    QVERIFY(desk.key(ToolKey::Enter));
    const Contour &contour = desk.sections().front()->shape->contour();
    QCOMPARE(contour.segmentCount(), 2);
    for (int i = 0; i < 2; ++i) {
        const Vec2 before = endDirection(contour.segment(i)),
                   after = startDirection(contour.segment(1 - i));
        QVERIFY((before - after).norm() < 1e-9);
    }
}

void TestPen::controlBreaksHandles()
{
    PenDesk desk;
    desk.run("section.pen");
    desk.click(desk.front(-50, 80));
    desk.moveTo(desk.front(50, 80));
    desk.press(desk.front(50, 80));
    desk.moveTo(desk.front(80, 80));
    desk.moveTo(desk.front(50, 120), kControl);
    desk.release(desk.front(50, 120), Button::Left, kControl);
    const PathPoint &point = desk.marks().points[1];
    QVERIFY((*point.out - Vec2(0, 40)).norm() < 1e-6);
    QVERIFY((*point.in - Vec2(-30, 0)).norm() < 1e-6);
    // And its handle can be taken hold of again.
    desk.drag({desk.front(50, 120), desk.front(90, 120)});
    QVERIFY((*desk.marks().points[1].out - Vec2(40, 40)).norm() < 1e-6);
    QCOMPARE(desk.pointCount(), std::size_t(2));
}

void TestPen::shiftHoldsDirections()
{
    PenDesk desk;
    desk.run("section.pen");
    desk.run("section.snap", {{"on", "false"}});
    desk.click(desk.front(3.3, 57.7));
    desk.click(desk.front(60, 63), kShift);
    desk.click(desk.front(81, 96), kShift);
    QVERIFY(std::abs(desk.point(1).y() - desk.point(0).y()) < 1e-9);
    const Vec3 way = desk.point(2) - desk.point(1);
    QVERIFY(std::abs(way.x() - way.y()) < 1e-9 && way.x() > 10.0);
}

void TestPen::setPointsCanBeMoved()
{
    PenDesk desk;
    desk.run("section.pen");
    setRectangle(desk);
    desk.drag({desk.front(30, 100), desk.front(60, 130)});
    QCOMPARE(desk.pointCount(), std::size_t(4));
    QVERIFY((desk.point(2) - Vec3(60, 130, 0)).norm() < 1e-9);
    // Also the first one, which a click closes.
    desk.drag({desk.front(-30, 60), desk.front(-40, 50)});
    QVERIFY((desk.point(0) - Vec3(-40, 50, 0)).norm() < 1e-9);
    QVERIFY(desk.sections().empty());
}

void TestPen::snappedPointsLieOnTheGrid()
{
    PenDesk desk;
    desk.run("section.pen");
    const double step = gridStep(desk.interaction.camera().millimetresPerPixel);
    for (const Vec2 &at : {Vec2(-31.3, 58.9), Vec2(31.1, 62.4), Vec2(12.2, 131.7)}) {
        desk.click(desk.front(at.x(), at.y()));
        const Vec3 set = desk.point(desk.pointCount() - 1);
        for (const double value : {set.x(), set.y()})
            QVERIFY(std::abs(value / step - std::round(value / step)) * step < 1e-9);
        QVERIFY((set.head<2>() - at).norm() < step);
    }
    desk.moveTo(desk.front(200, desk.point(0).y() + 1.0));
    QCOMPARE(int(desk.marks().snap->kind), int(Snap::Kind::Line)); // level with the first point
    QCOMPARE(desk.hint(), hints::kPenSnapped);
}

/// With Ctrl the left button turns the view, but a click is still the pen's.
void TestPen::controlLeavesTheGrid()
{
    PenDesk desk;
    desk.run("section.pen");
    desk.click(desk.front(-31.3, 58.9), kControl);
    QCOMPARE(desk.pointCount(), std::size_t(1));
    QVERIFY((desk.point(0).head<2>() - Vec2(-31.3, 58.9)).norm() < 1e-6);
    desk.send(Type::Modifiers, desk.front(31.1, 62.4), Button::None, kControl);
    QCOMPARE(int(desk.marks().snap->kind), int(Snap::Kind::None));
    desk.send(Type::Modifiers, desk.front(31.1, 62.4));
    QVERIFY(desk.marks().snap->kind != Snap::Kind::None);
    const Camera before = desk.interaction.camera();
    desk.moveTo(desk.front(60, 60));
    desk.press(desk.cursor, Button::Left, kControl);
    desk.moveTo(desk.front(90, 90), kControl);
    desk.release(desk.cursor, Button::Left, kControl);
    QVERIFY(!isSameCamera(before, desk.interaction.camera()));
    QCOMPARE(desk.pointCount(), std::size_t(1));
}

void TestPen::slitsBeginACanvas()
{
    PenDesk desk;
    desk.addPlate();
    desk.run("section.pen");
    desk.moveTo(desk.front(20, kFirstPlaneHeight));
    QCOMPARE(desk.hint(), hints::kPenOnSection);
    turnToCanvas(desk);
    desk.release(desk.cursor);
    QVERIFY(desk.interaction.overlay().find<PenMarks>());
    const Frame canvas = desk.marks().canvas;
    // Seen straight, and its slit is there.
    QVERIFY((desk.interaction.camera().backward().cross(canvas.normal())).norm() < 1e-6);
    QVERIFY(desk.interaction.overlay().find<sign::Slit>());
    for (const Vec2 &corner : {Vec2(-20, -40), Vec2(100, -40), Vec2(100, 40), Vec2(-20, 40)})
        desk.click(desk.onCanvas(corner.x(), corner.y()));
    QVERIFY(desk.key(ToolKey::Enter));
    QCOMPARE(desk.sections().size(), std::size_t(2));
    const Section &parent = *desk.sections()[0], &section = *desk.sections()[1];
    QVERIFY(section.parent && section.parent->section == SectionRef(parent.id));
    QVERIFY(std::abs(section.frame.normal().dot(parent.frame.normal())) < 1e-9);
    for (const Vec2 &end : {section.parent->slitFrom, section.parent->slitTo})
        QVERIFY(std::abs(section.frame.height(parent.frame.toWorld(end))) < 1e-9);
    QVERIFY(std::abs(section.parent->slitTo.x() - 100.0) < 1e-9);
    // The way back is there.
    QVERIFY(desk.interaction.canGoBack());
}

/// A stroke would be over; the pen is not, and what is released is no point.
void TestPen::releasingInTheTurnGoesOn()
{
    PenDesk desk;
    desk.addPlate();
    desk.run("section.pen");
    const Vec2 from = desk.front(20, kFirstPlaneHeight), to = desk.front(110, kFirstPlaneHeight);
    desk.moveTo(from);
    desk.press(from);
    desk.moveTo(to);
    QVERIFY(desk.interaction.isAnimating());
    QCOMPARE(desk.hint(), hints::kTurning);
    const Vec3 end = desk.interaction.overlay().find<sign::Slit>()->to;
    desk.release(to);
    for (int i = 0; i < 8; ++i) { // 640 ms: the turn is not over
        desk.moveTo(to + Vec2(i, 2 * i));
        QVERIFY((desk.screen(end) - desk.cursor).norm() < 1.0);
    }
    desk.wait(kTurnTime);
    desk.wait(kTurnTime);
    QVERIFY(!desk.interaction.isAnimating());
    QCOMPARE(desk.pointCount(), std::size_t(0));
    desk.click(desk.onCanvas(50, 50));
    QCOMPARE(desk.pointCount(), std::size_t(1));
    QVERIFY(!desk.interaction.hint().isRefusal);
}

void TestPen::aClickOnASectionSelects()
{
    PenDesk desk;
    desk.addPlate();
    desk.run("section.pen");
    desk.click(desk.front(20, kFirstPlaneHeight));
    QCOMPARE(desk.interaction.selection().size(), std::size_t(1));
    QVERIFY(!desk.interaction.overlay().find<PenMarks>());
    // A slit that never leaves is said.
    desk.drag({desk.front(20, kFirstPlaneHeight), desk.front(50, kFirstPlaneHeight)});
    QCOMPARE(desk.hint(), hints::kNeverLeft);
    QVERIFY(desk.interaction.tool());
}

void TestPen::besideSectionsTheViewTurns()
{
    PenDesk desk;
    desk.addPlate();
    desk.run("section.pen");
    const Camera before = desk.interaction.camera();
    desk.drag({desk.front(150, 200), desk.front(180, 220)});
    QVERIFY(!isSameCamera(before, desk.interaction.camera()));
    QCOMPARE(desk.hint(), hints::kPenWithoutCanvas);
    QVERIFY(desk.interaction.tool());
}

/// The path belongs to the canvas, not to the screen.
void TestPen::theViewMovesUnderThePath()
{
    PenDesk desk;
    desk.run("section.pen");
    setRectangle(desk);
    const std::vector<PathPoint> before = desk.marks().points;
    desk.drag({desk.front(100, 160), desk.front(120, 150)}, Button::Right);
    QVERIFY(desk.marks().points == before);
    QVERIFY(desk.session.hasPreview());
    desk.wheel(desk.cursor, 3.0);
    desk.drag({desk.cursor, desk.cursor + Vec2(30, 10)}, Button::Middle);
    QVERIFY(desk.marks().points == before);
    // On a canvas that is seen on edge nothing is set.
    desk.run("view.right");
    desk.wait(1000.0);
    desk.moveTo(Vec2(640, 300));
    QCOMPARE(desk.hint(), hints::kCanvasOnEdge);
    desk.click({640, 300});
    QVERIFY(desk.marks().points == before);
    desk.run("view.front");
    desk.wait(1000.0);
    QVERIFY(desk.key(ToolKey::Enter));
    QVERIFY(std::abs(desk.sections().front()->shape->area() - 2400.0) < 1e-9);
}

void TestPen::nothingFollowsACursorThatIsElsewhere()
{
    PenDesk desk;
    desk.run("section.pen");
    desk.click(desk.front(0, 60));
    desk.moveTo(desk.front(50, 60));
    QVERIFY(desk.marks().next);
    desk.send(Type::Leave, desk.cursor);
    QVERIFY(!desk.marks().next && !desk.marks().snap);
    QCOMPARE(desk.pointCount(), std::size_t(1));
    desk.moveTo(desk.front(50, 80));
    QVERIFY(desk.marks().next);
}

void TestPen::backspaceTakesOneBack()
{
    PenDesk desk;
    desk.run("section.pen");
    QVERIFY(!desk.interaction.wants(ToolKey::Backspace));
    setRectangle(desk);
    for (std::size_t left = 4; left-- > 0;) {
        QVERIFY(desk.key(ToolKey::Backspace));
        QCOMPARE(desk.pointCount(), left);
        QCOMPARE(desk.session.hasPreview(), left > 2);
    }
    QVERIFY(!desk.key(ToolKey::Backspace));
}

void TestPen::escapeGoesBackStepByStep()
{
    PenDesk desk;
    desk.addPlate();
    desk.run("section.pen");
    const Camera before = desk.interaction.camera();
    turnToCanvas(desk);
    desk.release(desk.cursor);
    desk.click(desk.onCanvas(50, 50));
    desk.click(desk.onCanvas(80, 50));
    QVERIFY(desk.interaction.escape(desk.time));
    QVERIFY(desk.interaction.tool());
    QCOMPARE(desk.pointCount(), std::size_t(0));
    QVERIFY(desk.interaction.overlay().find<PenMarks>()); // the canvas is still there
    QVERIFY(desk.interaction.escape(desk.time));
    QVERIFY(!desk.interaction.tool());
    desk.wait(kTurnTime);
    QVERIFY(isSameCamera(before, desk.interaction.camera()));
    QVERIFY(!desk.interaction.overlay().find<PenMarks>() &&
            !desk.interaction.overlay().find<sign::Slit>());
    QCOMPARE(desk.steps(), 1);
    // In the turn: back to where the slit began, the pen in the hand.
    desk.run("section.pen");
    const Vec2 from = desk.front(20, kFirstPlaneHeight);
    desk.moveTo(from);
    desk.press(from);
    desk.moveTo(desk.front(110, kFirstPlaneHeight));
    desk.wait(300.0);
    QVERIFY(desk.interaction.escape(desk.time));
    desk.release(desk.cursor);
    desk.wait(kTurnTime);
    QVERIFY(isSameCamera(before, desk.interaction.camera()));
    QVERIFY(desk.interaction.tool());
}

void TestPen::undoGoesThroughThePathFirst()
{
    PenDesk desk;
    desk.addPlate();
    desk.run("section.planeFront");
    desk.run("section.pen"); // in place of the stroke
    desk.run("section.planeFront");
    desk.wait(1000.0);
    setRectangle(desk);
    desk.drag({desk.front(30, 100), desk.front(60, 130)});
    desk.run("edit.undo");
    QVERIFY((desk.point(2) - Vec3(30, 100, 0)).norm() < 1e-9);
    desk.run("edit.undo");
    QCOMPARE(desk.pointCount(), std::size_t(3));
    desk.run("edit.redo");
    desk.run("edit.redo");
    QVERIFY((desk.point(2) - Vec3(60, 130, 0)).norm() < 1e-9);
    for (int i = 0; i < 5; ++i)
        desk.run("edit.undo");
    QCOMPARE(desk.pointCount(), std::size_t(0));
    QCOMPARE(desk.sections().size(), std::size_t(1));
    desk.run("edit.undo"); // none is left: the document's own step
    QVERIFY(desk.sections().empty());
}

void TestPen::previewIsWhatIsCommitted()
{
    PenDesk desk;
    desk.run("section.pen");
    setRectangle(desk);
    desk.drag({desk.front(0, 130), desk.front(-40, 150)});
    desk.key(ToolKey::Backspace);
    const Document shown = desk.session.model().document;
    desk.key(ToolKey::Enter);
    QVERIFY(desk.session.committed().document.isSame(shown));
}

void TestPen::crossingPathsAreSaid()
{
    PenDesk desk;
    desk.run("section.pen");
    for (const Vec2 &corner : {Vec2(-40, 60), Vec2(40, 60), Vec2(-40, 120), Vec2(0, 120)})
        desk.click(desk.front(corner.x(), corner.y()));
    desk.moveTo(desk.front(60, 150));
    QCOMPARE(desk.hint(), hints::kPenCrosses);
    desk.key(ToolKey::Enter);
    QCOMPARE(desk.hint(), hints::kCrossesItself);
    QCOMPARE(desk.sections().size(), std::size_t(1));
    QVERIFY(desk.sections().front()->shape->area() < 0.5 * 80 * 60);
}

void TestPen::numbersSetPoints()
{
    PenDesk desk;
    desk.run("section.pen");
    desk.run("section.penPoint", {{"x", "-20"}, {"y", "12.5"}});
    desk.run("section.penPoint", {{"dx", "43.21"}, {"dy", "0"}});
    desk.run("section.penPoint", {{"length", "30"}, {"angle", "90"}});
    QCOMPARE(desk.pointCount(), std::size_t(3));
    QVERIFY((desk.point(0) - Vec3(-20, 12.5, 0)).norm() < 1e-9);
    QVERIFY((desk.point(1) - Vec3(23.21, 12.5, 0)).norm() < 1e-9);
    QVERIFY((desk.point(2) - Vec3(23.21, 42.5, 0)).norm() < 1e-9);
    // What is typed is shown before it is set.
    desk.interaction.setNumbers({{ToolNumber::Kind::X, 7.0}, {ToolNumber::Kind::Y, 50.0}},
                                desk.time);
    QCOMPARE(desk.hint(), hints::kPenNumbers);
    QVERIFY((desk.marks().canvas.toWorld(*desk.marks().next) - Vec3(7, 50, 0)).norm() < 1e-9);
    desk.interaction.dropNumbers(desk.time);
    QCOMPARE(desk.pointCount(), std::size_t(3));
    const Result<void> wrong = desk.commands.run("section.penPoint", {{"x", "wide"}}, desk.time);
    QVERIFY(!wrong && wrong.error().code == ErrorCode::BadValue);
    QVERIFY(!desk.commands.run("section.penPoint", {}, desk.time));
    // Back to the start: closed.
    desk.run("section.penPoint", {{"x", "-20"}, {"y", "12.5"}});
    QCOMPARE(desk.sections().size(), std::size_t(1));
    QVERIFY(!desk.commands.isEnabled("section.penPoint"));
}

void TestPen::canvasesAreShared_data()
{
    QTest::addColumn<QString>("command");
    QTest::addColumn<int>("sections");
    QTest::newRow("a hole") << "section.addHole" << 1;
    QTest::newRow("another contour") << "section.redraw" << 1;
    QTest::newRow("the front plane") << "section.planeFront" << 2;
    QTest::newRow("a parallel plane") << "section.planeParallel" << 2;
}

/// What was picked is drawn on with the pen, not with one stroke.
void TestPen::canvasesAreShared()
{
    QFETCH(QString, command);
    PenDesk desk;
    desk.addPlate();
    desk.run("edit.selectAll");
    desk.run("section.pen");
    desk.run(command.toStdString());
    desk.wait(1000.0);
    QCOMPARE(desk.interaction.tool()->command(), PenTool::kCommand);
    const Vec2 middle = desk.screen({0, kFirstPlaneHeight, 0});
    for (const Vec2 &corner : {Vec2(-60, -40), Vec2(60, -40), Vec2(0, 50)})
        desk.click(middle + corner);
    QCOMPARE(desk.pointCount(), std::size_t(3));
    QVERIFY(desk.key(ToolKey::Enter));
    QTEST(int(desk.sections().size()), "sections");
    QCOMPARE(desk.steps(), 2);
    const Shape &shape = *desk.sections().front()->shape;
    QCOMPARE(shape.holes().size(), std::size_t(command == QLatin1String("section.addHole")));
    if (command == QLatin1String("section.redraw"))
        QCOMPARE(shape.contour().segmentCount(), 3);
    QCOMPARE(desk.interaction.tool()->command(), PenTool::kCommand);
}

/// Ten points must not be lost to a wrong key.
void TestPen::anotherCanvasWaitsForThePath()
{
    PenDesk desk;
    desk.run("section.pen");
    setRectangle(desk);
    desk.run("section.planeGround");
    QCOMPARE(desk.hint(), hints::kPathIsOpen);
    QCOMPARE(desk.pointCount(), std::size_t(4));
    QVERIFY(desk.session.hasPreview());
}

void TestPen::aParallelPlaneMoves()
{
    PenDesk desk;
    desk.addPlate();
    desk.run("edit.selectAll");
    for (const bool withPen : {false, true}) {
        if (withPen)
            desk.run("section.pen");
        desk.run("section.planeParallel", {{"distance", "12"}});
        desk.wait(1000.0);
        QCOMPARE(int(desk.interaction.numbers().front().kind), int(ToolNumber::Kind::Distance));
        QCOMPARE(desk.interaction.numbers().front().value, 12.0);
        QVERIFY(desk.interaction.overlay().find<sign::Region>());
        desk.interaction.setNumbers({{ToolNumber::Kind::Distance, 37.5}}, desk.time);
        QCOMPARE(desk.interaction.numbers().front().value, 37.5);
        const Vec3 normal = desk.sections().front()->frame.normal();
        const Vec3 corner = desk.interaction.overlay().find<sign::Region>()->outline.front();
        QVERIFY(std::abs(normal.dot(corner - desk.sections().front()->frame.origin) - 37.5) < 1e-9);
        desk.interaction.layDown(desk.time);
        desk.wait(1000.0);
    }
}

void TestPen::editsElsewhereKeepThePath()
{
    PenDesk desk;
    desk.run("section.pen");
    setRectangle(desk);
    desk.addPlate(); // somebody else's doing
    QCOMPARE(desk.pointCount(), std::size_t(4));
    QVERIFY(desk.interaction.tool());
    QVERIFY(desk.key(ToolKey::Enter));
    QCOMPARE(desk.sections().size(), std::size_t(2));
    QVERIFY(desk.sections()[0]->id != desk.sections()[1]->id);
    QCOMPARE(desk.sections()[1]->name, std::string("Section 2"));
}

void TestPen::aLostCanvasIsSaid()
{
    PenDesk desk;
    desk.addPlate();
    desk.run("section.pen");
    turnToCanvas(desk);
    desk.release(desk.cursor);
    desk.click(desk.onCanvas(50, 50));
    desk.session.history()->undo(); // the plate that the slit is in
    QVERIFY(desk.sections().empty());
    QCOMPARE(desk.hint(), hints::kCanvasGone);
    QCOMPARE(desk.pointCount(), std::size_t(0));
    QVERIFY(desk.interaction.tool());
}

void TestPen::strokesAreAsEverWithoutThePen()
{
    PenDesk desk;
    desk.run("section.pen");
    desk.run("section.pen");
    QVERIFY(!desk.interaction.tool());
    desk.drag({desk.front(-40, 60), desk.front(40, 60), desk.front(40, 120), desk.front(-40, 120)});
    QCOMPARE(desk.sections().size(), std::size_t(1));
}

FFF_TEST(TestPen)
#include "tst_pen.moc"
