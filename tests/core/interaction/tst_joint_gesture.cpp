#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/assembly/joint_words.h"
#include "core/interaction/hover_words.h"
#include "core/interaction/joint_gesture.h"
#include "core/session/replay.h"
#include "core/session/session_commands.h"
#include "tests/core/interaction/desk.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;
using Type = PointerEvent::Type;

namespace {

/// A person at two plates of 100 × 60 mm, Body and Head, that stand across each other and meet at
/// half their height. Seen a little from the side and above, so that both are seen.
class JointDesk : public Desk
{
public:
    JointDesk()
    {
        const ShapePointer plate = polygonShape(rectangle(-50, 0, 50, 60));
        Document document =
            withSection(withSection(newDocument(), plate, test::front()), plate, test::side());
        document = *renameSection(document, document.sections[0]->id, "Body");
        document = *renameSection(document, document.sections[1]->id, "Head");
        session.reset(document);
        Camera camera;
        camera.target = {0, 30, 0};
        camera.millimetresPerPixel = 0.2;
        orientationOfView("iso1", camera.orientation);
        interaction.setCamera(camera);
        interaction.select({body()});
    }

    SectionRef body() const { return session.committed().ref(0); }
    SectionRef head() const { return session.committed().ref(1); }
    JointRef joint() const { return {body(), head()}; }
    const Document &document() const { return session.committed().document; }
    /// On the axis, so high above the ground.
    Vec2 at(double height) const { return screen({0, height, 0}); }
    JointState state() const { return *jointState(session.committed(), joint()); }
    double share() const { return *state().shares[0]; }
    const sign::Joints *marks() const { return interaction.overlay().find<sign::Joints>(); }
};

} // namespace

class TestJointGesture : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hoverSaysWhatADragWouldDo();
    void nothingIsInTheWayOfStrokes();
    void aClickSelectsTheJoint();
    void aDragMovesTheMeetingPoint_data();
    void aDragMovesTheMeetingPoint();
    void arrowKeysMoveIt();
    void escapeLeavesNoTrace();
    void undoBringsBackTheVeryObjects();
    void fingersReachFarther();
    void hiddenOnesHaveNoMark();
    void aJointThatGoesComesBack();
    void anEditElsewhereKeepsIt();
    void whatCannotBeMovedSaysSo();
    void deleteSaysWhyNot();
    void fitFramesIt();
    void commandsDoTheSame();
    void aScriptDoesTheSame();
};

// Wrong: one finds out by trying.
void TestJointGesture::hoverSaysWhatADragWouldDo()
{
    JointDesk desk;
    QVERIFY(!desk.marks()); // a model is full of joints
    desk.interaction.setListsJoints(true);
    QVERIFY(desk.marks());
    QCOMPARE(desk.marks()->marks.size(), std::size_t(1));
    QCOMPARE(desk.marks()->hovered, -1);
    QVERIFY(desk.marks()->lit.empty());
    desk.interaction.setListsJoints(false);
    QVERIFY(!desk.marks());
    desk.send(Type::Move, desk.screen({30, 10, 0})); // on Body, which is selected
    QVERIFY(desk.marks());
    desk.send(Type::Move, Vec2(5, 5));
    QVERIFY(!desk.marks());
    desk.send(Type::Move, desk.at(30) + Vec2(6, 0));
    QCOMPARE(desk.hint(), hints::kMoveMeetingPoint);
    QCOMPARE(nameIn(desk.interaction.hint(), 2), std::string("Body"));
    QCOMPARE(nameIn(desk.interaction.hint()), std::string("Head"));
    QCOMPARE(desk.interaction.cursor(), Cursor::Hand);
    QCOMPARE(desk.marks()->hovered, 0);
    QCOMPARE(desk.marks()->lit.size(), std::size_t(1));
    QCOMPARE(desk.marks()->lit.front().slits.size(), std::size_t(2));
    QCOMPARE(desk.interaction.hovered().section, -1);
    QVERIFY(desk.marks()->lit.front().opens.y() < -0.99); // Head's slit opens down
    desk.interaction.setListsJoints(true);
    desk.send(Type::Move, desk.at(30) + Vec2(14, 0));
    QVERIFY(desk.hint() != hints::kMoveMeetingPoint);
    QCOMPARE(desk.marks()->hovered, -1);
}

