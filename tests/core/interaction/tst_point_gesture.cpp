#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/interaction/hover_words.h"
#include "core/interaction/point_words.h"
#include "core/model/edit_words.h"
#include "tests/core/interaction/desk.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;
using Type = PointerEvent::Type;

namespace {

/// A person with a mouse at a plate of 200 × 120 mm with a hole, seen from the front and selected,
/// that stands 20 mm above the ground. Places are those of its frame, from its lower left.
class PlateDesk : public Desk
{
public:
    PlateDesk()
    {
        Frame frame = test::front();
        frame.origin = Vec3(-100, 20, 0);
        session.reset(withSection(
            newDocument(), polygonShape(rectangle(0, 0, 200, 120), {rectangle(90, 50, 110, 70)}),
            frame));
        Camera camera;
        camera.target = {0, 80, 0};
        camera.millimetresPerPixel = 0.5;
        interaction.setCamera(camera);
        interaction.select({session.committed().ref(0)});
    }

    void drag(const Vec2 &from, const Vec2 &to, Modifiers modifiers = {})
    {
        Desk::drag({at(from), at(to)}, Button::Left, modifiers);
    }
    void click(const Vec2 &place, Modifiers modifiers = {}) { Desk::click(at(place), modifiers); }
    void doubleClick(const Vec2 &place) { Desk::doubleClick(at(place)); }

    /// On the screen.
    Vec2 at(const Vec2 &place) const { return screen(section().frame.toWorld(place)); }
    const Section &section() const { return *sections().front(); }
    const Shape &shape() const { return *section().shape; }
    Vec2 corner(int index) const { return position(shape(), {0, index}); }
    const std::vector<PointAddress> &selected() const { return interaction.points().points(); }
};

} // namespace

class TestPointGesture : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hoverSaysWhatADragWouldDo();
    void aPointIsDraggedInOneStep();
    void selectedPointsMoveTogether();
    void controlLeavesTheHandles();
    void shiftKeepsToAnAxis();
    void handlesOfSelectedPointsAreDragged();
    void theContourBends();
    void theLastWholePlaceIsKept();
    void pointsBelowTheGroundAreCutOff();
    void escapeGoesBackOneStepAtATime();
    void clicksSelectPoints();
    void aBandSelectsPoints();
    void aDoubleClickAddsAPoint();
    void deleteTakesPointsBeforeSections();
    void arrowKeysMerge();
    void arrowsFollowTheScreen();
    void kindsByCommand();
    void holesGoByCommand();
    void undoKeepsThePointsSelected();
    void pointsAreHiddenOnEdge();
    void partnersFollowTheDrag();
};

// Wrong: one finds out by trying.
void TestPointGesture::hoverSaysWhatADragWouldDo()
{
    PlateDesk desk;
    desk.send(Type::Move, desk.at({0, 0}));
    QCOMPARE(desk.interaction.hint().words.text, hints::kMovePoint);
    QCOMPARE(desk.interaction.cursor(), Cursor::MoveCross);
    QVERIFY(desk.interaction.overlay().find<sign::Points>()->hovered.has_value());
    QCOMPARE(desk.interaction.hovered().section, -1);
    desk.send(Type::Move, desk.at({60, 0}));
    QCOMPARE(desk.interaction.hint().words.text, hints::kAddPoint);
    QCOMPARE(desk.interaction.cursor(), Cursor::ArrowWithPlus);
    desk.send(Type::Move, desk.at({90, 60}));
    QCOMPARE(desk.interaction.hint().words.text, hints::kAddPoint); // of the hole
    desk.send(Type::Move, desk.at({40, 60}));
    QCOMPARE(desk.interaction.hint().words.text, hints::kDragOutOfSection);
    QVERIFY(!desk.interaction.overlay().find<sign::Points>()->hovered);
    desk.interaction.select({});
    QVERIFY(!desk.interaction.overlay().find<sign::Points>());
}

