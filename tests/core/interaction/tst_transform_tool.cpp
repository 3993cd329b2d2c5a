#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/interaction/section_editing.h"
#include "core/interaction/section_words.h"
#include "core/interaction/tool.h"
#include "core/interaction/transform_words.h"
#include "core/interaction/view_fit.h"
#include "core/model/edit_words.h"
#include "core/model/moving.h"
#include "core/model/origin.h"
#include "tests/core/interaction/desk.h"
#include "tests/test_program.h"

#include <QUndoStack>

using namespace fff;
using namespace fff::test;

namespace {

constexpr double kNear = 1e-6; // mm

/// A plate that faces the eye, and one across it, seen from the front and a little from the side.
struct CrossDesk : Desk
{
    SectionId body, fin;

    CrossDesk()
    {
        Document document = newDocument();
        document = withSection(document, polygonShape(rectangle(-100, -60, 100, 60)),
                               {{0, 100, 0}, Vec3::UnitX(), Vec3::UnitY()});
        body = document.sections.back()->id;
        NewSection next{"Fin",
                        Parent{body, {40, 20}, {40, 60}},
                        polygonShape(rectangle(-30, -40, 30, 40)),
                        {{40, 150, 0}, Vec3::UnitZ(), Vec3::UnitY()},
                        {}};
        document = addSection(document, next).value();
        fin = document.sections.back()->id;
        session.reset(document);
        Camera camera;
        camera.orientation = Eigen::Quaterniond(Eigen::AngleAxisd(0.6, Vec3::UnitY())) *
                             Eigen::Quaterniond(Eigen::AngleAxisd(-0.3, Vec3::UnitX()));
        interaction.setCamera(fitted(camera, session.committed().bounds(), kViewport));
        interaction.settings().snaps = false;
    }
    const Section &section(SectionId id) const { return *session.committed().document.find(id); }
    const Section &shown(SectionId id) const { return *session.model().document.find(id); }
    void hold(SectionId id)
    {
        interaction.select({id});
        run("section.transform");
        wait(10.0);
    }
    const Gizmo &gizmo() const { return interaction.overlay().find<GizmoMarks>()->gizmo; }
    GizmoLook look() const { return {gizmo(), interaction.camera(), kViewport}; }
    Vec2 tip(int axis) const { return look().tip(axis); }
    /// Where a ring is held: a place on it that nothing else has.
    Vec2 onRing(int axis) const
    {
        const GizmoPart parts[] = {GizmoPart::TurnX, GizmoPart::TurnY, GizmoPart::TurnZ};
        for (const Vec2 &place : look().ring(axis))
            if (look().partAt(place, 10.0) == parts[axis])
                return place;
        return Vec2(-1, -1);
    }
    /// The place on the screen that is `way` further, from where a part is held.
    Vec2 further(const Vec2 &held, const Vec3 &way) const
    {
        const Vec3 origin = gizmo().frame.origin;
        return held + screen(origin + way) - screen(origin);
    }
    CommandParameters with(std::initializer_list<std::pair<const std::string, std::string>> list)
    {
        return CommandParameters(list);
    }
};

} // namespace

class TestTransformTool : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void anArrowMoves();
    void aRingTurns();
    void whatIsHeldHasNoRingThatTilts();
    void aBoxScales();
    void severalInSpace();
    void aSectionIsDraggedByItself();
    void clicksSelect();
    void escTakesADragBack();
    void controlLeavesACopy();
    void numbersAreShownAndDone();
    void typedCopiesGoOnAndOn();
    void pointsAreDrawnToOthers();
    void notToWhatGoesAlong();
    void typedNumbersAreShownOnce();
    void placedInOneStep();
    void anglesAreRound();
    void lockedIsRefused();
    void madeOnesSayTheirSource();
    void arrowKeysTakeWhatIsOnIt();
    void undoBringsTheObjectsBack();
    void byCommands();
    void putOnAnother();
    void alignedFreedAndHeld();
};

