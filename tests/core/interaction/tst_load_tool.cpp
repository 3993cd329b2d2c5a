// Weights that are hung on sections with the cursor, and by commands.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/interaction/load_marks.h"
#include "core/interaction/load_tool.h"
#include "core/interaction/load_words.h"
#include "core/model/edits.h"
#include "core/model/load_edits.h"
#include "core/model/operation_edits.h"
#include "core/operations/operation_kind.h"
#include "tests/core/interaction/desk.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;

namespace {

/// A plate of 200 x 120 mm and the tool that hangs weights on it.
struct WeightDesk : Desk
{
    WeightDesk()
    {
        addPlate();
        run("physics.addWeight");
    }
    const std::vector<Load> &weights() const { return session.committed().document.loads; }
};

} // namespace

class TestLoadTool : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aClickHangsOne();
    void whatIsHungIsSelected();
    void stressGoesWithIt();
    void aDragMovesIt();
    void overNothingItStays();
    void escPutsItBack();
    void lockedSectionsKeepTheirs();
    void byCommands();
    void aDragPushes();
    void aClickPushesInto();
    void aPullLeavesNothing();
    void withoutToolItIsDragged();
    void tipTurnsThePush();
    void onACopyItMovesItsSource();
    void lockedOnesStayWithoutTool();
    void wrongMasses();
};

// Wrong: it hangs elsewhere, or what was done cannot be undone in one step.
void TestLoadTool::aClickHangsOne()
{
    WeightDesk desk;
    QVERIFY(desk.interaction.view().showsStress);
    const Document before = desk.session.committed().document;
    desk.click(desk.plate(40, 25));
    QCOMPARE(desk.weights().size(), std::size_t(1));
    QVERIFY((desk.weights()[0].position - Vec2(40, 25)).norm() < 1e-6);
    QCOMPARE(desk.weights()[0].mass, 0.35);
    QVERIFY(desk.interaction.tool()); // for the next one
    desk.run("edit.undo");
    QVERIFY(desk.session.committed().document == before);
}

// Wrong: its number is wanted, and the fields are of something else.
void TestLoadTool::whatIsHungIsSelected()
{
    WeightDesk desk;
    desk.click(desk.plate(40, 25));
    QCOMPARE(desk.interaction.selectedLoad(), desk.weights()[0].id);
    desk.click(desk.plate(-40, -25));
    QCOMPARE(desk.interaction.selectedLoad(), desk.weights()[1].id);
    desk.click(desk.plate(40, 25)); // the first one again
    QCOMPARE(desk.weights().size(), std::size_t(2));
    QCOMPARE(desk.interaction.selectedLoad(), desk.weights()[0].id);
    QVERIFY(desk.interaction.tool());
}

// Wrong: arrows and numbers over whatever is done after it; or lines that somebody wants go, too.
void TestLoadTool::stressGoesWithIt()
{
    WeightDesk desk;
    desk.click(desk.plate(40, 25));
    QVERIFY(desk.interaction.view().showsStress);
    desk.run("measure.ruler"); // in its place
    QVERIFY(!desk.interaction.view().showsStress);
    desk.run("physics.addPush");
    desk.run("physics.addWeight");
    QVERIFY(desk.interaction.view().showsStress);
    desk.interaction.escape(desk.time);
    QVERIFY(!desk.interaction.tool());
    QVERIFY(!desk.interaction.view().showsStress);

    desk.run("check.stress");
    desk.run("physics.addWeight");
    desk.interaction.escape(desk.time);
    QVERIFY(desk.interaction.view().showsStress); // they were on before

    desk.run("check.stress");
    desk.run("physics.addWeight");
    desk.run("check.stress");
    QVERIFY(!desk.interaction.view().showsStress);
    desk.moveTo(desk.plate(40, 25));
    desk.run("check.stress");
    desk.interaction.escape(desk.time);
    QVERIFY(desk.interaction.view().showsStress); // somebody asked for them
}