// Wrong: a stroke that begins in the middle of a section drags a slit.
void TestJointGesture::nothingIsInTheWayOfStrokes()
{
    JointDesk desk;
    desk.interaction.select({});
    QVERIFY(!desk.marks());
    desk.send(Type::Move, desk.at(30));
    QCOMPARE(desk.hint(), hints::kDragOutOfSection);
    desk.press(desk.at(30));
    desk.moveTo(desk.at(45));
    QVERIFY(desk.interaction.overlay().find<sign::Slit>());
    desk.interaction.escape(desk.time);
    // Many sections are no place for marks.
    std::vector<SectionRef> all;
    for (int i = 0; i < 6; ++i)
        desk.addPlate(30.0 + i, {10, 10});
    for (std::size_t i = 0; i < desk.session.committed().sectionCount(); ++i)
        all.push_back(desk.session.committed().ref(i));
    desk.interaction.select(all);
    QVERIFY(!desk.marks());
}

void TestJointGesture::aClickSelectsTheJoint()
{
    JointDesk desk;
    desk.click(desk.at(30));
    QVERIFY(desk.interaction.selectedJoint() == desk.joint());
    QVERIFY(desk.interaction.selection().empty());
    QCOMPARE(desk.steps(), 0);
    QCOMPARE(desk.marks()->lit.size(), std::size_t(1)); // also when the cursor is elsewhere:
    desk.moveTo(Vec2(5, 5));
    QCOMPARE(desk.marks()->lit.size(), std::size_t(1));
    QCOMPARE(desk.marks()->marks.size(), std::size_t(1));
    // Its slits are seen by now, and taken hold of as well.
    desk.send(Type::Move, desk.at(50));
    QCOMPARE(desk.hint(), hints::kMoveSelectedMeetingPoint);
    desk.drag({desk.at(50), desk.at(56)});
    QVERIFY(std::abs(desk.share() - 0.4) < 1e-9);
    desk.session.history()->undo();
    desk.send(Type::Move, desk.screen({30, 50, 0}));
    QVERIFY(desk.hint() != hints::kMoveMeetingPoint);
    // A step back is the section that it was chosen from, and then nothing.
    QVERIFY(desk.interaction.escape(desk.time));
    QVERIFY(!desk.interaction.selectedJoint());
    QCOMPARE(desk.interaction.selection(), std::vector{desk.body()});
    QVERIFY(desk.interaction.escape(desk.time));
    QVERIFY(desk.interaction.selection().empty());
    // Another section is another choice.
    desk.interaction.selectJoint(desk.joint());
    desk.click(desk.screen({40, 10, 0}));
    QVERIFY(!desk.interaction.selectedJoint());
    QCOMPARE(desk.interaction.selection(), std::vector{desk.body()});
}

void TestJointGesture::aDragMovesTheMeetingPoint_data()
{
    QTest::addColumn<QString>("view");
    QTest::addColumn<double>("height");
    QTest::addColumn<double>("share"); // of Body's slit, which opens up
    QTest::newRow("up") << "iso1" << 45.0 << 0.25;
    QTest::newRow("down") << "iso1" << 12.0 << 0.80;
    QTest::newRow("from the front") << "front" << 24.0 << 0.60;
    QTest::newRow("from behind") << "iso3" << 33.0 << 0.45;
    QTest::newRow("whole percents") << "iso1" << 44.9 << 0.25;
    QTest::newRow("not beyond the end") << "iso1" << 90.0 << 0.05;
    QTest::newRow("not below the start") << "iso1" << -20.0 << 0.95;
}

