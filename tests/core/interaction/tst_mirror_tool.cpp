// The mirror in the hand: across which plane, and what comes of it, before it is done.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/interaction/mirror_tool.h"
#include "core/interaction/mirror_words.h"
#include "core/interaction/section_words.h"
#include "tests/core/interaction/desk.h"
#include "tests/test_program.h"

#include <QUndoStack>

#include <algorithm>

using namespace fff;
using namespace fff::test;

namespace {

/// A plate that stands to the right of the middle.
struct MirrorDesk : Desk
{
    MirrorDesk()
    {
        addPlate(30.0);
        interaction.select({sections().front()->id});
        run("section.move", {{"x", "150"}});
    }
    const Model &shown() const { return session.model(); }
    Box3 boxOf(std::size_t i) const
    {
        const Section &section = *session.model().section(i);
        return worldBounds(*section.shape, section.frame);
    }
    const sign::Region *plane() const { return interaction.overlay().find<sign::Region>(); }
};

double mirroredMiddle(const Box3 &box, int axis)
{
    return -box.center()[axis];
}

} // namespace

class TestMirrorTool : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatIsShownIsWhatComes_data();
    void whatIsShownIsWhatComes();
    void theModelGoesOnBeingMirrored();
    void acrossASection();
    void theHintSaysWhatEachWayDoes();
    void theSameAgainLaysItDown();
    void escLeavesNothing();
    void nothingToCopy();
};

void TestMirrorTool::whatIsShownIsWhatComes_data()
{
    QTest::addColumn<QString>("plane");
    QTest::addColumn<int>("axis");
    QTest::addColumn<QString>("outcome");
    const char *const outcomes[] = {"mirror.copy", "mirror.always", "mirror.once"};
    for (const char *outcome : outcomes) {
        QTest::addRow("left and right, %s", outcome)
            << "mirror.x" << 0 << QString::fromLatin1(outcome);
        QTest::addRow("up and down, %s", outcome)
            << "mirror.y" << 1 << QString::fromLatin1(outcome);
        QTest::addRow("front and back, %s", outcome)
            << "mirror.z" << 2 << QString::fromLatin1(outcome);
    }
}

// Wrong: the image lies elsewhere than the plane that is drawn says, or than was shown.
void TestMirrorTool::whatIsShownIsWhatComes()
{
    QFETCH(QString, plane);
    QFETCH(int, axis);
    QFETCH(QString, outcome);
    MirrorDesk desk;
    if (axis == 1) // else it would be joined to its image
        desk.run("section.move", {{"y", "200"}});
    const int before = desk.steps();
    desk.run("edit.mirror");
    desk.run(plane.toStdString());
    desk.run(outcome.toStdString());
    QCOMPARE(desk.steps(), before); // it is only shown
    QCOMPARE(desk.shown().sectionCount(), std::size_t(2));
    const Box3 shown = desk.boxOf(1);
    QVERIFY(std::abs(shown.center()[axis] - mirroredMiddle(desk.boxOf(0), axis)) < 1e-9);
    QVERIFY(desk.plane());
    for (const Vec3 &corner : desk.plane()->outline)
        QVERIFY(std::abs(corner[axis]) < 1e-9);
    QVERIFY(desk.commands.isOn(plane.toStdString()).value_or(false));
    QVERIFY(desk.commands.isOn(outcome.toStdString()).value_or(false));
    desk.run("mirror.apply");
    QVERIFY(!desk.interaction.tool());
    QCOMPARE(desk.steps(), before + 1);
    QCOMPARE(desk.session.committed().sectionCount(), std::size_t(2));
    QVERIFY((desk.boxOf(1).min - shown.min).norm() < 1e-9);
    QVERIFY((desk.boxOf(1).max - shown.max).norm() < 1e-9);
    const bool isOperation = outcome == QStringLiteral("mirror.always");
    QCOMPARE(desk.session.committed().document.operations.size(), std::size_t(isOperation));
    QCOMPARE(desk.sections().size(), std::size_t(isOperation ? 1 : 2));
    desk.run("edit.undo");
    QCOMPARE(desk.session.committed().sectionCount(), std::size_t(1));
}