// Wrong: a second weight in place of the first one elsewhere.
void TestLoadTool::aDragMovesIt()
{
    WeightDesk desk;
    desk.click(desk.plate(40, 25));
    const LoadId id = desk.weights()[0].id;
    // It keeps to where it was taken hold of.
    const Vec2 grip(3, -2);
    desk.drag({desk.plate(40, 25) + grip, desk.plate(0, 0), desk.plate(-50, -20) + grip});
    QCOMPARE(desk.weights().size(), std::size_t(1));
    QCOMPARE(desk.weights()[0].id, id);
    QVERIFY((desk.weights()[0].position - Vec2(-50, -20)).norm() < 1e-6);
    desk.run("edit.undo");
    QVERIFY((desk.weights()[0].position - Vec2(40, 25)).norm() < 1e-6);
}

// Wrong: it is lost beside the model.
void TestLoadTool::overNothingItStays()
{
    WeightDesk desk;
    desk.click(desk.plate(40, 25));
    desk.drag({desk.plate(40, 25), desk.plate(90, 50), desk.plate(140, 90)});
    QCOMPARE(desk.weights().size(), std::size_t(1));
    const Vec2 at = desk.weights()[0].position;
    QVERIFY(at.x() >= 90.0 - 1e-6 && at.x() <= 100.0 + 1e-6 && at.y() <= 60.0 + 1e-6);
}

void TestLoadTool::escPutsItBack()
{
    WeightDesk desk;
    desk.click(desk.plate(40, 25));
    desk.press(desk.plate(40, 25));
    desk.moveTo(desk.plate(-60, 0));
    desk.interaction.escape(desk.time);
    desk.release(desk.plate(-60, 0));
    QVERIFY((desk.weights()[0].position - Vec2(40, 25)).norm() < 1e-6);
    desk.interaction.escape(desk.time);
    desk.interaction.escape(desk.time);
    QVERIFY(!desk.interaction.tool());
}

// Wrong: what a person wants to stay as it is changes.
void TestLoadTool::lockedSectionsKeepTheirs()
{
    WeightDesk desk;
    desk.click(desk.plate(40, 25));
    Document document = desk.session.committed().document;
    Section locked = *document.sections[0];
    locked.isLocked = true;
    document.sections[0] = std::make_shared<const Section>(locked);
    desk.session.commit(QStringLiteral("Lock"), document);
    desk.run("physics.addWeight");
    if (!desk.interaction.tool())
        desk.run("physics.addWeight");
    desk.click(desk.plate(-40, 0));
    desk.drag({desk.plate(40, 25), desk.plate(0, 0)});
    QVERIFY(desk.session.committed().document == document);
}

// Wrong: a script cannot do what a person can, or does it elsewhere.
void TestLoadTool::byCommands()
{
    WeightDesk desk;
    const std::string name = desk.session.committed().section(0)->name;
    QVERIFY(desk.commands.run("physics.addWeight",
                              {{"section", name}, {"mass", "1.5"}, {"x", "10"}, {"y", "-20"}}));
    QCOMPARE(desk.weights().size(), std::size_t(1));
    QCOMPARE(desk.weights()[0].mass, 1.5);
    QCOMPARE(desk.weights()[0].position, Vec2(10, -20));
    QVERIFY(desk.commands.run("physics.setLoad", {{"load", "0"}, {"mass", "0.2"}}));
    QCOMPARE(desk.weights()[0].mass, 0.2);
    QVERIFY(desk.commands.run("physics.removeLoad", {{"load", "0"}}));
    QVERIFY(desk.weights().empty());
    QVERIFY(!desk.commands.run("physics.addWeight", {{"section", "Nobody"}}));
}