// Wrong: the arrow would not go along with the cursor, or the view would turn.
void TestTransformTool::anArrowMoves()
{
    CrossDesk desk;
    desk.hold(desk.body);
    QCOMPARE(desk.hint(), hints::kTransform);
    const Vec3 before = desk.section(desk.body).frame.origin;
    const Vec3 fin = desk.section(desk.fin).frame.origin;
    const Vec3 axis = desk.gizmo().axis(0);
    const Camera camera = desk.interaction.camera();
    const Vec2 from = desk.tip(0);
    desk.moveTo(from);
    QCOMPARE(desk.hint(), hints::kDragToMove);
    desk.drag({from, desk.further(from, 25.0 * axis)});
    QVERIFY(isSameCamera(desk.interaction.camera(), camera));
    QCOMPARE(desk.steps(), 1);
    QCOMPARE(desk.lastStep(), QStringLiteral("Move Section 1"));
    const Vec3 way = desk.section(desk.body).frame.origin - before;
    QVERIFY((way - 25.0 * axis).norm() < 0.5);
    QVERIFY(way.cross(axis).norm() < kNear); // along it and nowhere else
    QVERIFY((desk.section(desk.fin).frame.origin - fin - way).norm() < kNear);
    QVERIFY(desk.interaction.tool()); // it stays in the hand
}

// Wrong: it would turn about another axis, or jump at the first move.
void TestTransformTool::aRingTurns()
{
    CrossDesk desk;
    desk.hold(desk.body);
    const Vec3 middle = desk.gizmo().frame.origin, axis = desk.gizmo().axis(1);
    const Vec2 from = desk.onRing(1);
    const Vec3 x = desk.section(desk.body).frame.x;
    desk.moveTo(from);
    QCOMPARE(desk.hint(), hints::kDragToTurn);
    desk.press(from);
    desk.moveTo(from + Vec2(5, 0));
    QVERIFY(desk.interaction.overlay().find<GizmoMarks>()->value);
    QVERIFY(std::abs(desk.interaction.overlay().find<GizmoMarks>()->value->number) < 0.3);
    desk.moveTo(from + Vec2(60, 10));
    desk.release(from + Vec2(60, 10));
    QCOMPARE(desk.lastStep(), QStringLiteral("Turn Section 1"));
    const Frame &frame = desk.section(desk.body).frame;
    QVERIFY(frame.x.cross(x).normalized().cross(axis).norm() < 1e-9);
    QVERIFY((positionOf(desk.section(desk.body)) - middle).norm() < kNear);
    QVERIFY(std::abs(frame.normal().dot(desk.section(desk.fin).frame.normal())) < 1e-9);
}

// Wrong: dragging a ring would do nothing, since the section keeps its angle.
void TestTransformTool::whatIsHeldHasNoRingThatTilts()
{
    CrossDesk desk;
    desk.hold(desk.fin);
    // It stands on the slit, an axis across the body, about which alone it turns.
    QVERIFY((desk.gizmo().frame.origin - Vec3(40, 140, 0)).norm() < kNear);
    const int across = desk.gizmo().axis(0).cross(Vec3::UnitZ()).norm() < 1e-9 ? 0 : 1;
    QVERIFY(desk.gizmo().axis(across).cross(Vec3::UnitZ()).norm() < 1e-9);
    QCOMPARE(desk.gizmo().has(GizmoPart::TurnX), across == 0);
    QCOMPARE(desk.gizmo().has(GizmoPart::TurnY), across == 1);
    QVERIFY(desk.gizmo().has(GizmoPart::TurnZ));
    // Its arrows are named by where they point.
    QVERIFY(desk.gizmo().axis(1).y() > std::abs(desk.gizmo().axis(0).y()));
    const Vec2 from = desk.onRing(across);
    desk.drag({from, from + Vec2(40, 20)});
    const Frame &frame = desk.section(desk.fin).frame;
    QVERIFY(std::abs(frame.normal().z()) < 1e-9);
    QVERIFY(std::abs(frame.normal().y()) > 0.05); // and it has turned
    QVERIFY(std::abs(frame.height({40, 140, 0})) < kNear);
    desk.run("section.free");
    desk.wait(10.0);
    QVERIFY(desk.gizmo().has(GizmoPart::TurnX) && desk.gizmo().has(GizmoPart::TurnY));
}