// Wrong: "both sides" is true until the next edit only.
void TestMirrorTool::theModelGoesOnBeingMirrored()
{
    MirrorDesk desk;
    desk.interaction.select({});
    desk.run("edit.mirror"); // nothing is selected: the model
    QVERIFY(desk.interaction.key(ToolKey::Enter, desk.time));
    QVERIFY(desk.interaction.selectedOperation().isValid()); // its numbers are to be seen
    desk.interaction.select({desk.sections().front()->id});
    desk.run("section.move", {{"x", "25"}});
    QVERIFY(std::abs(desk.boxOf(1).center().x() - mirroredMiddle(desk.boxOf(0), 0)) < 1e-9);
}

// Wrong: which section is meant would have to be known before it is seen.
void TestMirrorTool::acrossASection()
{
    MirrorDesk desk;
    desk.addPlate(0.0, {30, 30}); // in front of nothing, at the left
    desk.interaction.select({desk.sections().front()->id});
    desk.run("edit.mirror");
    desk.run("mirror.section");
    QVERIFY(!desk.commands.isEnabled("mirror.apply"));
    QCOMPARE(desk.hint(), hints::kMirrorAcross);
    desk.moveTo(desk.plate(-5, -5));
    QCOMPARE(desk.shown().sectionCount(), std::size_t(3)); // over it, it is shown
    desk.moveTo(Vec2(5.0, 5.0));
    QCOMPARE(desk.shown().sectionCount(), std::size_t(2));
    QVERIFY(!desk.plane());
    desk.click(desk.plate(-5, -5));
    QVERIFY(!desk.interaction.tool());
    QCOMPARE(desk.sections().size(), std::size_t(3));
    QVERIFY(std::abs(desk.boxOf(2).center().z() + desk.boxOf(0).center().z()) < 1e-9);
}

// Wrong: a press of a choice puts the mirror away, or its own button leaves it in the hand.
void TestMirrorTool::theSameAgainLaysItDown()
{
    MirrorDesk desk;
    desk.run("edit.mirror");
    desk.run("mirror.x");
    desk.run("mirror.x");
    QVERIFY(desk.interaction.tool());
    desk.run("edit.mirror");
    QVERIFY(!desk.interaction.tool());
    QVERIFY(!desk.session.hasPreview());
}

void TestMirrorTool::escLeavesNothing()
{
    MirrorDesk desk;
    const Document before = desk.session.committed().document;
    desk.run("edit.mirror");
    QVERIFY(desk.session.hasPreview());
    desk.interaction.escape(desk.time);
    QVERIFY(!desk.interaction.tool());
    QVERIFY(!desk.session.hasPreview());
    QVERIFY(desk.session.committed().document.isSame(before));
}

// Wrong: a copy of nothing would be a step.
void TestMirrorTool::nothingToCopy()
{
    MirrorDesk desk;
    QVERIFY(!desk.commands.isEnabled("mirror.copy")); // it is not in the hand
    desk.interaction.select({});
    desk.run("edit.mirror");
    QVERIFY(!desk.commands.isEnabled("mirror.copy"));
    QVERIFY(desk.commands.isEnabled("mirror.once"));
}

// Wrong: three buttons, and one sentence for all of them.
void TestMirrorTool::theHintSaysWhatEachWayDoes()
{
    MirrorDesk desk;
    desk.run("edit.mirror");
    const std::pair<const char *, const Text *> ways[] = {{"mirror.copy", &hints::kMirrorCopy},
                                                          {"mirror.always", &hints::kMirrorAlways},
                                                          {"mirror.once", &hints::kMirrorOnce}};
    for (const auto &[command, words] : ways) {
        desk.run(command);
        QVERIFY2(desk.interaction.tool()->hint() == Hint(*words), command);
    }
}

FFF_TEST(TestMirrorTool)
#include "tst_mirror_tool.moc"