// Wrong: a mass that no balance can be found for.
void TestLoadTool::wrongMasses()
{
    WeightDesk desk;
    desk.click(desk.plate(40, 25));
    const Document document = desk.session.committed().document;
    for (const char *mass : {"0", "-1", "2e6", "nan", "inf", "much"})
        QVERIFY(!desk.commands.run("physics.setLoad", {{"load", "0"}, {"mass", mass}}));
    QVERIFY(!desk.commands.run("physics.setLoad", {{"load", "7"}, {"mass", "1"}}));
    QVERIFY(desk.session.committed().document == document);
    for (const double mass : {1e-6, kMaxWeight}) {
        Load weight = document.loads[0];
        weight.mass = mass;
        QVERIFY(setLoad(document, weight));
    }
    Load stranger = document.loads[0];
    stranger.id = LoadId{12345};
    QVERIFY(!setLoad(document, stranger));
}

namespace {

/// In the world, N.
Vec3 pushOf(const Desk &desk)
{
    const Model &model = desk.session.committed();
    const Load &load = model.document.loads.front();
    return pushInWorld(load.push, model.find(load.section)->frame);
}

/// A plate seen from the front.
struct FrontDesk : Desk
{
    FrontDesk()
    {
        addPlate();
        run("view.front");
        wait(2000.0);
    }
    const std::vector<Load> &loads() const { return session.committed().document.loads; }
};

} // namespace

// Wrong: it pushes another way than the hand went, or more or less than the arrow says.
void TestLoadTool::aDragPushes()
{
    FrontDesk desk;
    desk.run("physics.addPush");
    const Document before = desk.session.committed().document;
    const Vec2 foot = desk.plate(20, 10);
    desk.drag({foot, foot + Vec2(60, 0), foot + Vec2(88, 66)}); // 110 px
    QCOMPARE(desk.loads().size(), std::size_t(1));
    QVERIFY(desk.loads()[0].isPush());
    QVERIFY((desk.loads()[0].position - Vec2(20, 10)).norm() < 1e-6);
    QVERIFY((pushOf(desk).normalized() - Vec3(0.8, -0.6, 0.0)).norm() < 1e-6);
    QVERIFY(std::abs(pushOf(desk).norm() - forceOfArrow(110.0)) < 1e-9);
    QVERIFY(std::abs(arrowLength(pushOf(desk).norm()) - 110.0) < 2.0);
    desk.run("edit.undo");
    QVERIFY(desk.session.committed().document == before);
    // Nearly along an axis it is along it, unless Ctrl says otherwise.
    desk.drag({foot, foot + Vec2(60, 0), foot + Vec2(80, 3)});
    QCOMPARE(pushOf(desk).normalized(), Vec3(Vec3::UnitX()));
    desk.run("edit.undo");
    desk.drag({foot, foot + Vec2(60, 0), foot + Vec2(80, 3)}, Button::Left, kControl);
    QVERIFY(desk.loads().empty() || pushOf(desk).normalized() != Vec3(Vec3::UnitX()));
}

void TestLoadTool::aClickPushesInto()
{
    FrontDesk desk;
    desk.run("physics.addPush");
    desk.click(desk.plate(0, 0));
    QCOMPARE(desk.loads().size(), std::size_t(1));
    QVERIFY((pushOf(desk) + 5.0 * desk.interaction.camera().backward()).norm() < 1e-9);
    desk.run("edit.undo");
    desk.run("view.back");
    desk.wait(2000.0);
    desk.click(desk.plate(0, 0));
    QVERIFY((pushOf(desk) + 5.0 * desk.interaction.camera().backward()).norm() < 1e-9);
}

void TestLoadTool::aPullLeavesNothing()
{
    FrontDesk desk;
    const int steps = desk.steps();
    desk.run("physics.pull");
    const Vec2 foot = desk.plate(20, 10);
    desk.moveTo(foot);
    desk.press(foot);
    desk.moveTo(foot + Vec2(0, 90));
    QCOMPARE(desk.session.model().document.loads.size(), std::size_t(1));
    desk.release(foot + Vec2(0, 90));
    QVERIFY(desk.session.model().document.loads.empty());
    QCOMPARE(desk.steps(), steps);
    QVERIFY(desk.interaction.tool());
}

