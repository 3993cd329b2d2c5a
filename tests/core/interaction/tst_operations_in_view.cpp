#include <QGuiApplication>
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/geometry/contour_points.h"
#include "core/interaction/hover_words.h"
#include "core/interaction/pick_words.h"
#include "core/interaction/tool.h"
#include "core/interaction/view_fit.h"
#include "core/model/edit_words.h"
#include "core/model/origin.h"
#include "tests/core/interaction/desk.h"
#include "tests/core/operations/operation_models.h"
#include "tests/test_program.h"

#include <QUndoStack>

using namespace fff;
using namespace fff::test;

namespace {

/// The spine and its rib, seen from the front and a little from the side.
struct BoneDesk : Desk
{
    FishBones bones;

    BoneDesk()
    {
        session.reset(bones.document);
        look(bones.document);
    }
    void look(const Document &document)
    {
        session.reset(document);
        Camera camera;
        camera.orientation = Eigen::Quaterniond(Eigen::AngleAxisd(-0.6, Vec3::UnitY())) *
                             Eigen::Quaterniond(Eigen::AngleAxisd(-0.3, Vec3::UnitX()));
        interaction.setCamera(fitted(camera, session.committed().bounds(), kViewport));
    }
    const Model &model() const { return session.committed(); }
    const Document &document() const { return model().document; }
    SectionRef named(const char *name) const
    {
        for (std::size_t i = 0; i < model().sectionCount(); ++i)
            if (model().section(i)->name == name)
                return model().ref(i);
        return {};
    }
    /// A place of the section that no other one hides.
    Vec2 placeOf(const char *name) const
    {
        const int wanted = model().indexOf(named(name));
        const Section &section = *model().section(static_cast<std::size_t>(wanted));
        const Box2 box = section.shape->bounds();
        for (double v = 0.05; v < 1.0; v += 0.05)
            for (double u = 0.05; u < 1.0; u += 0.05) {
                const Vec2 local = box.min + box.size().cwiseProduct(Vec2(u, v));
                const Vec2 at = screen(section.frame.toWorld(local));
                const auto hits = pick(model(), interaction.camera().rayThrough(at, kViewport));
                if (!hits.empty() && hits.front().section == wanted)
                    return at;
            }
        return Vec2(-1.0, -1.0);
    }
    void makeRibs()
    {
        QVERIFY(commands.run(
            "operation.linear",
            {{"section", "Rib"}, {"along", "Spine"}, {"side", "both"}, {"name", "Ribs"}}));
    }
    OperationId ribs() const { return document().operations.front()->id; }
};

} // namespace

class TestOperationsInView : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void twoSectionsAndThreeClicks();
    void whatIsSelectedIsTaken();
    void aPickIsTakenBack();
    void theFirstClickIsForTheOperation();
    void deletedAndBack();
    void anInputIsChosenAnew();
    void handlesMoveTheRange();
    void handlesDoNotPass();
    void aRangeGoesOnRoundARing();
    void undoBringsTheVeryObjects();
    void aJointOfOneStaysAsItWasSet();
    void aThirdTakesThePlaceOfTheFirst();
    void anotherSelectionEndsTheAsking();
    void anImageIsEditedAsItsSource();
    void bothSidesOfTheMirrorAreEdited();
    void whatIsMadeSaysSo();
};

// Wrong: one could not come to ribs without a script; or the view would show nothing on the way.
void TestOperationsInView::twoSectionsAndThreeClicks()
{
    BoneDesk desk;
    QVERIFY(desk.commands.run("operation.linear"));
    QVERIFY(desk.interaction.tool());
    QCOMPARE(desk.interaction.hint().words.text, hints::kPickOne);
    QCOMPARE(roleAskedFor(desk.interaction.hint()), std::string("section"));
    desk.click(desk.placeOf("Rib"));
    QCOMPARE(roleAskedFor(desk.interaction.hint()), std::string("along"));
    QVERIFY(!desk.session.hasPreview());
    desk.moveTo(desk.placeOf("Spine"));
    QVERIFY2(desk.session.hasPreview(), "over the spine the ribs are there already");
    QCOMPARE(desk.session.model().sectionCount(), 2U + 7U);
    const std::uint64_t revision = desk.session.revision();
    desk.moveTo(desk.cursor + Vec2(1.0, 1.0));
    QVERIFY2(desk.session.revision() == revision, "over one section they are worked out once");
    desk.click(desk.placeOf("Spine"));
    QVERIFY(!desk.interaction.tool());
    QCOMPARE(desk.model().sectionCount(), 2U + 7U);
    QCOMPARE(desk.document().operations[0]->name, std::string("Rib row"));
    QCOMPARE(desk.interaction.selectedOperation(), desk.ribs());
    QCOMPARE(desk.session.history()->count(), 1);
}