// Wrong: a wider body would leave its fin behind, or stretch it.
void TestTransformTool::aBoxScales()
{
    CrossDesk desk;
    desk.hold(desk.body);
    const Vec2 centre = desk.look().centre(), from = desk.look().box(GizmoPart::ScaleX);
    desk.moveTo(from);
    QCOMPARE(desk.hint(), hints::kDragToScale);
    desk.drag({from, centre + 1.5 * (from - centre)});
    const Vec2 size = desk.section(desk.body).shape->bounds().size();
    QVERIFY(std::abs(size.x() - 300.0) < 5.0);
    QVERIFY(std::abs(size.y() - 120.0) < kNear);
    const double factor = size.x() / 200.0;
    QVERIFY(std::abs(desk.section(desk.fin).frame.origin.x() - factor * 40.0) < kNear);
    QCOMPARE(desk.section(desk.fin).shape->bounds().size(), Vec2(60, 80));
    QCOMPARE(desk.lastStep(), QStringLiteral("Scale Section 1"));
}

// Wrong: each of several would turn about itself.
void TestTransformTool::severalInSpace()
{
    CrossDesk desk;
    desk.interaction.select({desk.body, desk.fin});
    desk.run("section.transform");
    desk.wait(10.0);
    QVERIFY(desk.gizmo().isInSpace);
    const Vec3 between = desk.section(desk.fin).frame.origin - desk.section(desk.body).frame.origin;
    const Vec2 from = desk.onRing(0);
    desk.drag({from, from + Vec2(30, 40)});
    QCOMPARE(desk.lastStep(), QStringLiteral("Turn 2 sections"));
    const Vec3 after = desk.section(desk.fin).frame.origin - desk.section(desk.body).frame.origin;
    QVERIFY(std::abs(after.norm() - between.norm()) < kNear);
    QVERIFY((after - between).norm() > 1.0);
    const Vec2 box = desk.look().box(GizmoPart::ScaleAll), centre = desk.look().centre();
    desk.drag({box, centre + 2.0 * (box - centre)});
    QVERIFY(std::abs(desk.section(desk.fin).shape->bounds().size().x() - 120.0) < 3.0);
}

// Wrong: a drag on a section would draw a stroke while the handles are out.
void TestTransformTool::aSectionIsDraggedByItself()
{
    CrossDesk desk;
    desk.hold(desk.fin);
    const Vec2 from = desk.screen({-80, 60, 0});
    desk.moveTo(from);
    QCOMPARE(desk.hint(), hints::kTransformDrag);
    desk.drag({from, from + Vec2(30, 0)});
    QCOMPARE(desk.sections().size(), std::size_t(2));
    QCOMPARE(desk.interaction.selection(), std::vector<SectionRef>{desk.body});
    const Vec3 at = desk.section(desk.body).frame.origin;
    QVERIFY(at.x() > 5.0);
    QVERIFY(std::abs(at.z()) < kNear); // in its plane
    // Shift keeps it to one direction.
    const Vec2 again = desk.screen({-60, 60, 0});
    const double y = at.y();
    desk.drag({again, again + Vec2(30, 6)}, Button::Left, kShift);
    QVERIFY(std::abs(desk.section(desk.body).frame.origin.y() - y) < kNear);
}