void TestPointGesture::aPointIsDraggedInOneStep()
{
    PlateDesk desk;
    desk.send(Type::Press, desk.at({200, 120}), Button::Left);
    desk.moveTo(desk.at({230, 130}));
    QVERIFY(desk.session.hasPreview());
    QCOMPARE(desk.steps(), 0);
    QVERIFY((position(*desk.session.model().section(0)->shape, {0, 2}) - Vec2(230, 130)).norm() <
            1e-9);
    desk.send(Type::Release, desk.at({230, 130}), Button::Left);
    QCOMPARE(desk.steps(), 1);
    QCOMPARE(desk.lastStep(),
             QStringLiteral("Move point of %1").arg(QString::fromStdString(desk.section().name)));
    QVERIFY((desk.corner(2) - Vec2(230, 130)).norm() < 1e-9);
    QVERIFY(isLine(desk.shape().contour().segment(1)));
    QCOMPARE(desk.selected(), (std::vector<PointAddress>{{0, 2}}));
    desk.session.history()->undo();
    QVERIFY(desk.corner(2) == Vec2(200, 120));
}

void TestPointGesture::selectedPointsMoveTogether()
{
    PlateDesk desk;
    desk.click({200, 0});
    desk.click({200, 120}, kControl);
    desk.drag({200, 0}, {220, 5});
    QVERIFY((desk.corner(1) - Vec2(220, 5)).norm() < 1e-9);
    QVERIFY((desk.corner(2) - Vec2(220, 125)).norm() < 1e-9);
    QCOMPARE(
        desk.lastStep(),
        QStringLiteral("Move 2 points of %1").arg(QString::fromStdString(desk.section().name)));
    // One that is not selected goes alone.
    desk.drag({0, 0}, {-10, 0});
    QVERIFY((desk.corner(1) - Vec2(220, 5)).norm() < 1e-9);
    QCOMPARE(desk.selected(), (std::vector<PointAddress>{{0, 0}}));
}

void TestPointGesture::controlLeavesTheHandles()
{
    PlateDesk desk;
    desk.click({200, 120});
    desk.run("point.symmetric");
    const Vec2 out = handle(desk.shape().contour(), 2, HandleSide::Out);
    desk.drag({200, 120}, {215, 135}, kControl);
    QVERIFY(handle(desk.shape().contour(), 2, HandleSide::Out) == out);
    QCOMPARE(kindOf(desk.shape().contour(), 2), PointKind::Corner);
    QVERIFY((desk.corner(2) - Vec2(215, 135)).norm() < 1e-9);
}

void TestPointGesture::shiftKeepsToAnAxis()
{
    PlateDesk desk;
    // Pressed without Shift, or it would be a band beside the section.
    desk.send(Type::Press, desk.at({200, 120}), Button::Left);
    desk.moveTo(desk.at({230, 128}), kShift);
    desk.send(Type::Release, desk.at({230, 128}), Button::Left, kShift);
    QVERIFY((desk.corner(2) - Vec2(230, 120)).norm() < 1e-9);
}

void TestPointGesture::handlesOfSelectedPointsAreDragged()
{
    PlateDesk desk;
    desk.click({200, 120});
    desk.run("point.symmetric");
    const Vec2 out = handle(desk.shape().contour(), 2, HandleSide::Out);
    desk.send(Type::Move, desk.at(out));
    QCOMPARE(desk.interaction.hint().words.text, hints::kMoveHandle);
    desk.drag(out, out + Vec2(-5, 12));
    const Contour &contour = desk.shape().contour();
    QVERIFY((handle(contour, 2, HandleSide::Out) - out - Vec2(-5, 12)).norm() < 1e-9);
    QCOMPARE(kindOf(contour, 2), PointKind::Symmetric);
    desk.drag(out + Vec2(-5, 12), out, kControl);
    QCOMPARE(kindOf(desk.shape().contour(), 2), PointKind::Corner);
    QVERIFY(desk.lastStep().startsWith(QStringLiteral("Move handle")));
}