// Wrong: what a person has selected for it would have to be clicked again.
void TestOperationsInView::whatIsSelectedIsTaken()
{
    BoneDesk desk;
    desk.interaction.select({desk.bones.rib});
    QVERIFY(desk.commands.run("operation.linear"));
    QCOMPARE(roleAskedFor(desk.interaction.hint()), std::string("along"));
    desk.interaction.escape(desk.time);
    QVERIFY(!desk.interaction.tool());
    QVERIFY(desk.document().operations.empty());
    desk.interaction.select({desk.bones.rib, desk.bones.spine});
    QVERIFY(desk.commands.run("operation.linear"));
    QCOMPARE(desk.document().operations.size(), 1U);
}

// Wrong: a wrong click would mean to begin again.
void TestOperationsInView::aPickIsTakenBack()
{
    BoneDesk desk;
    QVERIFY(desk.commands.run("operation.linear"));
    QVERIFY(!desk.interaction.wants(ToolKey::Backspace));
    desk.click(desk.placeOf("Spine"));
    QCOMPARE(roleAskedFor(desk.interaction.hint()), std::string("along"));
    QVERIFY(desk.interaction.key(ToolKey::Backspace, desk.time));
    QCOMPARE(roleAskedFor(desk.interaction.hint()), std::string("section"));
    // The same one twice is none.
    desk.click(desk.placeOf("Rib"));
    desk.click(desk.placeOf("Rib"));
    QCOMPARE(roleAskedFor(desk.interaction.hint()), std::string("along"));
    // A list ends with Enter.
    QVERIFY(desk.commands.run("operation.blend"));
    QCOMPARE(roleAskedFor(desk.interaction.hint(), "blend"), std::string("along"));
    QVERIFY(!desk.interaction.wants(ToolKey::Enter));
}

// Wrong: to change all ribs one would have to know where their operation is; or one rib alone could
// not be had.
void TestOperationsInView::theFirstClickIsForTheOperation()
{
    BoneDesk desk;
    desk.makeRibs();
    desk.interaction.select({});
    const Vec2 at = desk.placeOf("Rib 3");
    const SectionRef third = desk.named("Rib 3");
    desk.moveTo(at);
    QCOMPARE(desk.interaction.hint().words.text, hints::kSelectOperation);
    desk.click(at);
    QCOMPARE(desk.interaction.selectedOperation(), desk.ribs());
    QVERIFY(desk.interaction.selection().empty());
    QCOMPARE(desk.interaction.sectionsInFocus().size(), 7U);
    desk.click(at);
    QVERIFY(!desk.interaction.selectedOperation().isValid());
    QCOMPARE(desk.interaction.selection(), std::vector{third});
    QCOMPARE(desk.interaction.operationInFocus(), desk.ribs());
    // Another one of them, now that they are chosen.
    desk.click(desk.placeOf("Rib 2"));
    QCOMPARE(desk.interaction.selection(), std::vector{desk.named("Rib 2")});
    desk.click(at, kControl);
    QCOMPARE(desk.interaction.selection().size(), 2U);
    // Back, step by step.
    desk.interaction.select({third});
    QVERIFY(desk.interaction.escape(desk.time));
    QCOMPARE(desk.interaction.selectedOperation(), desk.ribs());
    QVERIFY(desk.interaction.escape(desk.time));
    QVERIFY(!desk.interaction.selectedOperation().isValid());
}

// Wrong: Undo would bring an operation back and leave its panel closed.
void TestOperationsInView::deletedAndBack()
{
    BoneDesk desk;
    desk.makeRibs();
    QCOMPARE(desk.interaction.selectedOperation(), desk.ribs());
    QVERIFY(desk.commands.run("edit.delete"));
    QVERIFY(desk.document().operations.empty());
    QVERIFY(!desk.interaction.selectedOperation().isValid());
    desk.session.history()->undo();
    QCOMPARE(desk.interaction.selectedOperation(), desk.ribs());
    // Of what it makes, one is left out.
    desk.interaction.select({desk.named("Rib 3")});
    QVERIFY(desk.commands.run("edit.delete"));
    QCOMPARE(desk.model().sectionCount(), 2U + 6U);
    QCOMPARE(desk.session.history()->undoText(), QStringLiteral("Leave out Rib 3"));
}