// Wrong: the meeting point is not under the cursor, or not what is committed.
void TestJointGesture::aDragMovesTheMeetingPoint()
{
    QFETCH(QString, view);
    QFETCH(double, height);
    QFETCH(double, share);
    for (const Projection projection : {Projection::Orthographic, Projection::Perspective}) {
        JointDesk desk;
        Camera camera = desk.interaction.camera();
        orientationOfView(view.toStdString(), camera.orientation);
        camera.projection = projection;
        desk.interaction.setCamera(camera);
        // Held a little beside its middle, it does not jump.
        const Vec2 off(3, 0);
        desk.moveTo(desk.at(30) + off);
        desk.press(desk.at(30) + off);
        desk.moveTo(desk.at(height) + off);
        QVERIFY(desk.session.hasPreview());
        QCOMPARE(desk.hint(), hints::kMovingMeetingPoint);
        QCOMPARE(desk.steps(), 0);
        const Document shown = desk.session.model().document;
        QVERIFY(std::abs(desk.marks()->lit.front().meetingPoints.front().y() -
                         60.0 * (1.0 - share)) < 1e-6);
        desk.release(desk.at(height) + off);
        QCOMPARE(desk.steps(), 1);
        QVERIFY(desk.document() == shown);
        QVERIFY(std::abs(desk.share() - share) < 1e-9);
        QCOMPARE(desk.lastStep(), QStringLiteral("Body · Head: meeting point → %1\u202f%")
                                      .arg(std::lround(100.0 * (1.0 - share))));
        QCOMPARE(desk.interaction.selection(), std::vector{desk.body()}); // a drag selects nothing
    }
}

void TestJointGesture::escapeLeavesNoTrace()
{
    JointDesk desk;
    const Document before = desk.document();
    desk.press(desk.at(30));
    desk.moveTo(desk.at(50));
    QVERIFY(desk.session.hasPreview());
    QVERIFY(desk.interaction.escape(desk.time));
    QVERIFY(!desk.session.hasPreview());
    desk.release(desk.at(50));
    QVERIFY(desk.document().isSame(before));
    QCOMPARE(desk.steps(), 0);
    QVERIFY(std::abs(desk.marks()->marks.front().at.y() - 30.0) < 1e-9);
    // Back to where it was is no step either.
    desk.drag({desk.at(30), desk.at(50), desk.at(30)});
    QCOMPARE(desk.steps(), 0);
}

void TestJointGesture::undoBringsBackTheVeryObjects()
{
    JointDesk desk;
    const Document before = desk.document();
    desk.drag({desk.at(30), desk.at(45)});
    const Document after = desk.document();
    desk.session.history()->undo();
    QVERIFY(desk.document().isSame(before));
    desk.session.history()->redo();
    QVERIFY(desk.document().isSame(after));
    QVERIFY(std::abs(desk.share() - 0.25) < 1e-9);
}

void TestJointGesture::fingersReachFarther()
{
    JointDesk desk;
    const auto hintOf = [&desk](Pointer pointer, double off) {
        PointerEvent event;
        event.position = desk.at(30) + Vec2(off, 0);
        event.pointer = pointer;
        event.time = desk.time += 8.0;
        desk.interaction.handle(event);
        return desk.hint();
    };
    QCOMPARE(hintOf(Pointer::Mouse, 9.5), hints::kMoveMeetingPoint);
    QVERIFY(hintOf(Pointer::Mouse, 10.5) != hints::kMoveMeetingPoint);
    QCOMPARE(hintOf(Pointer::Pen, 13.5), hints::kMoveMeetingPoint);
    QVERIFY(hintOf(Pointer::Pen, 14.5) != hints::kMoveMeetingPoint);
    QCOMPARE(hintOf(Pointer::Finger, 21.5), hints::kMoveMeetingPoint);
}

void TestJointGesture::hiddenOnesHaveNoMark()
{
    JointDesk desk;
    ViewState view = desk.interaction.view();
    view.hidden.insert(desk.head());
    desk.interaction.setView(view);
    QVERIFY(!desk.marks());
    desk.send(Type::Move, desk.at(30));
    QVERIFY(desk.hint() != hints::kMoveMeetingPoint);
}

// Wrong: the panel is of a joint that is none, or Undo leaves one with nothing selected.
void TestJointGesture::aJointThatGoesComesBack()
{
    JointDesk desk;
    desk.click(desk.at(30));
    const Document apart =
        *moveSection(desk.document(), desk.document().sections[1]->id, side(200));
    desk.session.commit(QStringLiteral("Move"), apart);
    QVERIFY(!desk.interaction.selectedJoint());
    QCOMPARE(desk.interaction.selection(), std::vector{desk.body()});
    desk.session.history()->undo();
    QVERIFY(desk.interaction.selectedJoint() == desk.joint());
    QVERIFY(desk.interaction.selection().empty());
    // Not when something else was chosen meanwhile.
    desk.session.history()->redo();
    desk.interaction.select({desk.head()});
    desk.session.history()->undo();
    QVERIFY(!desk.interaction.selectedJoint());
    // A section that is deleted takes the joint with it; the other one is left.
    desk.interaction.select({desk.body()});
    desk.interaction.selectJoint(desk.joint());
    const SectionRef head = desk.head();
    desk.session.commit(
        QStringLiteral("Delete"),
        *removeSections(desk.document(), std::vector{desk.document().sections[0]->id}));
    QCOMPARE(desk.interaction.selection(), std::vector{head});
    desk.session.history()->undo();
    QVERIFY(desk.interaction.selectedJoint() == desk.joint());
}