void TestPointGesture::theContourBends()
{
    PlateDesk desk;
    desk.drag({100, 120}, {100, 140});
    QVERIFY((desk.shape().contour().segment(2).at(0.5) - Vec2(100, 140)).norm() < 0.5);
    QVERIFY(desk.corner(2) == Vec2(200, 120) && desk.corner(3) == Vec2(0, 120));
    QVERIFY(desk.lastStep().startsWith(QStringLiteral("Bend contour")));
}

// Wrong: a contour that crosses itself is shown, committed, or mended behind one's back.
void TestPointGesture::theLastWholePlaceIsKept()
{
    PlateDesk desk;
    desk.send(Type::Press, desk.at({0, 0}), Button::Left);
    desk.moveTo(desk.at({150, 80}), {}, 60); // over the hole
    QCOMPARE(desk.interaction.hint().words.text, hints::kWouldMeetHole);
    desk.moveTo(desk.at({260, 60}), {}, 60); // and out of the plate
    QCOMPARE(desk.interaction.hint().words.text, hints::kWouldCrossItself);
    QVERIFY(desk.interaction.hint().isRefusal);
    const Vec2 shown = position(*desk.session.model().section(0)->shape, {0, 0});
    QVERIFY(shown.x() > 20.0 && shown.x() < 120.0);
    QVERIFY(desk.session.model().section(0)->shape->isPlain());
    desk.send(Type::Release, desk.at({260, 60}), Button::Left);
    QVERIFY(desk.corner(0) == shown);
    QCOMPARE(desk.interaction.hint().words.text, hints::kWouldCrossItself);
    QCOMPARE(desk.steps(), 1);
}

// Wrong: feet that are pulled into the ground are no longer flat and co-planar.
void TestPointGesture::pointsBelowTheGroundAreCutOff()
{
    PlateDesk desk;
    desk.drag({0, 0}, {0, -60});
    for (const Vec2 &p : desk.shape().region().outer)
        QVERIFY(desk.section().frame.toWorld(p).y() >= -1e-9);
    QCOMPARE(desk.interaction.hint().words.text, hints::kCutAtGround);
    QVERIFY(desk.selected().empty()); // it is gone
    desk.session.history()->undo();
    desk.interaction.settings().cutsAtGround = false;
    desk.drag({0, 0}, {0, -60});
    QVERIFY((desk.corner(0) - Vec2(0, -60)).norm() < 1e-9);
}

void TestPointGesture::escapeGoesBackOneStepAtATime()
{
    PlateDesk desk;
    desk.click({200, 120});
    desk.send(Type::Press, desk.at({0, 0}), Button::Left);
    desk.moveTo(desk.at({20, 20}));
    QVERIFY(desk.interaction.escape(desk.time += 8));
    QVERIFY(!desk.session.hasPreview());
    QCOMPARE(desk.steps(), 0);
    QCOMPARE(desk.selected(), (std::vector<PointAddress>{{0, 2}})); // as before the drag
    desk.send(Type::Release, desk.at({20, 20}), Button::Left);
    QVERIFY(desk.interaction.escape(desk.time += 8));
    QVERIFY(desk.selected().empty());
    QCOMPARE(desk.interaction.selection().size(), std::size_t(1));
    QVERIFY(desk.interaction.escape(desk.time += 8));
    QVERIFY(desk.interaction.selection().empty());
}

