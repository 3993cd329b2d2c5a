// A weight that is selected in the view, and what keys do with it then.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/interaction/hover_words.h"
#include "core/interaction/load_editing.h"
#include "core/interaction/load_words.h"
#include "core/model/edit_words.h"
#include "core/model/edits.h"
#include "core/model/load_edits.h"
#include "tests/core/interaction/desk.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;

namespace {

/// A plate of 200 x 120 mm, and 350 g that hang at (40, 25) of it; no tool in the hand.
struct HungDesk : Desk
{
    HungDesk()
    {
        addPlate();
        session.commit(QStringLiteral("Hang"),
                       *addLoad(session.committed().document,
                                Load{{}, sections()[0]->ref(), Vec2(40, 25), 0.35, "Cup"}));
        before = session.committed().document;
    }
    const std::vector<Load> &weights() const { return session.committed().document.loads; }
    bool isSelected() const { return interaction.selectedLoad().isValid(); }
    void select() { click(plate(40, 25)); }

    Document before;
};

} // namespace

class TestLoadEditing : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aClickSelectsIt();
    void elseIsSelectedInstead();
    void delRemovesIt();
    void arrowsMoveIt();
    void besideTheSectionItStays();
    void aLockedSectionKeepsIt();
    void plusAndMinusChangeIt();
    void lighterThanNothingItIsNot();
    void namesByCommand();
    void ofOneThatIsNotThere();
};

// Wrong: its section is selected in its place, or what is selected besides stays so.
void TestLoadEditing::aClickSelectsIt()
{
    HungDesk desk;
    desk.click(desk.plate(-50, 0));
    QCOMPARE(desk.interaction.selection().size(), std::size_t(1));
    desk.moveTo(desk.plate(40, 25) + Vec2(4, 3));
    QCOMPARE(desk.interaction.hovered().load, desk.weights()[0].id);
    QCOMPARE(desk.hint(), hints::kSelectWeight);
    desk.select();
    QCOMPARE(desk.interaction.selectedLoad(), desk.weights()[0].id);
    QVERIFY(desk.interaction.selection().empty());
    QCOMPARE(desk.hint(), hints::kMoveSelectedWeight);
    QVERIFY(desk.session.committed().document.isSame(desk.before));
}

// Wrong: Del would take away both.
void TestLoadEditing::elseIsSelectedInstead()
{
    HungDesk desk;
    desk.select();
    desk.click(desk.plate(-50, 0));
    QVERIFY(!desk.isSelected());
    QCOMPARE(desk.interaction.selection().size(), std::size_t(1));
    desk.select();
    desk.interaction.escape(desk.time);
    QVERIFY(!desk.isSelected());
    desk.run("physics.selectLoad", {{"load", "0"}});
    QVERIFY(desk.isSelected());
}

// Wrong: the section goes, or Undo does not bring back the very document and what was selected.
void TestLoadEditing::delRemovesIt()
{
    HungDesk desk;
    desk.select();
    desk.run("edit.delete");
    QVERIFY(desk.weights().empty());
    QCOMPARE(desk.sections().size(), std::size_t(1));
    QVERIFY(!desk.isSelected());
    QCOMPARE(desk.lastStep(), QStringLiteral("Remove weight"));
    desk.run("edit.undo");
    QVERIFY(desk.session.committed().document.isSame(desk.before));
    QVERIFY(desk.isSelected());
}

// Wrong: it goes another way than the arrow says, or each press is a step of its own.
void TestLoadEditing::arrowsMoveIt()
{
    HungDesk desk;
    desk.select();
    const int steps = desk.steps();
    desk.run("nudge.right");
    QVERIFY((desk.weights()[0].position - Vec2(41, 25)).norm() < 1e-9);
    desk.run("nudge.up");
    desk.run("nudge.left", {{"distance", "10"}});
    desk.run("nudge.down");
    QVERIFY((desk.weights()[0].position - Vec2(31, 25)).norm() < 1e-9);
    QCOMPARE(desk.steps(), steps + 1);
    QVERIFY(desk.sections()[0] == desk.before.sections[0]);
    QCOMPARE(desk.weights()[0].name, std::string("Cup"));
    QVERIFY(desk.isSelected());
    desk.run("edit.undo");
    QVERIFY(desk.session.committed().document.isSame(desk.before));
}

