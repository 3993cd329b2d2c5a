// Whoever only looks: what a hand does in the view of a model that is not to be edited there.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/interaction/tool.h"
#include "tests/core/interaction/desk.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;

class TestLooksOnly : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aDragOverASectionTurnsTheView();
    void nothingIsMarkedOrSelected();
    void whatWasInTheHandIsLaidDown();
    void toolsAreNotPickedUp();
    void theCubeAndTheWheelWork();
    void afterwardsAllIsAsBefore();
};

// Wrong: a pupil draws a section where the model was only to be looked at.
void TestLooksOnly::aDragOverASectionTurnsTheView()
{
    Desk desk;
    desk.addPlate();
    desk.interaction.setLooksOnly(true);
    const Document before = desk.session.committed().document;
    const Camera camera = desk.interaction.camera();
    const Vec2 middle = desk.screen({0, kFirstPlaneHeight, 0});
    desk.drag({middle, middle + Vec2(0, -300), middle + Vec2(200, -300)});
    QVERIFY(desk.session.committed().document.isSame(before));
    QVERIFY(desk.interaction.camera().orientation.angularDistance(camera.orientation) > 0.1);
    QVERIFY(!desk.interaction.hasGesture());
    // Also where Shift would draw a band, and on a model without sections.
    desk.drag({{30, 700}, {900, 100}}, Button::Left, kShift);
    QVERIFY(desk.interaction.selection().empty());
    Desk empty;
    empty.interaction.setLooksOnly(true);
    empty.drag({{500, 300}, {700, 300}, {700, 500}, {500, 500}, {500, 310}});
    QCOMPARE(empty.session.committed().sectionCount(), std::size_t(0));
}

void TestLooksOnly::nothingIsMarkedOrSelected()
{
    Desk desk;
    desk.addPlate();
    desk.interaction.setLooksOnly(true);
    const Vec2 middle = desk.screen({0, kFirstPlaneHeight, 0});
    desk.click(middle);
    desk.doubleClick(middle + Vec2(5, 5));
    QVERIFY(desk.interaction.selection().empty());
    QCOMPARE(desk.interaction.hovered().section, -1);
    QCOMPARE(desk.interaction.cursor(), Cursor::Arrow);
    desk.wait(2000.0);
    QVERIFY(!desk.interaction.hovered().namePlace);
    desk.interaction.select({desk.session.committed().ref(0)});
    QVERIFY(desk.interaction.selection().empty());
    QVERIFY(!desk.interaction.nudge({1, 0}, 1.0, desk.time));
}

void TestLooksOnly::whatWasInTheHandIsLaidDown()
{
    Desk desk;
    desk.addPlate();
    desk.interaction.select({desk.session.committed().ref(0)});
    desk.run("section.transform");
    QVERIFY(desk.interaction.tool());
    desk.interaction.setLooksOnly(true);
    QVERIFY(!desk.interaction.tool());
    QVERIFY(desk.interaction.selection().empty());
}

void TestLooksOnly::toolsAreNotPickedUp()
{
    Desk desk;
    desk.addPlate();
    desk.interaction.setLooksOnly(true);
    desk.run("section.pen");
    QVERIFY(!desk.interaction.tool());
}

void TestLooksOnly::theCubeAndTheWheelWork()
{
    Desk desk;
    desk.addPlate();
    desk.interaction.setLooksOnly(true);
    const double before = desk.interaction.camera().millimetresPerPixel;
    desk.wheel({640, 400}, 2.0);
    QVERIFY(desk.interaction.camera().millimetresPerPixel < before);
    const Camera camera = desk.interaction.camera();
    desk.drag({{640, 400}, {700, 400}}, Button::Middle);
    QVERIFY((desk.interaction.camera().target - camera.target).norm() > 1.0);
}

void TestLooksOnly::afterwardsAllIsAsBefore()
{
    Desk desk;
    desk.addPlate();
    desk.interaction.setLooksOnly(true);
    desk.interaction.setLooksOnly(false);
    desk.click(desk.screen({0, kFirstPlaneHeight, 0}));
    QCOMPARE(desk.interaction.selection().size(), std::size_t(1));
}

FFF_TEST(TestLooksOnly)
#include "tst_looks_only.moc"