void TestPointGesture::clicksSelectPoints()
{
    PlateDesk desk;
    desk.click({0, 0});
    QCOMPARE(desk.selected(), (std::vector<PointAddress>{{0, 0}}));
    desk.click({110, 70}, kControl); // of the hole
    QCOMPARE(desk.selected().size(), std::size_t(2));
    desk.click({0, 0}, kControl);
    QCOMPARE(desk.selected().size(), std::size_t(1));
    desk.click({0, 120});
    QCOMPARE(desk.selected(), (std::vector<PointAddress>{{0, 3}}));
    desk.click({60, 0}); // the line: nothing
    QCOMPARE(desk.selected().size(), std::size_t(1));
    desk.click({40, 60}); // the section
    QVERIFY(desk.selected().empty());
    QCOMPARE(desk.interaction.selection().size(), std::size_t(1));
    desk.click({300, 60});
    QVERIFY(desk.interaction.selection().empty());
    QCOMPARE(desk.steps(), 0);
}

void TestPointGesture::aBandSelectsPoints()
{
    PlateDesk desk;
    desk.drag({150, -20}, {230, 140}, kShift);
    QCOMPARE(desk.selected(), (std::vector<PointAddress>{{0, 1}, {0, 2}}));
    QVERIFY(!desk.interaction.overlay().find<sign::Band>());
    QCOMPARE(desk.interaction.selection().size(), std::size_t(1));
}

void TestPointGesture::aDoubleClickAddsAPoint()
{
    PlateDesk desk;
    const double area = desk.shape().area();
    desk.doubleClick({60, 0});
    QCOMPARE(desk.shape().contour().segmentCount(), 5);
    QVERIFY((desk.corner(1) - Vec2(60, 0)).norm() < 1e-6);
    QCOMPARE(desk.selected(), (std::vector<PointAddress>{{0, 1}}));
    QVERIFY(std::abs(desk.shape().area() - area) < 1e-9 * area);
    QVERIFY(desk.lastStep().startsWith(QStringLiteral("Add point")));
    desk.click({300, 60});
    QCOMPARE(desk.steps(), 1);
}

void TestPointGesture::deleteTakesPointsBeforeSections()
{
    PlateDesk desk;
    desk.click({200, 120});
    desk.run("edit.delete"); // the hole would be cut in two
    QCOMPARE(desk.interaction.hint().words.text, hints::kWouldMeetHole);
    desk.run("section.removeHoles");
    desk.click({200, 120});
    desk.run("edit.delete");
    QCOMPARE(desk.shape().contour().segmentCount(), 3);
    QVERIFY(desk.lastStep().startsWith(QStringLiteral("Delete point")));
    desk.click({0, 0});
    desk.click({200, 0}, kControl);
    desk.run("point.delete"); // one corner and nothing between: refused, and said
    QCOMPARE(desk.shape().contour().segmentCount(), 3);
    QCOMPARE(desk.interaction.hint().words.text, hints::kTooFewPoints);
    desk.interaction.selectPoints({});
    desk.run("edit.delete");
    QVERIFY(desk.session.committed().document.sections.empty());
}

// Wrong: twenty presses of an arrow key take twenty undos.
void TestPointGesture::arrowKeysMerge()
{
    PlateDesk desk;
    desk.click({200, 120});
    for (int i = 0; i < 5; ++i)
        desk.run("nudge.right");
    desk.run("nudge.up", {{"distance", "0.1"}});
    QVERIFY((desk.corner(2) - Vec2(205, 120.1)).norm() < 1e-9);
    QCOMPARE(desk.steps(), 1);
    desk.click({0, 120});
    desk.run("nudge.left");
    QCOMPARE(desk.steps(), 2);
    desk.session.history()->undo();
    desk.session.history()->undo();
    QVERIFY(desk.corner(2) == Vec2(200, 120));
    // Without points the section itself goes.
    desk.interaction.selectPoints({});
    desk.run("nudge.up", {{"distance", "10"}});
    desk.run("nudge.up", {{"distance", "10"}});
    QVERIFY((desk.section().frame.origin - Vec3(-100, 40, 0)).norm() < 1e-9);
    QCOMPARE(desk.steps(), 1);
}