// Wrong: another section could not be chosen, or nothing at all.
void TestTransformTool::clicksSelect()
{
    CrossDesk desk;
    desk.hold(desk.fin);
    desk.click(desk.screen({-80, 60, 0}));
    QCOMPARE(desk.interaction.selection(), std::vector<SectionRef>{desk.body});
    QVERIFY(desk.interaction.tool());
    desk.click(Vec2(5, 795));
    QVERIFY(desk.interaction.selection().empty());
    QVERIFY(!desk.interaction.overlay().find<GizmoMarks>());
    QCOMPARE(desk.steps(), 0);
}

// Wrong: a slip of the hand could not be taken back before it is done.
void TestTransformTool::escTakesADragBack()
{
    CrossDesk desk;
    desk.hold(desk.body);
    const Document before = desk.session.committed().document;
    const Vec2 from = desk.tip(0);
    desk.moveTo(from);
    desk.press(from);
    desk.moveTo(from + Vec2(50, 0));
    QVERIFY(!desk.session.model().document.isSame(before));
    QVERIFY(desk.interaction.escape(desk.time += 8));
    QVERIFY(desk.session.model().document.isSame(before));
    desk.release(from + Vec2(50, 0));
    QCOMPARE(desk.steps(), 0);
    QVERIFY(desk.interaction.tool());
    QVERIFY(desk.interaction.escape(desk.time += 8));
    QVERIFY(!desk.interaction.tool());
    QVERIFY(!desk.interaction.overlay().find<GizmoMarks>());
}

// Wrong: a copy would not be attached as the original is, or the original would go.
void TestTransformTool::controlLeavesACopy()
{
    CrossDesk desk;
    desk.hold(desk.fin);
    const Section before = desk.section(desk.fin);
    const Vec3 axis = desk.gizmo().axis(2); // along the body
    const Vec2 from = desk.tip(2);
    desk.moveTo(from);
    desk.press(from);
    desk.moveTo(desk.further(from, 30.0 * axis), kControl);
    QCOMPARE(desk.hint(), hints::kLeavingCopy);
    desk.release(desk.cursor, Button::Left, kControl);
    QCOMPARE(desk.sections().size(), std::size_t(3));
    QCOMPARE(desk.section(desk.fin), before);
    const Section &copy = *desk.sections().back();
    QCOMPARE(copy.shape, before.shape); // shared
    QCOMPARE(copy.name, std::string("Fin 2"));
    QCOMPARE(copy.parent->section, SectionRef(desk.body));
    QVERIFY((copy.frame.origin - before.frame.origin - 30.0 * axis).norm() < 0.5);
    QVERIFY(std::abs(copy.parent->slitTo.x() - (40.0 + 30.0 * axis.x())) < 0.5);
    QCOMPARE(desk.interaction.selection(), std::vector<SectionRef>{copy.id});
    QCOMPARE(desk.lastStep(), QStringLiteral("Copy Fin"));
}

// Wrong: nothing could be placed exactly.
void TestTransformTool::numbersAreShownAndDone()
{
    CrossDesk desk;
    desk.hold(desk.body);
    const std::vector<ToolNumber> asked = desk.interaction.numbers();
    QCOMPARE(asked.front().kind, ToolNumber::Kind::MoveRight);
    desk.interaction.setNumbers({{ToolNumber::Kind::MoveUp, 12.5}}, desk.time += 8);
    QCOMPARE(desk.hint(), hints::kTransformNumbers);
    QCOMPARE(desk.steps(), 0);
    QVERIFY((desk.shown(desk.body).frame.origin - Vec3(0, 112.5, 0)).norm() < kNear);
    desk.moveTo({600, 300}); // the mouse in the meantime changes nothing
    QVERIFY((desk.shown(desk.body).frame.origin - Vec3(0, 112.5, 0)).norm() < kNear);
    desk.interaction.setNumbers({{ToolNumber::Kind::Turn, radians(30)}}, desk.time += 8);
    QVERIFY(desk.interaction.key(ToolKey::Enter, desk.time += 8));
    QCOMPARE(desk.steps(), 1);
    QVERIFY((desk.section(desk.body).frame.origin - Vec3(0, 112.5, 0)).norm() < kNear);
    QVERIFY(std::abs(desk.section(desk.body).frame.x.y() - 0.5) < 1e-9);
    QVERIFY(!desk.interaction.wants(ToolKey::Enter));
    desk.interaction.setNumbers({{ToolNumber::Kind::Size, 2.0}}, desk.time += 8);
    desk.interaction.dropNumbers(desk.time += 8);
    QCOMPARE(desk.steps(), 1);
    QVERIFY(!desk.session.hasPreview());
}