// Wrong: a section that was deleted would take all that was set with it.
void TestOperationsInView::anInputIsChosenAnew()
{
    BoneDesk desk;
    desk.makeRibs();
    desk.interaction.select({desk.bones.rib});
    QVERIFY(desk.commands.run("edit.delete"));
    QCOMPARE(desk.model().sectionCount(), 1U);
    const OperationResult *result = desk.model().resultOf(desk.ribs());
    QCOMPARE(result->notices.size(), 1U);
    QCOMPARE(result->notices[0].name, std::string("Rib"));
    Document document = desk.document();
    add(document, "Fin", polygonShape(rectangle(-15, -15, 15, 15)), sideFrame({120, 80, 0}));
    desk.look(document);
    desk.interaction.selectOperation(desk.ribs());
    QVERIFY(desk.commands.run("operation.choose", {{"role", "section"}}));
    QCOMPARE(desk.interaction.tool()->asksFor().role, std::string("section"));
    desk.click(desk.placeOf("Fin"));
    QVERIFY(!desk.interaction.tool());
    QCOMPARE(desk.document().operations[0]->inputs.at("section")[0].name, std::string("Fin"));
    QCOMPARE(desk.document().operations[0]->name, std::string("Ribs"));
    QCOMPARE(desk.model().sectionCount(), 2U + 7U);
    QCOMPARE(desk.session.history()->undoText(), QStringLiteral("Ribs: Section → Fin"));
    // Not of what it makes itself.
    QVERIFY(desk.commands.run("operation.choose", {{"role", "section"}}));
    desk.click(desk.placeOf("Fin 2"));
    QVERIFY(desk.interaction.tool());
}

// Wrong: a drag would be many steps, would not show what it does, or could not be given up.
void TestOperationsInView::handlesMoveTheRange()
{
    BoneDesk desk;
    desk.makeRibs();
    QVERIFY(desk.interaction.overlay().find<OperationMarks>());
    const auto &handles = desk.interaction.overlay().find<OperationMarks>()->handles;
    QCOMPARE(handles.size(), 2U);
    QCOMPARE(handles[1].key, std::string("to"));
    const Vec2 from = desk.screen(handles[0].at), to = desk.screen(handles[1].at);
    desk.moveTo(to);
    QCOMPARE(desk.interaction.hint().words.text, hints::kMoveEnd);
    const int steps = desk.session.history()->count();
    desk.press(to);
    desk.moveTo(0.5 * (from + to));
    QVERIFY(desk.session.hasPreview());
    QVERIFY(desk.interaction.overlay().find<OperationMarks>());
    desk.interaction.escape(desk.time);
    QVERIFY(!desk.session.hasPreview());
    desk.release(desk.cursor);
    QCOMPARE(desk.session.history()->count(), steps);
    desk.moveTo(to);
    desk.press(to);
    desk.moveTo(0.5 * (from + to));
    desk.release(desk.cursor);
    QCOMPARE(desk.session.history()->count(), steps + 1);
    const double now = std::get<double>(desk.document().operations[0]->parameters.at("to"));
    QVERIFY(std::abs(now - 0.5) < 0.05);
    QVERIFY2(std::abs(now / 0.005 - std::round(now / 0.005)) < 1e-9, "in the steps of its field");
    QVERIFY(desk.session.history()->undoText().startsWith(QStringLiteral("Ribs: To 100")));
    for (const SectionPointer &rib : desk.model().resultOf(desk.ribs())->sections)
        QVERIFY2(rib->frame.origin.x() > 200.0 * (1.0 - now) - 1.0, "its normal points to x = 0");
}

