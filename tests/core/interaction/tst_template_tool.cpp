// The handles of templates in the view: what they do, to what, and when they go.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/base/tolerances.h"
#include "core/interaction/template_tool.h"
#include "core/interaction/template_words.h"
#include "core/templates/moved_template.h"
#include "tests/core/interaction/template_desk.h"
#include "tests/test_program.h"

#include <QUndoStack>

#include <random>

using namespace fff;
using namespace fff::test;

namespace {

bool isAt(const Vec3 &a, const Vec3 &b, double reach = 1e-9)
{
    return (a - b).norm() <= reach;
}

} // namespace

class TestTemplateTool : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aPictureHasHandlesInItsPlane();
    void onASectionItStaysOnIt();
    void aMeshTurnsAnyWay();
    void everyDragIsOneStepThatIsTakenBack_data();
    void everyDragIsOneStepThatIsTakenBack();
    void turnedItIsDrawnUprightAgain();
    void movedItComesLevelWithSections();
    void numbersAreShownAndDone();
    void escTakesADragBack();
    void lockedOrHiddenItHasNone();
    void aClickBesideEndsIt();
    void aStrokeEndsIt();
    void theViewTurnsUnderIt();
    void goneItIsLetGo();
    void movedThroughAnyPlaces();
    void beyondAllLimitsIsRefused();
};

void TestTemplateTool::aPictureHasHandlesInItsPlane()
{
    TemplateDesk desk(pictureTemplate(discPicture()));
    desk.hold();
    using enum GizmoPart;
    QVERIFY(desk.marks());
    for (const GizmoPart part : {MoveX, MoveY, MoveZ, MoveFree, TurnZ, ScaleAll})
        QVERIFY(desk.gizmo().has(part));
    for (const GizmoPart part : {TurnX, TurnY, ScaleX, ScaleY})
        QVERIFY(!desk.gizmo().has(part));
    QCOMPARE(desk.hint(), hints::kTemplateHandles);
    // On the ground its arrows lie there.
    desk.run("template.lay", {{"plane", "ground"}});
    desk.look(0.3, 0.6);
    desk.hold(); // asked for again, it is laid down
    desk.hold();
    QVERIFY(std::abs(desk.gizmo().axis(2).y()) > 1.0 - 1e-12);
    QVERIFY(desk.gizmo().axis(0).dot(desk.interaction.camera().right()) > 0.0);
    QVERIFY(desk.gizmo().axis(1).dot(desk.interaction.camera().up()) > 0.0);
}

// Wrong: a picture would come off the face that it is on, by a drag or by rounding.
void TestTemplateTool::onASectionItStaysOnIt()
{
    TemplateDesk desk(pictureTemplate(discPicture(), 0.1));
    Document aslant = desk.session.committed().document;
    Frame frame = front(0.0);
    frame.x = Vec3(0.6, 0.0, 0.8);
    aslant = withSection(aslant, polygonShape(rectangle(-60, 0, 60, 90)), frame);
    desk.session.commit(QStringLiteral("Draw"), aslant);
    desk.run("template.lay", {{"plane", "section"}, {"section", desk.sections().back()->name}});
    QVERIFY(desk.one().on != SectionRef());
    desk.look(0.2, 0.3);
    desk.hold();
    QVERIFY(!desk.gizmo().has(GizmoPart::MoveZ));
    const Vec3 before = desk.one().frame.origin;
    const Vec2 at = desk.look().tip(0);
    desk.drag({at, at + Vec2(40, 7)});
    QVERIFY((desk.one().frame.origin - before).norm() > 5.0);
    QCOMPARE(desk.one().frame.origin.z(), before.z());
    const Vec2 ring = desk.onRing(2);
    desk.drag({ring, ring + Vec2(30, 40)});
    QCOMPARE(desk.one().frame.origin.z(), before.z());
    QVERIFY(std::abs(desk.one().frame.normal().z()) > 1.0 - 1e-12);
    // Seen on its edge too.
    Camera camera = desk.interaction.camera();
    camera.orientation = Eigen::Quaterniond(
        Eigen::AngleAxisd(std::atan2(-0.8, 0.6) + 0.5 * std::numbers::pi, Vec3::UnitY()));
    desk.interaction.setCamera(camera);
    desk.wait(10.0);
    const Vec2 middle = desk.look().centre();
    desk.drag({middle, middle + Vec2(60, -30)});
    QCOMPARE(desk.one().frame.origin.z(), before.z());
}