// Wrong: a row along a line would have to be dragged one by one.
void TestTransformTool::typedCopiesGoOnAndOn()
{
    CrossDesk desk;
    desk.hold(desk.fin);
    desk.interaction.setNumbers(
        {{ToolNumber::Kind::MoveOut, -20.0}, {ToolNumber::Kind::Copies, 3.0}}, desk.time += 8);
    QCOMPARE(desk.session.model().sectionCount(), std::size_t(5));
    QVERIFY(desk.interaction.key(ToolKey::Enter, desk.time += 8));
    QCOMPARE(desk.sections().size(), std::size_t(5));
    const double step = desk.sections()[2]->frame.origin.x() - 40.0;
    QVERIFY(std::abs(std::abs(step) - 20.0) < kNear);
    for (int k = 1; k <= 3; ++k)
        QVERIFY(std::abs(desk.sections()[std::size_t(k) + 1]->frame.origin.x() - 40.0 - k * step) <
                kNear);
    desk.session.history()->undo();
    QCOMPARE(desk.sections().size(), std::size_t(2));
}

// Wrong: edges that shall be level would be off by what the hand trembles.
void TestTransformTool::pointsAreDrawnToOthers()
{
    CrossDesk desk;
    desk.interaction.settings().snaps = true;
    desk.hold(desk.fin);
    // Up to where its upper edge is level with that of the body, 20 mm down, and a little off.
    desk.run("section.free", {{"on", "true"}});
    desk.run("transform.inSpace", {{"on", "true"}});
    desk.wait(10.0);
    const Vec2 from = desk.tip(1);
    desk.moveTo(from);
    desk.press(from);
    desk.moveTo(desk.further(from, Vec3(0, -29.5, 0)));
    QVERIFY(!desk.interaction.overlay().find<GizmoMarks>()->guides.empty());
    desk.release(desk.cursor);
    QVERIFY(std::abs(desk.section(desk.fin).frame.origin.y() - 120.0) < kNear);
    // Elsewhere the grid has it.
    desk.wait(1000.0);
    const Vec2 again = desk.tip(0);
    desk.drag({again, desk.further(again, Vec3(13.1, 0, 0))});
    const double x = desk.section(desk.fin).frame.origin.x() - 40.0;
    QVERIFY(std::abs(x - std::round(x)) < kNear);
}

// Wrong: a body would stick to where its own fin was before the drag.
void TestTransformTool::notToWhatGoesAlong()
{
    CrossDesk desk;
    desk.interaction.settings().snaps = true;
    desk.hold(desk.body);
    desk.run("transform.inSpace", {{"on", "true"}});
    desk.wait(10.0);
    // The body's upper edge, 30 mm up, would be level with the fin's: which is there no more.
    const Vec2 from = desk.tip(1);
    desk.moveTo(from);
    desk.press(from);
    desk.moveTo(desk.further(from, Vec3(0, 30.4, 0)));
    QVERIFY(desk.interaction.overlay().find<GizmoMarks>()->guides.empty());
    desk.release(desk.cursor);
}