// Wrong: it hangs on nothing.
void TestLoadEditing::besideTheSectionItStays()
{
    HungDesk desk;
    desk.select();
    desk.run("nudge.up", {{"distance", "34"}});
    const Document at = desk.session.committed().document;
    desk.run("nudge.up", {{"distance", "10"}});
    QVERIFY(desk.session.committed().document.isSame(at));
    QCOMPARE(desk.hint(), hints::kWeightBeside);
    Load placed = at.loads[0];
    placed.position = {300, 0};
    QVERIFY(!changedLoad(desk.session.committed(), placed));
    placed.position = {-99, 0};
    QVERIFY(changedLoad(desk.session.committed(), placed));
}

// Wrong: what a person wants to stay as it is changes.
void TestLoadEditing::aLockedSectionKeepsIt()
{
    HungDesk desk;
    Document document = desk.before;
    Section locked = *document.sections[0];
    locked.isLocked = true;
    document.sections[0] = std::make_shared<const Section>(locked);
    desk.session.commit(QStringLiteral("Lock"), document);
    desk.select();
    desk.run("nudge.right");
    QVERIFY(desk.session.committed().document.isSame(document));
    QCOMPARE(desk.hint(), hints::kLocked);
}

// Wrong: rounding is seen after some presses.
void TestLoadEditing::plusAndMinusChangeIt()
{
    HungDesk desk;
    desk.select();
    const int steps = desk.steps();
    for (int i = 0; i < 7; ++i)
        desk.run("physics.heavier");
    QCOMPARE(desk.weights()[0].mass, 0.42);
    desk.run("physics.lighter");
    QCOMPARE(desk.weights()[0].mass, 0.41);
    QCOMPARE(desk.steps(), steps + 1);
    desk.run("edit.undo");
    QVERIFY(desk.session.committed().document.isSame(desk.before));
}

// Wrong: a mass that no balance can be found for.
void TestLoadEditing::lighterThanNothingItIsNot()
{
    HungDesk desk;
    desk.select();
    desk.run("physics.setLoad", {{"mass", "0.01"}});
    const Document at = desk.session.committed().document;
    desk.run("physics.lighter");
    QVERIFY(desk.session.committed().document.isSame(at));
    QCOMPARE(desk.hint(), hints::kEditFailed);
}

// Wrong: a script cannot say what the fields can, or it is more than one step.
void TestLoadEditing::namesByCommand()
{
    HungDesk desk;
    const int steps = desk.steps();
    desk.run("physics.setLoad", {{"name", "Book"}, {"x", "-10"}});
    QCOMPARE(desk.weights()[0].name, std::string("Book"));
    QCOMPARE(desk.weights()[0].position, Vec2(-10, 25));
    QCOMPARE(desk.steps(), steps + 1);
    QCOMPARE(desk.lastStep(), QStringLiteral("Rename Cup"));
    Load nameless = desk.weights()[0];
    nameless.name.clear();
    const SectionEdit bare = changedLoad(desk.session.committed(), nameless);
    QVERIFY(bare && bare->document.loads[0].name.empty());
    desk.run("edit.undo");
    QVERIFY(desk.session.committed().document.isSame(desk.before));
}

void TestLoadEditing::ofOneThatIsNotThere()
{
    HungDesk desk;
    const Model &model = desk.session.committed();
    const LoadId nobody{12345};
    Load unknown;
    unknown.id = nobody;
    for (const SectionEdit &edit :
         {changedLoad(model, unknown), movedLoad(model, nobody, Vec2(1, 0)),
          withMore(model, nobody, 1.0), removedLoad(model, nobody)})
        QVERIFY(!edit);
    desk.interaction.selectLoad(nobody);
    QVERIFY(!desk.isSelected());
}

FFF_TEST(TestLoadEditing)
#include "tst_load_editing.moc"
