// Weights that are hung on sections with the cursor, and by commands.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/interaction/weight_tool.h"
#include "core/interaction/weight_words.h"
#include "core/model/edits.h"
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
    const std::vector<Weight> &weights() const { return session.committed().document.weights; }
};

} // namespace

class TestWeightTool : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aClickHangsOne();
    void aDragMovesIt();
    void overNothingItStays();
    void escPutsItBack();
    void lockedSectionsKeepTheirs();
    void byCommands();
    void wrongMasses();
};

// Wrong: it hangs elsewhere, or what was done cannot be undone in one step.
void TestWeightTool::aClickHangsOne()
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

// Wrong: a second weight in place of the first one elsewhere.
void TestWeightTool::aDragMovesIt()
{
    WeightDesk desk;
    desk.click(desk.plate(40, 25));
    const WeightId id = desk.weights()[0].id;
    desk.drag({desk.plate(40, 25) + Vec2(3, -2), desk.plate(0, 0), desk.plate(-50, -20)});
    QCOMPARE(desk.weights().size(), std::size_t(1));
    QCOMPARE(desk.weights()[0].id, id);
    QVERIFY((desk.weights()[0].position - Vec2(-50, -20)).norm() < 1e-6);
    desk.run("edit.undo");
    QVERIFY((desk.weights()[0].position - Vec2(40, 25)).norm() < 1e-6);
}

// Wrong: it is lost beside the model.
void TestWeightTool::overNothingItStays()
{
    WeightDesk desk;
    desk.click(desk.plate(40, 25));
    desk.drag({desk.plate(40, 25), desk.plate(90, 50), desk.plate(140, 90)});
    QCOMPARE(desk.weights().size(), std::size_t(1));
    const Vec2 at = desk.weights()[0].position;
    QVERIFY(at.x() >= 90.0 - 1e-6 && at.x() <= 100.0 + 1e-6 && at.y() <= 60.0 + 1e-6);
}

void TestWeightTool::escPutsItBack()
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
void TestWeightTool::lockedSectionsKeepTheirs()
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
void TestWeightTool::byCommands()
{
    WeightDesk desk;
    const std::string name = desk.session.committed().section(0)->name;
    QVERIFY(desk.commands.run("physics.addWeight",
                              {{"section", name}, {"mass", "1.5"}, {"x", "10"}, {"y", "-20"}}));
    QCOMPARE(desk.weights().size(), std::size_t(1));
    QCOMPARE(desk.weights()[0].mass, 1.5);
    QCOMPARE(desk.weights()[0].position, Vec2(10, -20));
    QVERIFY(desk.commands.run("physics.setWeight", {{"weight", "0"}, {"mass", "0.2"}}));
    QCOMPARE(desk.weights()[0].mass, 0.2);
    QVERIFY(desk.commands.run("physics.removeWeight", {{"weight", "0"}}));
    QVERIFY(desk.weights().empty());
    QVERIFY(!desk.commands.run("physics.addWeight", {{"section", "Nobody"}}));
}

// Wrong: a mass that no balance can be found for.
void TestWeightTool::wrongMasses()
{
    WeightDesk desk;
    desk.click(desk.plate(40, 25));
    const Document document = desk.session.committed().document;
    for (const char *mass : {"0", "-1", "2e6", "nan", "inf", "much"})
        QVERIFY(!desk.commands.run("physics.setWeight", {{"weight", "0"}, {"mass", mass}}));
    QVERIFY(!desk.commands.run("physics.setWeight", {{"weight", "7"}, {"mass", "1"}}));
    QVERIFY(desk.session.committed().document == document);
    for (const double mass : {1e-6, kMaxWeight}) {
        Weight weight = document.weights[0];
        weight.mass = mass;
        QVERIFY(setWeight(document, weight));
    }
    Weight stranger = document.weights[0];
    stranger.id = WeightId{12345};
    QVERIFY(!setWeight(document, stranger));
}

FFF_TEST(TestWeightTool)
#include "tst_weight_tool.moc"