// Wrong: plates that run over the place where a contour begins would jump to its other side when
// one end of them is dragged.
void TestOperationsInView::aRangeGoesOnRoundARing()
{
    BoneDesk desk;
    QVERIFY(desk.commands.run(
        "operation.revolve",
        {{"section", "Rib"}, {"along", "Spine"}, {"from", "85"}, {"to", "10"}, {"name", "Ribs"}}));
    const OperationMarks marks = *desk.interaction.overlay().find<OperationMarks>();
    QVERIFY(marks.isRing());
    const auto drag = [&](int handle, double to) {
        const auto &handles = desk.interaction.overlay().find<OperationMarks>()->handles;
        const Vec2 from = desk.screen(handles[static_cast<std::size_t>(handle)].at);
        desk.moveTo(from);
        desk.press(from);
        desk.moveTo(desk.screen(placeOnTrack(marks.track, to)));
        desk.release(desk.cursor);
    };
    const auto value = [&](const char *key) {
        return std::get<double>(desk.document().operations[0]->parameters.at(key));
    };
    drag(0, 0.9);
    QVERIFY(std::abs(value("from") - 0.9) < 0.02);
    QCOMPARE(value("to"), 0.1);
    drag(1, 0.15);
    QVERIFY(std::abs(value("to") - 0.15) < 0.02);
    // A straight one that was typed the wrong way round is dragged from where it is.
    BoneDesk straight;
    straight.makeRibs();
    QVERIFY(straight.commands.run("operation.change", {{"from", "80"}, {"to", "20"}}));
    const OperationMarks line = *straight.interaction.overlay().find<OperationMarks>();
    QVERIFY(!line.isRing());
    straight.moveTo(straight.screen(line.handles[0].at));
    straight.press(straight.cursor);
    straight.moveTo(straight.screen(placeOnTrack(line.track, 0.7)));
    straight.release(straight.cursor);
    QVERIFY(std::abs(std::get<double>(straight.document().operations[0]->parameters.at("from")) -
                     0.7) < 0.02);
}

// Wrong: slits, outlines and triangles of all ribs would be worked out again with every Undo.
void TestOperationsInView::undoBringsTheVeryObjects()
{
    BoneDesk desk;
    desk.makeRibs();
    const std::vector<SectionPointer> before = desk.model().sections();
    QVERIFY(desk.commands.run("operation.change", {{"count", "20"}, {"scale", "thickness"}}));
    QVERIFY(desk.commands.run("operation.switch"));
    QVERIFY(desk.commands.run("operation.bake"));
    while (desk.session.history()->undoText() != QStringLiteral("Add Ribs"))
        desk.session.history()->undo();
    QVERIFY(desk.model().sections() == before);
}

// Wrong: what a person set for one rib would be lost with the next change of their number.
void TestOperationsInView::aJointOfOneStaysAsItWasSet()
{
    BoneDesk desk;
    desk.makeRibs();
    const SectionRef third = desk.named("Rib 3");
    const JointRef joint{desk.bones.spine, third};
    const int before = jointState(desk.model(), joint)->sign;
    desk.interaction.selectJoint(joint);
    QVERIFY(desk.interaction.selectedJoint());
    QVERIFY(desk.commands.run("joint.flip"));
    QCOMPARE(jointState(desk.model(), joint)->sign, -before);
    QVERIFY(desk.commands.run("operation.change", {{"operation", "Ribs"}, {"count", "12"}}));
    QCOMPARE(jointState(desk.model(), joint)->sign, -before);
    const JointRef other{desk.bones.spine, desk.named("Rib 2")};
    QCOMPARE(jointState(desk.model(), other)->sign, before);
}

// Wrong: a section that was picked would be listed, and count for nothing.
void TestOperationsInView::aThirdTakesThePlaceOfTheFirst()
{
    BoneDesk desk;
    desk.makeRibs();
    QVERIFY(desk.commands.run("operation.rotational", {{"name", "Round"}, {"axis", "slit"}}));
    const auto picked = [&] {
        std::vector<std::string> names;
        const Operation &round = *desk.document().operations.back();
        if (const auto found = round.inputs.find("around"); found != round.inputs.end())
            for (const OperationInput &input : found->second)
                names.push_back(input.name);
        return names;
    };
    for (const char *name : {"Rib", "Spine", "Rib 3"}) {
        QVERIFY(
            desk.commands.run("operation.choose", {{"operation", "Round"}, {"role", "around"}}));
        desk.click(desk.placeOf(name));
    }
    QCOMPARE(picked(), (std::vector<std::string>{"Spine", "Rib 3"}));
}

