// Every tool of the rest of editing, replayed from a script: tests/data/replays/TOOL.json, which
// FFF_RECORD=1 writes anew. What it makes is looked at, and every step of it is taken back and done
// again: the very objects of the document come back.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/interaction/gizmo.h"
#include "core/model/figures.h"
#include "core/session/replay.h"
#include "tests/core/interaction/recorder.h"
#include "tests/test_program.h"

#include <QFile>
#include <QUndoStack>

#include <functional>

using namespace fff;
using namespace fff::test;

namespace {

struct Drawn
{
    const char *name;
    std::function<void(Recorder &)> draw;
    std::function<bool(const Document &)> isRight;
};

/// A plate of 200 x 120 mm on the ground, selected and seen whole.
void plate(Recorder &hand)
{
    hand.command("section.addRectangle", {{"width", "200"}, {"height", "120"}, {"corner", "0"}});
    hand.command("view.front");
    hand.pause(1000.0);
    hand.command("view.fitAll");
    hand.pause(1000.0);
}

Vec2 on(const Recorder &hand, double x, double y)
{
    const Section &section = *hand.sections().front();
    return hand.screen(section.frame.toWorld(section.shape->bounds().center() + Vec2(x, y)));
}

Vec2 tip(const Recorder &hand, int axis)
{
    const auto *gizmo = hand.interaction.overlay().find<GizmoMarks>();
    return gizmo ? GizmoLook(gizmo->gizmo, hand.interaction.camera(), kViewport).tip(axis)
                 : Vec2(Vec2::Zero());
}

const Section &at(const Document &document, std::size_t i)
{
    return *document.sections.at(i);
}

double width(const Document &document)
{
    return at(document, 0).shape->bounds().size().x();
}

const std::vector<Drawn> &tools()
{
    static const std::vector<Drawn> kTools{
        {"transform",
         [](Recorder &hand) {
             plate(hand);
             hand.command("section.transform");
             hand.dragAlong({tip(hand, 1), tip(hand, 1) - Vec2(0, 80)});
             hand.dragAlong({on(hand, 30, 0), on(hand, 30, 0) + Vec2(60, 0)});
         },
         [](const Document &d) {
             return d.sections.size() == 1 && at(d, 0).frame.origin.y() > 65.0;
         }},
        {"turn_and_scale",
         [](Recorder &hand) {
             plate(hand);
             hand.command("section.turn", {{"angle", "30"}});
             hand.command("section.scale", {{"factor", "1.5"}});
         },
         [](const Document &d) { return std::abs(width(d) - 300.0) < 1e-6; }},
        {"copies",
         [](Recorder &hand) {
             plate(hand);
             hand.command("edit.duplicate");
             hand.command("edit.mirrorCopyX");
             hand.command("edit.selectAll");
             hand.command("edit.delete");
             hand.command("edit.undo");
         },
         [](const Document &d) { return d.sections.size() == 3; }},
        {"shape",
         [](Recorder &hand) {
             plate(hand);
             hand.command("section.addShape", {{"figure", "star"}});
             hand.pause(1500.0);
             hand.dragAlong({on(hand, 0, 0), on(hand, 30, 30)});
         },
         [](const Document &d) {
             const Figure *figure = figureOf(at(d, 0), 1);
             return figure && figure->kind == "star";
         }},
        {"mark",
         [](Recorder &hand) {
             plate(hand);
             hand.command("section.mark");
             hand.pause(1500.0);
             hand.clickAt(on(hand, 0, 30));
             hand.command("mark.change", {{"mark", "0"}, {"text", "Küche"}});
             hand.command("mark.score");
             hand.dragAlong({on(hand, -120, -20), on(hand, 0, -20), on(hand, 120, -20)});
         },
         [](const Document &d) {
             const auto &marks = at(d, 0).marks;
             return marks.size() == 2 && marks[0]->lettering->text == "Küche" &&
                    marks[1]->kind == Mark::Kind::Scored;
         }},
        {"measure",
         [](Recorder &hand) {
             plate(hand);
             hand.command("measure.ruler");
             hand.dragAlong({on(hand, -100, -60), on(hand, 100, 60)});
             hand.command("measure.keep");
         },
         [](const Document &d) { return d.dimensions.size() == 1; }},
        {"dimension",
         [](Recorder &hand) {
             plate(hand);
             hand.command("measure.dimension");
             hand.dragAlong({on(hand, -100, -60), on(hand, 100, -60)});
             hand.command("measure.keep");
             hand.command("measure.scale", {{"dimension", "0"}, {"length", "150"}});
         },
         [](const Document &d) { return std::abs(width(d) - 150.0) < 1e-9; }},
        {"numbers",
         [](Recorder &hand) {
             hand.command("numbers.set",
                          {{"name", "gap"}, {"value", "12"}, {"expression", "12 mm"}});
             hand.command("numbers.rename", {{"name", "gap"}, {"to", "space"}});
         },
         [](const Document &d) { return d.numbers.size() == 1 && d.numbers[0].name == "space"; }},
        {"lock_and_free",
         [](Recorder &hand) {
             plate(hand);
             hand.dragAlong({on(hand, 0, 0), on(hand, 0, 90)});
             hand.command("section.lock");
             hand.command("section.lock");
         },
         [](const Document &d) { return !at(d, 0).isLocked; }},
    };
    return kTools;
}

QString pathOf(const char *name)
{
    return QStringLiteral(FFF_TEST_DATA "/replays/%1.json").arg(QLatin1String(name));
}

} // namespace

class TestToolReplays : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void replayed_data();
    void replayed();
};

void TestToolReplays::initTestCase()
{
    if (!qEnvironmentVariableIsSet("FFF_RECORD"))
        return;
    for (const Drawn &tool : tools()) {
        Recorder hand;
        tool.draw(hand);
        QFile file(pathOf(tool.name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(hand.script());
    }
}

void TestToolReplays::replayed_data()
{
    QTest::addColumn<int>("index");
    for (std::size_t i = 0; i < tools().size(); ++i)
        QTest::newRow(tools()[i].name) << static_cast<int>(i);
}

// Wrong: a tool would make something else, or Undo would leave another document than before.
void TestToolReplays::replayed()
{
    QFETCH(int, index);
    const Drawn &tool = tools()[static_cast<std::size_t>(index)];
    QFile file(pathOf(tool.name));
    QVERIFY(file.open(QIODevice::ReadOnly));
    Session session;
    SessionHost host(session);
    Interaction interaction(host);
    host.attach(interaction);
    CommandRegistry commands;
    registerSessionCommands(commands, session, interaction);
    std::vector<Document> states{session.committed().document};
    QVERIFY(replay(file.readAll(), session, interaction, commands, [&](const ReplayEvent &) {
        const auto step = static_cast<std::size_t>(session.history()->index());
        states.resize(std::max(states.size(), step + 1));
        states[step] = session.committed().document;
    }));
    QVERIFY(tool.isRight(session.committed().document));
    QUndoStack &history = *session.history();
    QVERIFY(history.index() > 0);
    interaction.layDown(1e6);
    while (history.canUndo()) {
        history.undo();
        QVERIFY(
            session.committed().document.isSame(states[static_cast<std::size_t>(history.index())]));
    }
    while (static_cast<std::size_t>(history.index()) + 1 < states.size()) {
        history.redo();
        QVERIFY(
            session.committed().document.isSame(states[static_cast<std::size_t>(history.index())]));
    }
}

FFF_TEST(TestToolReplays)
#include "tst_tool_replays.moc"