void TestTemplateTool::aMeshTurnsAnyWay()
{
    TemplateDesk desk(ballTemplate());
    desk.look(0.5, 0.4);
    desk.hold();
    QVERIFY(desk.gizmo().isInSpace);
    for (const int axis : {0, 1, 2}) {
        const Frame before = desk.one().frame;
        const Vec2 ring = desk.onRing(axis);
        desk.drag({ring, ring + Vec2(35, 25)});
        const Frame &after = desk.one().frame;
        QVERIFY(isAt(after.origin, before.origin));
        QVERIFY(!isAt(after.x, before.x, 1e-3) || !isAt(after.y, before.y, 1e-3));
        // What the ring is round stays.
        const Vec3 in(before.x[axis], before.y[axis], before.normal()[axis]);
        const Vec3 out(after.x[axis], after.y[axis], after.normal()[axis]);
        QVERIFY(isAt(in, out));
    }
    const double size = desk.one().scale;
    const Vec2 box = desk.look().box(GizmoPart::ScaleAll), middle = desk.look().centre();
    desk.drag({box, middle + 1.5 * (box - middle)});
    QVERIFY(std::abs(desk.one().scale / size - 1.5) < 0.02);
}

void TestTemplateTool::everyDragIsOneStepThatIsTakenBack_data()
{
    QTest::addColumn<bool>("isMesh");
    QTest::addColumn<bool>("snaps");
    for (const bool isMesh : {false, true})
        for (const bool snaps : {false, true})
            QTest::addRow("%s%s", isMesh ? "mesh" : "picture", snaps ? ", snapping" : "")
                << isMesh << snaps;
}

void TestTemplateTool::everyDragIsOneStepThatIsTakenBack()
{
    QFETCH(const bool, isMesh);
    QFETCH(const bool, snaps);
    TemplateDesk desk(isMesh ? ballTemplate() : pictureTemplate(discPicture()));
    desk.interaction.settings().snaps = snaps;
    desk.look(0.4, 0.3);
    desk.hold();
    const Document before = desk.session.committed().document;
    const Template first = desk.one();
    const std::vector<GizmoPart> parts = desk.gizmo().parts;
    const int begun = desk.steps();
    int done = 0;
    for (const GizmoPart part : parts) {
        const GizmoLook look = desk.look();
        if (!look.isSeen(part))
            continue;
        const Vec2 at = isTurn(part)                  ? desk.onRing(axisOf(part))
                        : isScale(part)               ? look.box(part)
                        : part == GizmoPart::MoveFree ? look.centre()
                                                      : look.tip(axisOf(part));
        if (look.partAt(at, 10.0) != part)
            continue;
        const Template was = desk.one();
        desk.moveTo(at);
        desk.press(at);
        // Away from the middle, so that a box scales and no ring is pulled across.
        const Vec2 way = (at - look.centre()).norm() > 1.0
                             ? Vec2(25.0 * (at - look.centre()).normalized() + Vec2(9, 14))
                             : Vec2(31, -22);
        desk.moveTo(at + way);
        QVERIFY(desk.session.hasPreview());
        const Template shown = desk.shown();
        desk.release(at + way);
        QCOMPARE(desk.steps(), begun + ++done);
        QVERIFY(desk.one() == shown); // what is kept is what was seen
        QVERIFY(!(desk.one() == was));
        QVERIFY(desk.marks()); // it stays in the hand
        QVERIFY(isAt(desk.gizmo().frame.origin, desk.one().frame.origin));
    }
    QVERIFY(done >= 5);
    for (int i = 0; i < done; ++i)
        desk.session.history()->undo();
    QVERIFY(desk.session.committed().document.isSame(before));
    QVERIFY(desk.one() == first);
}