// Wrong: seen from behind, the right arrow moves to the left.
void TestPointGesture::arrowsFollowTheScreen()
{
    PlateDesk desk;
    desk.click({200, 120});
    Camera camera = desk.interaction.camera();
    orientationOfView("back", camera.orientation);
    desk.interaction.setCamera(camera);
    desk.run("nudge.right");
    QVERIFY((desk.corner(2) - Vec2(199, 120)).norm() < 1e-9);
    orientationOfView("iso1", camera.orientation);
    desk.interaction.setCamera(camera);
    desk.run("nudge.up");
    QVERIFY((desk.corner(2) - Vec2(199, 121)).norm() < 1e-9);
}

void TestPointGesture::kindsByCommand()
{
    PlateDesk desk;
    desk.click({200, 120});
    desk.click({110, 70}, kControl);
    const auto kinds = [&] {
        return std::pair(kindOf(desk.shape().contour(), 2),
                         kindOf(boundary(desk.shape(), 1), desk.selected().back().index));
    };
    desk.run("point.smooth");
    QCOMPARE(kinds(), std::pair(PointKind::Smooth, PointKind::Smooth));
    desk.run("point.symmetric");
    QCOMPARE(kinds(), std::pair(PointKind::Symmetric, PointKind::Symmetric));
    desk.run("point.corner");
    QCOMPARE(kinds(), std::pair(PointKind::Corner, PointKind::Corner));
    QCOMPARE(desk.steps(), 3);
    desk.run("point.corner"); // as it is: no step
    QCOMPARE(desk.steps(), 3);
}

void TestPointGesture::holesGoByCommand()
{
    PlateDesk desk;
    desk.run("section.removeHoles");
    QVERIFY(desk.shape().holes().empty());
    QVERIFY(!desk.commands.isEnabled("section.removeHoles"));
    QVERIFY(desk.lastStep().startsWith(QStringLiteral("Remove holes")));
}

void TestPointGesture::undoKeepsThePointsSelected()
{
    PlateDesk desk;
    desk.drag({200, 120}, {210, 120});
    desk.session.history()->undo();
    QCOMPARE(desk.selected(), (std::vector<PointAddress>{{0, 2}}));
    // Another number of points: those at the same places.
    desk.doubleClick({60, 0});
    desk.click({200, 120});
    QCOMPARE(desk.selected(), (std::vector<PointAddress>{{0, 3}}));
    desk.session.history()->undo();
    QCOMPARE(desk.selected(), (std::vector<PointAddress>{{0, 2}}));
}

void TestPointGesture::pointsAreHiddenOnEdge()
{
    PlateDesk desk;
    Camera camera = desk.interaction.camera();
    orientationOfView("right", camera.orientation);
    desk.interaction.setCamera(camera);
    QVERIFY(!desk.interaction.overlay().find<sign::Points>());
    orientationOfView("iso1", camera.orientation);
    desk.interaction.setCamera(camera);
    QVERIFY(desk.interaction.overlay().find<sign::Points>());
}

// Wrong: slits lag behind the contour that they belong to.
void TestPointGesture::partnersFollowTheDrag()
{
    PlateDesk desk;
    Frame across = side();
    across.origin = Vec3(-50, 20, 50);
    desk.session.commit(QStringLiteral("Draw"),
                        withSection(desk.session.committed().document,
                                    polygonShape(rectangle(0, 0, 100, 120)), across));
    desk.interaction.select({desk.session.committed().ref(0)});
    const double before = desk.session.currentAnalysis().assembly.slits[1].front().inner.y();
    desk.send(Type::Press, desk.at({60, 120}), Button::Left); // the upper edge
    desk.moveTo(desk.at({60, 105}));
    const double during = desk.session.currentAnalysis().assembly.slits[1].front().inner.y();
    QVERIFY(std::abs(during - before) > 2.0);
    QCOMPARE(desk.session.history()->count(), 1);
}

FFF_TEST(TestPointGesture)
#include "tst_point_gesture.moc"