// Wrong: a stroke begins on the section, or the weight jumps.
void TestLoadTool::withoutToolItIsDragged()
{
    FrontDesk desk;
    const std::string name = desk.session.committed().section(0)->name;
    desk.run("physics.addWeight", {{"section", name}, {"x", "40"}, {"y", "25"}});
    const int steps = desk.steps();
    desk.drag({desk.plate(40, 25), desk.plate(20, 0), desk.plate(-50, -20)});
    QCOMPARE(desk.sections().size(), std::size_t(1));
    QCOMPARE(desk.steps(), steps + 1);
    QVERIFY((desk.loads()[0].position - Vec2(-50, -20)).norm() < 1e-6);
    desk.run("edit.undo");
    QVERIFY((desk.loads()[0].position - Vec2(40, 25)).norm() < 1e-6);
    desk.moveTo(desk.plate(40, 25));
    desk.press(desk.plate(40, 25));
    desk.moveTo(desk.plate(0, 0));
    desk.interaction.escape(desk.time);
    desk.release(desk.plate(0, 0));
    QVERIFY((desk.loads()[0].position - Vec2(40, 25)).norm() < 1e-6);
}

void TestLoadTool::tipTurnsThePush()
{
    FrontDesk desk;
    const std::string name = desk.session.committed().section(0)->name;
    desk.run("physics.addPush", {{"section", name},
                                 {"x", "0"},
                                 {"y", "0"},
                                 {"force", "5"},
                                 {"dx", "1"},
                                 {"dy", "0"},
                                 {"dz", "0"}});
    const Vec2 foot = desk.plate(0, 0), tip = foot + Vec2(arrowLength(5.0), 0.0);
    desk.drag({tip, foot + Vec2(40, -40), foot + Vec2(0, -100)});
    QCOMPARE(pushOf(desk).normalized(), Vec3(Vec3::UnitY()));
    QVERIFY(std::abs(pushOf(desk).norm() - forceOfArrow(100.0)) < 1e-9);
    QVERIFY((desk.loads()[0].position).norm() < 1e-6);
}

/// Three plates in a row, of which an operation made two.
void TestLoadTool::onACopyItMovesItsSource()
{
    FrontDesk desk;
    const std::string name = desk.session.committed().section(0)->name;
    desk.run("physics.addWeight", {{"section", name}, {"x", "0"}, {"y", "0"}});
    const Section &plate = *desk.sections()[0];
    Operation array = newOperation(*operationKind("array"));
    array.name = "Row";
    array.inputs["sections"].push_back({plate.ref(), {}});
    array.parameters.insert_or_assign("x", 250.0);
    desk.session.commit(QStringLiteral("Row"),
                        addOperation(desk.session.committed().document, array));
    QCOMPARE(placedLoads(desk.session.committed()).size(), std::size_t(3));
    const Vec2 from = desk.front(250.0, kFirstPlaneHeight), to = from + Vec2(20, 10);
    desk.drag({from, from + Vec2(10, 5), to});
    const double scale = desk.interaction.camera().millimetresPerPixel;
    QCOMPARE(desk.loads().size(), std::size_t(1));
    QVERIFY(desk.loads()[0].section == plate.ref());
    QVERIFY((desk.loads()[0].position - scale * Vec2(20, -10)).norm() < 1.0);
}

void TestLoadTool::lockedOnesStayWithoutTool()
{
    FrontDesk desk;
    const std::string name = desk.session.committed().section(0)->name;
    desk.run("physics.addWeight", {{"section", name}, {"x", "40"}, {"y", "25"}});
    desk.click(desk.plate(-60, -30));
    desk.run("section.lock");
    const Document before = desk.session.committed().document;
    desk.drag({desk.plate(40, 25), desk.plate(20, 0), desk.plate(-50, -20)});
    QVERIFY(desk.session.committed().document == before);
}

FFF_TEST(TestLoadTool)
#include "tst_load_tool.moc"