// Wrong: what was set is lost with the next stroke.
void TestJointGesture::anEditElsewhereKeepsIt()
{
    JointDesk desk;
    desk.drag({desk.at(30), desk.at(45)});
    desk.click(desk.at(45));
    QVERIFY(desk.interaction.selectedJoint() == desk.joint());
    desk.addPlate(200);
    QVERIFY(desk.interaction.selectedJoint() == desk.joint());
    QVERIFY(std::abs(desk.share() - 0.25) < 1e-9);
    // Higher by half: the share is of what they share now.
    desk.session.commit(QStringLiteral("Redraw"),
                        *setShape(desk.document(), desk.document().sections[0]->id,
                                  polygonShape(rectangle(-50, 0, 50, 40))));
    QVERIFY(desk.interaction.selectedJoint() == desk.joint());
    QVERIFY(std::abs(desk.share() - 0.25) < 1e-9);
    QVERIFY(std::abs(desk.state().meetingPoint(0).y() - 30.0) < 1e-9);
}

void TestJointGesture::whatCannotBeMovedSaysSo()
{
    JointDesk desk;
    desk.interaction.selectJoint(desk.joint());
    desk.run("joint.kind", {{"kind", "none"}});
    QCOMPARE(desk.state().kind, JointKind::None);
    QVERIFY(desk.marks()->marks.front().isProblem);
    desk.send(Type::Move, desk.at(30));
    QCOMPARE(desk.hint(), hints::kSelectJoint);
    const Document before = desk.document();
    desk.drag({desk.at(30), desk.at(50)});
    QCOMPARE(desk.hint(), hints::kNoMeetingPoint);
    QVERIFY(desk.interaction.hint().isRefusal);
    QVERIFY(desk.document().isSame(before));
    desk.run("joint.flip");
    QCOMPARE(desk.hint(), hints::kJointCannotFlip);
    desk.run("joint.kind", {{"kind", "mortise"}});
    QCOMPARE(desk.hint(), hints::kJointCannotBe);
    QVERIFY(desk.document().isSame(before));
}

// Wrong: what the mouse can do the keys cannot, or twenty presses take twenty undos.
void TestJointGesture::arrowKeysMoveIt()
{
    JointDesk desk;
    desk.interaction.selectJoint(desk.joint());
    const auto height = [&] { return desk.state().meetingPoint(0).y(); };
    QVERIFY(std::abs(height() - 30.0) < 1e-9);
    for (int i = 0; i < 3; ++i)
        desk.run("nudge.up");
    desk.run("nudge.down", {{"distance", "0.1"}});
    QVERIFY(std::abs(height() - 32.9) < 1e-9);
    QCOMPARE(desk.steps(), 1);
    desk.run("nudge.left"); // the axis stands upright
    QVERIFY(std::abs(height() - 32.9) < 1e-9);
    desk.session.history()->undo();
    QVERIFY(std::abs(height() - 30.0) < 1e-9);

    desk.run("joint.flip"); // up is up all the same
    desk.run("nudge.up", {{"distance", "10"}});
    QVERIFY(std::abs(height() - 40.0) < 1e-9);
    desk.run("nudge.up", {{"distance", "100"}}); // as far as a slit still holds
    QVERIFY(std::abs(height() - (60.0 - 60.0 * kLeastShare)) < 1e-9);
    const int steps = desk.steps();
    desk.run("nudge.up");
    QCOMPARE(desk.steps(), steps);
    // Another joint is another step, also of sections that are called the same.
    Document twice =
        withSection(desk.document(), polygonShape(rectangle(-50, 0, 50, 60)), test::side(30));
    twice = *renameSection(twice, twice.sections[2]->id, "Head");
    desk.session.reset(twice);
    for (const std::size_t other : {1, 2}) {
        desk.interaction.selectJoint({desk.body(), desk.session.committed().ref(other)});
        desk.run("nudge.down");
    }
    QCOMPARE(desk.steps(), 2);
    // Seen along the axis an arrow says nothing.
    Camera camera = desk.interaction.camera();
    orientationOfView("top", camera.orientation);
    desk.interaction.setCamera(camera);
    desk.run("nudge.down");
    QCOMPARE(desk.steps(), 2);
}