// Wrong: what was turned a little by hand could not be put straight by hand.
void TestTemplateTool::turnedItIsDrawnUprightAgain()
{
    TemplateDesk desk(pictureTemplate(discPicture()));
    desk.run("template.set", {{"turn", "7.3"}});
    desk.interaction.settings().snaps = true;
    desk.hold();
    const GizmoLook look = desk.look();
    const Vec2 centre = look.centre(), at = desk.onRing(2);
    const double angle = std::atan2(at.y() - centre.y(), at.x() - centre.x());
    const double radius = (at - centre).norm(), back = radians(7.3 - 0.8); // clockwise, y down
    desk.drag({at, centre + radius * Vec2(std::cos(angle + back), std::sin(angle + back))});
    QVERIFY2(isAt(desk.one().frame.x, Vec3::UnitX(), 1e-12),
             qPrintable(QString::number(degrees(turnOf(desk.one().frame)))));
}

void TestTemplateTool::movedItComesLevelWithSections()
{
    TemplateDesk desk(pictureTemplate(discPicture(100), 0.5)); // 50 × 50 mm
    desk.interaction.settings().snaps = true;
    desk.hold();
    // The section's right edge is at 30, the picture's at 25: 5 to go, pulled to 4.
    const Vec2 at = desk.look().tip(0);
    desk.drag({at, at + Vec2(4.0 / 0.4, 0.0)});
    QVERIFY2(isAt(desk.one().frame.origin, {5.0, desk.one().frame.origin.y(), 0.0}),
             qPrintable(QString::number(desk.one().frame.origin.x())));
}

void TestTemplateTool::numbersAreShownAndDone()
{
    TemplateDesk desk(pictureTemplate(discPicture()));
    desk.hold();
    const Vec3 before = desk.one().frame.origin;
    using Kind = ToolNumber::Kind;
    const auto numbers = desk.interaction.numbers();
    QCOMPARE(numbers.size(), std::size_t(5)); // three ways, a turn, a size; no copies
    desk.interaction.setNumbers({{Kind::MoveRight, 12.5}, {Kind::Size, 2.0}}, desk.time);
    QVERIFY(isAt(desk.shown().frame.origin, before + Vec3(12.5, 0, 0)));
    QCOMPARE(desk.shown().scale, 1.0);
    QVERIFY(isAt(desk.gizmo().frame.origin, before + Vec3(12.5, 0, 0)));
    QVERIFY(desk.interaction.key(ToolKey::Enter, desk.time));
    QCOMPARE(desk.one().scale, 1.0);
    QCOMPARE(desk.lastStep(), QStringLiteral("Scale template Disc"));
    desk.interaction.setNumbers({{Kind::Turn, radians(90.0)}}, desk.time);
    desk.interaction.escape(desk.time);
    QVERIFY(!desk.session.hasPreview());
    QVERIFY(desk.interaction.tool());
    QVERIFY(isAt(desk.one().frame.x, Vec3::UnitX()));
    desk.interaction.setNumbers({{Kind::Turn, radians(90.0)}}, desk.time);
    QVERIFY(desk.interaction.key(ToolKey::Enter, desk.time));
    QCOMPARE(desk.lastStep(), QStringLiteral("Turn template Disc"));
    QVERIFY(isAt(desk.one().frame.x, Vec3::UnitY(), 1e-12));
}

void TestTemplateTool::escTakesADragBack()
{
    TemplateDesk desk(pictureTemplate(discPicture()));
    desk.hold();
    const Document before = desk.session.committed().document;
    const Vec2 at = desk.look().tip(1);
    desk.moveTo(at);
    desk.press(at);
    desk.moveTo(at + Vec2(0, -60));
    QVERIFY(desk.session.hasPreview());
    QCOMPARE(desk.hint(), hints::kTemplateInHand);
    desk.interaction.escape(desk.time += 8.0);
    desk.release(at + Vec2(0, -60));
    QVERIFY(desk.session.committed().document.isSame(before));
    QVERIFY(desk.interaction.tool());
    desk.interaction.escape(desk.time += 8.0);
    QVERIFY(!desk.interaction.tool());
}

void TestTemplateTool::lockedOrHiddenItHasNone()
{
    TemplateDesk desk(pictureTemplate(discPicture()));
    desk.change([](Template &one) { one.isLocked = true; });
    desk.hold();
    QVERIFY(!desk.interaction.tool());
    QCOMPARE(desk.hint(), hints::kTemplateLocked);
    QVERIFY(desk.interaction.hint().isRefusal);
    desk.change([](Template &one) { one.isLocked = false; });
    desk.hold();
    QVERIFY(desk.interaction.tool());
    desk.change([](Template &one) { one.isHidden = true; });
    QVERIFY(!desk.interaction.tool());
}