// Wrong: a click would change an operation that is not the one whose panel is open; or one would be
// asked for what does not count any more.
void TestOperationsInView::anotherSelectionEndsTheAsking()
{
    BoneDesk desk;
    desk.makeRibs();
    QVERIFY(desk.commands.run("operation.mirror", {{"name", "Both"}, {"plane", "section"}}));
    QVERIFY(desk.commands.run("operation.choose", {{"role", "across"}}));
    QVERIFY(desk.interaction.tool());
    QVERIFY(desk.commands.run("operation.change", {{"plane", "x"}}));
    QVERIFY2(!desk.interaction.tool(), "the plane X asks for no section");
}

// Wrong: a range would turn round while it is dragged, and all ribs be named anew.
void TestOperationsInView::handlesDoNotPass()
{
    BoneDesk desk;
    desk.makeRibs();
    QVERIFY(desk.commands.run("operation.change", {{"from", "40"}}));
    const auto handles = desk.interaction.overlay().find<OperationMarks>()->handles;
    const Vec2 from = desk.screen(handles[0].at), to = desk.screen(handles[1].at);
    desk.moveTo(to);
    desk.press(to);
    desk.moveTo(from + 2.0 * (from - to));
    desk.release(desk.cursor);
    QCOMPARE(std::get<double>(desk.document().operations[0]->parameters.at("to")), 0.4);
    // At one place, the one that can go on is taken.
    const auto both = desk.interaction.overlay().find<OperationMarks>()->handles;
    QVERIFY((both[0].at - both[1].at).norm() < 1e-6);
    desk.moveTo(desk.screen(both[0].at));
    desk.press(desk.cursor);
    desk.moveTo(to);
    desk.release(desk.cursor);
    QCOMPARE(std::get<double>(desk.document().operations[0]->parameters.at("from")), 0.4);
    QVERIFY(std::get<double>(desk.document().operations[0]->parameters.at("to")) > 0.9);
}

// Wrong: of two legs that are one, only the drawn one could be changed.
void TestOperationsInView::anImageIsEditedAsItsSource()
{
    BoneDesk desk;
    Document document = newDocument();
    const SectionId body =
        add(document, "Body", polygonShape(rectangle(-60, -60, 60, 60)), sideFrame({0, 60, 0}));
    const SectionId leg = add(document, "Leg", polygonShape(rectangle(-20, -20, 20, 20)),
                              frontFrame({70, 40, 10}), Parent{SectionRef(body), {0, 0}, {0, 20}});
    desk.look(document);
    QVERIFY(desk.commands.run("operation.mirror", {{"name", "Mirror"}}));
    const SectionRef image = desk.named("Leg′");
    QVERIFY(desk.model().find(image));
    const std::optional<Origin> origin = originOf(desk.model(), image);
    QVERIFY(origin);
    QCOMPARE(origin->section->id, leg);
    // A point of it.
    desk.interaction.select({image});
    QVERIFY(desk.interaction.overlay().find<sign::Points>());
    const Section shown = *editedSection(desk.model(), image);
    const Vec2 corner = shown.shape->contour().segment(0).p0;
    const Vec2 at = desk.screen(shown.frame.toWorld(corner));
    const Vec2 there = desk.screen(shown.frame.toWorld(corner + Vec2(-15.0, 0.0)));
    desk.moveTo(at);
    desk.press(at);
    desk.moveTo(there);
    desk.release(there);
    const Vec2 moved = desk.document().find(leg)->shape->contour().segment(0).p0;
    QVERIFY((moved - corner).norm() > 10.0);
    QVERIFY2(desk.model().find(image)->shape->contour().segment(0).p0 == moved,
             "the image has what its source has");
    // As a whole: to the right the image, to the left the source.
    desk.interaction.selectPoints({});
    const Vec3 before = desk.document().find(leg)->frame.origin;
    const Vec3 imageBefore = desk.model().find(image)->frame.origin;
    desk.interaction.select({image});
    QVERIFY(desk.interaction.nudge(Vec2::UnitX(), 5.0, desk.time));
    const Vec3 by = desk.document().find(leg)->frame.origin - before;
    const Vec3 imageBy = desk.model().find(image)->frame.origin - imageBefore;
    QVERIFY(std::abs(by.norm() - 5.0) < 1e-9);
    QVERIFY((imageBy - Vec3(-by.x(), by.y(), by.z())).norm() < 1e-9);
    // Deleted with its source.
    desk.interaction.select({image});
    QVERIFY(desk.commands.run("edit.delete"));
    QVERIFY(!desk.document().find(leg));
    QVERIFY(!desk.model().find(image));
}