// Wrong: each move of the mouse would work out again what numbers have made long since.
void TestTransformTool::typedNumbersAreShownOnce()
{
    CrossDesk desk;
    desk.hold(desk.body);
    desk.interaction.setNumbers({{ToolNumber::Kind::MoveUp, 12.5}}, desk.time += 8);
    const SectionPointer shown = desk.session.model().document.sections.front();
    desk.moveTo({600, 300});
    QVERIFY(desk.session.hasPreview());
    QCOMPARE(desk.session.model().document.sections.front(), shown);
}

// Wrong: one command would have to be taken back four times.
void TestTransformTool::placedInOneStep()
{
    CrossDesk desk;
    desk.interaction.select({desk.fin});
    desk.run("section.place", {{"x", "10"}, {"y", "130"}, {"z", "5"}, {"angle", "75"}});
    QCOMPARE(desk.steps(), 1);
    QVERIFY((positionOf(desk.section(desk.fin)) - Vec3(10, 130, 5)).norm() < kNear);
    QVERIFY(std::abs(angleToParent(desk.section(desk.fin), desk.section(desk.body).frame) -
                     radians(75)) < 1e-9);
}

// Wrong: nobody could turn anything by exactly 45°.
void TestTransformTool::anglesAreRound()
{
    CrossDesk desk;
    desk.interaction.settings().snaps = true;
    desk.hold(desk.body);
    const Vec2 centre = desk.look().centre(), from = desk.onRing(2);
    desk.moveTo(from);
    desk.press(from);
    for (int i = 1; i <= 40; ++i) {
        const Vec2 arm = Eigen::Rotation2Dd(-0.05 * i) * (from - centre);
        desk.moveTo(centre + arm, {}, 1);
        const double angle = degrees(desk.interaction.overlay().find<GizmoMarks>()->value->number);
        QVERIFY(std::abs(angle - std::round(angle)) < kNear);
    }
    desk.release(desk.cursor);
    QVERIFY(std::abs(desk.section(desk.body).frame.x.x()) < 1.0);
}

// Wrong: what is locked would go all the same.
void TestTransformTool::lockedIsRefused()
{
    CrossDesk desk;
    desk.interaction.select({desk.fin});
    desk.run("section.lock");
    QCOMPARE(desk.lastStep(), QStringLiteral("Lock Fin"));
    QVERIFY(desk.section(desk.fin).isLocked);
    const Document before = desk.session.committed().document;
    desk.hold(desk.fin);
    QVERIFY(!desk.interaction.overlay().find<GizmoMarks>());
    const Vec2 on = desk.screen({40, 175, 20});
    desk.drag({on, on + Vec2(30, 0)});
    QCOMPARE(desk.hint(), hints::kLocked);
    desk.run("section.transform"); // down again
    desk.interaction.nudge(Vec2(1, 0), 1.0, desk.time += 8);
    QCOMPARE(desk.hint(), hints::kLocked);
    desk.run("edit.delete");
    QCOMPARE(desk.hint(), hints::kLocked);
    desk.run("section.redraw");
    QVERIFY(!desk.interaction.tool());
    QVERIFY(desk.session.committed().document.isSame(before));
    // With what it is on it goes.
    desk.interaction.select({desk.body});
    desk.interaction.nudge(Vec2(1, 0), 1.0, desk.time += 8);
    QVERIFY(!(desk.section(desk.fin).frame == before.find(desk.fin)->frame));
    desk.interaction.select({desk.fin});
    desk.run("section.lock", {{"on", "false"}});
    QVERIFY(!desk.section(desk.fin).isLocked);
}