void TestTemplateTool::aClickBesideEndsIt()
{
    TemplateDesk desk(pictureTemplate(discPicture()));
    desk.hold();
    desk.click(desk.look().tip(0)); // on it
    QVERIFY(desk.interaction.tool());
    desk.click(desk.screen({-25, 20, -200})); // on the section behind
    QVERIFY(!desk.interaction.tool());
    QCOMPARE(desk.interaction.selection().size(), std::size_t(1)); // and it did what it does
}

// Wrong: whoever goes on drawing would first have to find out how to be rid of the handles.
void TestTemplateTool::aStrokeEndsIt()
{
    TemplateDesk desk(pictureTemplate(discPicture()));
    desk.hold();
    desk.interaction.setNumbers({{ToolNumber::Kind::MoveRight, 10.0}}, desk.time);
    const Vec2 inside = desk.screen({-29.5, 3, -200});
    desk.moveTo(inside);
    desk.press(inside);
    desk.moveTo(inside + Vec2(0, 12));
    QVERIFY(!desk.interaction.tool());
    QVERIFY(!desk.session.hasPreview());
    QVERIFY(desk.interaction.hasGesture());
    desk.interaction.escape(desk.time += 8.0);
}

void TestTemplateTool::theViewTurnsUnderIt()
{
    TemplateDesk desk(pictureTemplate(discPicture()));
    desk.hold();
    const Camera before = desk.interaction.camera();
    desk.drag({{60, 700}, {160, 640}});
    QVERIFY(!isSameCamera(desk.interaction.camera(), before));
    QVERIFY(desk.interaction.tool());
    QVERIFY(desk.marks());
}

void TestTemplateTool::goneItIsLetGo()
{
    TemplateDesk desk(pictureTemplate(discPicture()));
    desk.hold();
    desk.run("template.remove");
    QVERIFY(!desk.interaction.tool());
    desk.session.history()->undo();
    desk.hold();
    QVERIFY(desk.interaction.tool());
}

// What is moved there and back, turned and scaled by any amounts, is where it was.
void TestTemplateTool::movedThroughAnyPlaces()
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    TemplateDesk desk(pictureTemplate(discPicture()));
    const Model &model = desk.session.committed();
    for (int i = 0; i < 300; ++i) {
        Template one = desk.one();
        one.frame.origin = 500.0 * Vec3(number(random), number(random), number(random));
        const Vec3 axis = Vec3(number(random), number(random), number(random)).normalized();
        Similarity by = Similarity::turned(
            Eigen::AngleAxisd(3.0 * number(random), axis).toRotationMatrix(), one.frame.origin);
        by.scale = std::exp(2.0 * number(random));
        by.shift = one.frame.origin - by.scale * (by.turn * one.frame.origin) +
                   100.0 * Vec3(number(random), number(random), number(random));
        const Template there = movedBy(one, by, model).value();
        for (const Vec3 &p : {Vec3(0, 0, 0), Vec3(50, -30, 0), Vec3(-7, 90, 0)})
            QVERIFY(isAt(there.placement()(p), by(one.placement()(p)), 1e-7));
        QVERIFY(std::abs(there.frame.x.dot(there.frame.y)) < 1e-14);
        const Template back = movedBy(there, by.inverse(), model).value();
        QVERIFY(isAt(back.frame.origin, one.frame.origin, 1e-8));
        QVERIFY(isAt(back.frame.x, one.frame.x, 1e-12));
        QVERIFY(std::abs(back.scale / one.scale - 1.0) < 1e-12);
    }
}

void TestTemplateTool::beyondAllLimitsIsRefused()
{
    TemplateDesk desk(pictureTemplate(discPicture()));
    desk.hold();
    const Document before = desk.session.committed().document;
    desk.interaction.setNumbers({{ToolNumber::Kind::MoveRight, 2.0 * kMaxCoordinate}}, desk.time);
    QCOMPARE(desk.hint(), hints::kTemplateNotMoved);
    desk.interaction.key(ToolKey::Enter, desk.time);
    QVERIFY(desk.session.committed().document.isSame(before));
    QVERIFY(!movedBy(desk.one(), Similarity::scaled(1e7, Vec3::Zero()), desk.session.committed()));
}

FFF_TEST(TestTemplateTool)
#include "tst_template_tool.moc"