// Wrong: of a section across the mirror, a point on the smaller half could be dragged, and nothing
// would come of it.
void TestOperationsInView::bothSidesOfTheMirrorAreEdited()
{
    BoneDesk desk;
    Document document = newDocument();
    const SectionId body =
        add(document, "Body", polygonShape({{-40, -40}, {60, -40}, {60, 10}, {40, 40}, {-40, 40}}),
            frontFrame({0, 60, 0}));
    desk.look(document);
    QVERIFY(desk.commands.run("operation.mirror", {{"name", "Mirror"}}));
    desk.interaction.select({body});
    const auto shown = [&] { return editedSection(desk.model(), body); };
    const auto isSymmetric = [&] {
        const Shape &shape = *desk.model().find(body)->shape;
        for (int i = 0; i < shape.contour().segmentCount(); ++i) {
            const Vec2 p = shape.contour().segment(i).p0;
            if (nearestPlace(shape.contour(), Vec2(-p.x(), p.y())).distance > 1e-3)
                return false;
        }
        return true;
    };
    QVERIFY(isSymmetric());
    QVERIFY2(shown()->shape == desk.model().find(body)->shape, "points are those that are seen");
    for (const double side : {-1.0, 1.0}) {
        const Contour &contour = shown()->shape->contour();
        int corner = 0; // the lowest on that side
        for (int i = 0; i < contour.segmentCount(); ++i) {
            const Vec2 p = contour.segment(i).p0, best = contour.segment(corner).p0;
            if (side * p.x() - p.y() > side * best.x() - best.y())
                corner = i;
        }
        const Vec2 from = contour.segment(corner).p0, to = from + Vec2(side * -12.0, 7.0);
        const double area = shown()->shape->area();
        const int steps = desk.steps();
        desk.moveTo(desk.screen(shown()->frame.toWorld(from)));
        desk.press(desk.cursor);
        desk.moveTo(desk.screen(shown()->frame.toWorld(to)));
        desk.release(desk.cursor);
        QCOMPARE(desk.steps(), steps + 1);
        QVERIFY2(std::abs(shown()->shape->area() - area) > 100.0, "it changed");
        QVERIFY(isSymmetric());
        // The point is where it was put, and selected there; its image is opposite.
        QCOMPARE(desk.interaction.points().points().size(), 1U);
        const Vec2 now = position(*shown()->shape, desk.interaction.points().points().front());
        QVERIFY((now - to).norm() < 1.0);
        QVERIFY2(nearestPlace(shown()->shape->contour(), Vec2(-now.x(), now.y())).distance < 1e-3,
                 "its image");
        QVERIFY2(*desk.document().find(body)->shape == *shown()->shape, "what is drawn is so, too");
    }
    // With keys, and undone.
    QVERIFY(desk.interaction.nudge(Vec2::UnitY(), 3.0, desk.time));
    QVERIFY(isSymmetric());
    while (desk.session.history()->canUndo())
        desk.session.history()->undo();
    QVERIFY(desk.document().isSame(document));
}

// Wrong: an arrow key on a rib would do nothing, and nobody would know why.
void TestOperationsInView::whatIsMadeSaysSo()
{
    BoneDesk desk;
    desk.makeRibs();
    desk.interaction.select({desk.named("Rib 3")});
    QVERIFY(!desk.interaction.overlay().find<sign::Points>());
    QVERIFY(desk.interaction.nudge(Vec2::UnitX(), 1.0, desk.time));
    QCOMPARE(desk.interaction.hint().words.text, hints::kMadeByOperation);
    QCOMPARE(nameIn(desk.interaction.hint()), std::string("Rib 3"));
    QCOMPARE(nameIn(desk.interaction.hint(), 2), std::string("Ribs"));
    QVERIFY(desk.interaction.hint().isRefusal);
    const int steps = desk.session.history()->count();
    QVERIFY(desk.commands.run("section.redraw"));
    QVERIFY(!desk.interaction.tool());
    QCOMPARE(desk.session.history()->count(), steps);
}

FFF_TEST_WITH(TestOperationsInView, fff::testing::runWithin<TestOperationsInView, QGuiApplication>)
#include "tst_operations_in_view.moc"
