// Sections that pull templates: the handle in the view, the command, and what strokes follow then.
#include "tests/core/interaction/desk.h"

#include "core/interaction/magnet_handle.h"
#include "core/interaction/template_guides.h"
#include "core/model/magnet_edits.h"
#include "core/model/template_edits.h"
#include "core/session/scheduler.h"
#include "core/templates/template_mesh.h"
#include "tests/core/templates/made_meshes.h"
#include "tests/test_program.h"

#include <cmath>

using namespace fff;
using namespace fff::test;

namespace {

/// A ball in the middle of a plate, which is selected.
struct PullingDesk : Desk
{
    PullingDesk()
    {
        Template one;
        one.name = "Ball";
        one.file = "ball.stl";
        one.mesh = makeTemplateMesh(mended(sphere(60.0, 60, 90)).value().mesh, {}).value();
        one.frame.origin = {0.0, kFirstPlaneHeight, 0.0};
        session.commit(QStringLiteral("Add template"),
                       addTemplate(session.committed().document, one).value());
        addPlate(0.0, {80, 70});
        interaction.select({sections().front()->id});
    }
    SectionRef plateRef() const { return sections().front()->id; }
    std::optional<double> pulls() const
    {
        return magnetOf(session.committed().document, plateRef());
    }
    std::optional<MagnetHandle> handle() const
    {
        Selection selection;
        selection.select({plateRef()});
        return magnetHandle(session.committed(), selection, interaction.camera());
    }
};

} // namespace

class TestMagnets : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void switchedOnAndOff();
    void theHandleSetsHowFar();
    void seenStraightThereIsNoHandle();
    void guidesFollowWhatWasPulled();
    void wrongNumbersAreSaid();
};

void TestMagnets::switchedOnAndOff()
{
    PullingDesk desk;
    const Document before = desk.session.committed().document;
    desk.run("section.pull", {{"on", "true"}});
    QCOMPARE(desk.pulls(), std::optional(kMagnetRadius));
    desk.run("section.pull", {{"radius", "30"}});
    QCOMPARE(desk.pulls(), std::optional(30.0));
    desk.run("section.pull", {{"on", "false"}});
    QVERIFY(!desk.pulls());
    for (int i = 0; i < 3; ++i)
        desk.run("edit.undo");
    QVERIFY(desk.session.committed().document == before);
    desk.run("template.set", {{"locked", "true"}});
    QVERIFY(!desk.commands.isEnabled("section.pull"));
}

void TestMagnets::theHandleSetsHowFar()
{
    PullingDesk desk;
    desk.run("section.pull", {{"radius", "20"}});
    desk.run("view.iso");
    desk.wait(2000.0);
    const std::optional<MagnetHandle> handle = desk.handle();
    QVERIFY(handle);
    desk.moveTo(desk.screen(handle->at()));
    QVERIFY(desk.hint().source == std::string("Drag to set how far %1 pulls templates."));
    const int steps = desk.steps();
    const Vec2 to = desk.screen(handle->at() + 15.0 * handle->way);
    desk.press(desk.cursor);
    desk.moveTo(to);
    QVERIFY(desk.interaction.hasGesture());
    QCOMPARE(desk.pulls(), std::optional(20.0)); // until it is let go
    desk.release(to);
    QCOMPARE(desk.steps(), steps + 1);
    QVERIFY2(std::abs(*desk.pulls() - 35.0) < 0.5, qPrintable(QString::number(*desk.pulls())));
    desk.run("edit.undo");
    QCOMPARE(desk.pulls(), std::optional(20.0));
    // Drawn through the plane it stays where it pulls something.
    desk.drag({desk.screen(handle->at()), desk.screen(handle->at() - 60.0 * handle->way)});
    QCOMPARE(desk.pulls(), std::optional(kLeastMagnet));
}

void TestMagnets::seenStraightThereIsNoHandle()
{
    PullingDesk desk;
    desk.run("section.pull", {{"radius", "20"}});
    desk.run("view.front");
    desk.wait(2000.0);
    QVERIFY(!desk.handle());
}

void TestMagnets::guidesFollowWhatWasPulled()
{
    PullingDesk desk;
    const Frame beside =
        makeFrame({0.0, kFirstPlaneHeight, 10.0}, Vec3::UnitX(), Vec3::UnitY()).value();
    const Model &model = desk.session.committed();
    const TemplateGuides before(model, nullptr, beside);
    desk.run("section.pull", {{"radius", "25"}});
    desk.session.scheduler().finish();
    const auto pulled = desk.host.pulled();
    QVERIFY(pulled && pulled->all.size() == 1);
    const TemplateGuides after(desk.session.committed(), pulled.get(), beside);
    // Ten off its middle a ball of 60 is cut in a circle of 59.2; of what was pulled into the plate
    // nothing of that is left there.
    const Vec2 rim(std::sqrt(60.0 * 60.0 - 100.0), 0.0);
    QVERIFY(before.isAt(rim, 0.5));
    QVERIFY(!after.isEmpty() && !after.isAt(rim, 0.5));
}

void TestMagnets::wrongNumbersAreSaid()
{
    PullingDesk desk;
    for (const CommandParameters &wrong :
         {CommandParameters{{"radius", "0"}}, CommandParameters{{"radius", "1001"}},
          CommandParameters{{"radius", "near"}}, CommandParameters{{"on", "yes"}}}) {
        QVERIFY(!desk.commands.run("section.pull", wrong, desk.time += 8.0));
        QVERIFY(!desk.pulls());
    }
}

FFF_TEST(TestMagnets)
#include "tst_magnets.moc"