// Wrong: a generated section would seem to be nailed down, and nobody would say why.
void TestTransformTool::madeOnesSayTheirSource()
{
    CrossDesk desk;
    desk.run("operation.linear", {{"section", "Fin"}, {"along", "Section 1"}, {"count", "3"}});
    const Model &model = desk.session.committed();
    QCOMPARE(model.sectionCount(), std::size_t(4));
    const SectionRef made = model.ref(3);
    desk.interaction.select({made});
    desk.run("section.transform");
    desk.wait(10.0);
    QCOMPARE(desk.hint(), hints::kMadeByOperation);
    const std::vector<std::string_view> offered = desk.interaction.tool()->commands();
    QCOMPARE(std::string(offered.front()), std::string("operation.editSource"));
    desk.run("operation.editSource");
    QCOMPARE(desk.interaction.selection(), std::vector<SectionRef>{desk.fin});
    QVERIFY(desk.interaction.tool());
    desk.wait(10.0);
    QVERIFY(desk.interaction.overlay().find<GizmoMarks>());
    desk.interaction.select({made});
    desk.run("operation.detach");
    QCOMPARE(desk.sections().size(), std::size_t(3));
    desk.wait(10.0);
    QVERIFY(desk.interaction.overlay().find<GizmoMarks>()); // it can be moved now
}

// Wrong: a nudge would tear a joint apart.
void TestTransformTool::arrowKeysTakeWhatIsOnIt()
{
    CrossDesk desk;
    desk.interaction.select({desk.body});
    const Vec3 fin = desk.section(desk.fin).frame.origin;
    desk.interaction.nudge(Vec2(0, 1), 1.0, desk.time += 8);
    desk.interaction.nudge(Vec2(0, 1), 1.0, desk.time += 8);
    QCOMPARE(desk.steps(), 1); // one step
    QVERIFY((desk.section(desk.fin).frame.origin - fin - Vec3(0, 2, 0)).norm() < kNear);
    desk.run("transform.withChildren", {{"on", "false"}});
    desk.interaction.nudge(Vec2(0, 1), 1.0, desk.time += 8);
    QVERIFY((desk.section(desk.fin).frame.origin - fin - Vec3(0, 2, 0)).norm() < kNear);
}

// Wrong: everything that is derived would be worked out anew after an undo.
void TestTransformTool::undoBringsTheObjectsBack()
{
    CrossDesk desk;
    const Document before = desk.session.committed().document;
    const auto undone = [&] {
        desk.session.history()->undo();
        return desk.session.committed().document.isSame(before);
    };
    for (const std::string id :
         {"edit.duplicate", "edit.cut", "edit.mirrorCopyX", "section.lock", "section.free"}) {
        desk.interaction.select({desk.fin});
        desk.run(id);
        QVERIFY2(!desk.session.committed().document.isSame(before), id.c_str());
        QVERIFY2(undone(), id.c_str());
    }
    desk.hold(desk.body);
    desk.drag({desk.tip(0), desk.tip(0) + Vec2(40, 0)});
    QVERIFY(!desk.session.committed().document.isSame(before));
    QVERIFY(undone());
    QVERIFY(desk.interaction.tool()); // still in the hand
}

// Wrong: a script could not do what the window does.
void TestTransformTool::byCommands()
{
    CrossDesk desk;
    desk.interaction.select({desk.body});
    desk.run("section.move", {{"x", "10"}, {"z", "-5"}});
    QVERIFY((desk.section(desk.body).frame.origin - Vec3(10, 100, -5)).norm() < kNear);
    desk.run("section.turn", {{"axis", "y"}, {"angle", "90"}});
    QVERIFY((desk.section(desk.body).frame.normal() - Vec3::UnitX()).norm() < 1e-9);
    desk.run("section.scale", {{"x", "2"}, {"y", "1"}});
    QVERIFY(std::abs(desk.section(desk.body).shape->bounds().size().x() - 400.0) < kNear);
    desk.run("section.place", {{"x", "0"}, {"y", "70"}});
    QVERIFY((positionOf(desk.section(desk.body)) - Vec3(0, 70, -5)).norm() < kNear);
    desk.interaction.select({desk.fin});
    desk.run("section.place", {{"angle", "60"}});
    QVERIFY(std::abs(angleToParent(desk.section(desk.fin), desk.section(desk.body).frame) -
                     radians(60)) < 1e-9);
    desk.run("section.makeOrthogonal");
    QVERIFY(std::abs(desk.section(desk.fin).frame.normal().dot(
                desk.section(desk.body).frame.normal())) < 1e-12);
    desk.run("section.move", {{"y", "30"}, {"copies", "2"}});
    QCOMPARE(desk.sections().size(), std::size_t(4));
    const auto wrong = desk.commands.run("section.turn", {{"axis", "w"}, {"angle", "5"}});
    QCOMPARE(wrong.error().place, std::string("axis"));
    QCOMPARE(desk.commands.run("section.scale", {{"factor", "-1"}}).error().place,
             std::string("factor"));
}