void TestJointGesture::deleteSaysWhyNot()
{
    JointDesk desk;
    desk.interaction.selectJoint(desk.joint());
    QVERIFY(desk.commands.isEnabled("edit.delete"));
    desk.run("edit.delete");
    QCOMPARE(desk.hint(), hints::kJointNotDeleted);
    QCOMPARE(desk.sections().size(), std::size_t(2));
    QVERIFY(desk.interaction.selectedJoint().has_value());
}

void TestJointGesture::fitFramesIt()
{
    JointDesk desk;
    desk.interaction.selectJoint(desk.joint());
    desk.run("view.fitSelection");
    desk.wait(1000.0);
    for (const double height : {0.0, 60.0}) {
        const Vec2 at = desk.at(height);
        QVERIFY(at.x() > 0 && at.y() > 0 && at.x() < kViewport.x() && at.y() < kViewport.y());
    }
    QVERIFY((desk.at(60) - desk.at(0)).norm() > 0.2 * kViewport.y());
}

void TestJointGesture::commandsDoTheSame()
{
    JointDesk desk;
    const Document before = desk.document();
    QVERIFY(!desk.commands.isEnabled("joint.flip")); // a section is selected
    desk.run("joint.select", {{"a", "Head"}, {"b", "Body"}});
    QVERIFY(desk.interaction.selectedJoint() == desk.joint());
    QVERIFY(!desk.commands.isEnabled("joint.reset"));
    const int sign = desk.state().sign;
    desk.run("joint.flip");
    QCOMPARE(desk.state().sign, -sign);
    QCOMPARE(desk.lastStep(), QStringLiteral("Body · Head: flip the slits"));
    desk.run("joint.share", {{"percent", "70"}});
    QVERIFY(std::abs(1.0 - desk.share() - 0.7) < 1e-12);
    QVERIFY(desk.commands.isEnabled("joint.reset"));
    desk.run("joint.reset");
    QVERIFY(desk.document().jointOverrides.empty());
    QCOMPARE(desk.lastStep(), QStringLiteral("Body · Head: restore automatic settings"));
    desk.run("joint.kind", {{"kind", "none"}});
    QCOMPARE(desk.lastStep(), QStringLiteral("Body · Head: kind → none"));
    desk.run("joint.kind", {{"kind", "crossLap"}});
    QCOMPARE(desk.steps(), 5);
    for (int i = 0; i < 5; ++i)
        desk.run("edit.undo");
    QVERIFY(desk.document().isSame(before));
    for (const CommandParameters &wrong :
         {CommandParameters{{"a", "Tail"}, {"b", "Body"}}, {{"a", "Body"}, {"b", "Body"}}})
        QVERIFY(!desk.commands.run("joint.select", wrong));
    QVERIFY(!desk.commands.run("joint.share", {{"percent", "99"}}));
    QVERIFY(!desk.commands.run("joint.kind", {{"kind", "glue"}}));
}

void TestJointGesture::aScriptDoesTheSame()
{
    JointDesk desk;
    const QByteArray script = R"({"viewport": [1280, 800], "events": [
        {"type": "command", "name": "joint.select", "parameters": {"a": "Body", "b": "Head"}},
        {"type": "command", "name": "joint.flip"},
        {"type": "command", "name": "joint.share", "parameters": {"percent": 30}}]})";
    const auto played = replay(script, desk.session, desk.interaction);
    QVERIFY(played.has_value());
    QVERIFY(std::abs(1.0 - desk.share() - 0.3) < 1e-12);
    QCOMPARE(desk.document().jointOverrides.size(), std::size_t(1));
}

FFF_TEST(TestJointGesture)
#include "tst_joint_gesture.moc"