// Wrong: a copy, or what came from elsewhere, could not be attached to anything.
void TestTransformTool::putOnAnother()
{
    CrossDesk desk;
    desk.interaction.select({desk.fin});
    desk.run("section.putOn", {{"on", ""}});
    QVERIFY(!desk.section(desk.fin).parent);
    desk.run("section.makeOrthogonal");
    QVERIFY(!desk.section(desk.fin).parent);
    desk.run("section.putOn"); // asked for in the view
    QCOMPARE(desk.hint(), hints::kPickParent);
    desk.click(desk.screen({-80, 60, 0}));
    QVERIFY(!desk.interaction.tool());
    const Section &fin = desk.section(desk.fin);
    QCOMPARE(fin.parent->section, SectionRef(desk.body));
    QVERIFY(std::abs(fin.parent->slitFrom.x() - 40.0) < kNear);
    QCOMPARE(std::abs(fin.parent->slitTo.y() - fin.parent->slitFrom.y()), 50.0);
    // Not on what is on it, and not where they do not meet.
    desk.interaction.select({desk.body});
    desk.run("section.putOn", {{"on", "Fin"}});
    QCOMPARE(desk.hint(), hints::kCannotBeOn);
    desk.interaction.select({desk.fin});
    desk.run("section.putOn", {{"on", ""}});
    desk.run("section.move", {{"x", "500"}});
    desk.run("section.putOn", {{"on", "Section 1"}});
    QCOMPARE(desk.hint(), hints::kDoNotMeet);
}

// Wrong: what leans by a hair could not be made straight.
void TestTransformTool::alignedFreedAndHeld()
{
    CrossDesk desk;
    desk.interaction.select({desk.body});
    desk.run("section.turn", {{"axis", "y"}, {"angle", "7"}});
    QVERIFY(std::abs(desk.section(desk.body).frame.normal().z()) < 0.999);
    desk.run("section.snapNormal");
    QVERIFY(std::abs(std::abs(desk.section(desk.body).frame.normal().z()) - 1.0) < 1e-12);
    // One that is held goes to an axis that its angle allows.
    desk.interaction.select({desk.fin});
    desk.run("section.turn", {{"axis", "z"}, {"angle", "50"}});
    desk.run("section.snapNormal");
    QVERIFY(std::abs(std::abs(desk.section(desk.fin).frame.normal().y()) - 1.0) < 1e-12);
    desk.interaction.select({desk.body});
    desk.run("section.turn", {{"axis", "y"}, {"angle", "30"}});
    desk.interaction.select({desk.fin});
    desk.run("section.turn", {{"axis", "normal"}, {"angle", "0"}});
    const Document before = desk.session.committed().document;
    desk.run("section.place", {{"angle", "70"}});
    desk.run("section.snapNormal");
    QCOMPARE(desk.hint(), hints::kHeldByParent);
    desk.run("section.free");
    desk.run("section.snapNormal");
    QVERIFY(desk.section(desk.fin).frame.normal().cwiseAbs().maxCoeff() > 1.0 - 1e-12);
}

FFF_TEST(TestTransformTool)
#include "tst_transform_tool.moc"
