#include <QGuiApplication>
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/interaction/interaction.h"
#include "core/operations/operation_kind.h"
#include "core/session/operation_commands.h"
#include "core/session/session_commands.h"
#include "core/session/session_host.h"
#include "tests/core/operations/operation_models.h"
#include "tests/test_program.h"

#include <QUndoStack>

using namespace fff;
using namespace fff::test;

namespace {

/// Commands over a spine and a rib.
struct Bench
{
    Session session;
    SessionHost host{session};
    Interaction interaction{host};
    CommandRegistry commands;
    FishBones bones;

    Bench()
    {
        registerSessionCommands(commands, session, interaction);
        session.reset(bones.document);
        host.attach(interaction);
    }
    Result<void> run(const char *id, const CommandParameters &parameters = {})
    {
        return commands.run(id, parameters);
    }
    const Document &document() const { return session.committed().document; }
};

} // namespace

class TestOperationCommands : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyKindHasItsCommand();
    void inputsByNameAndBySelection();
    void theyAreCalledByWhatTheyMake_data();
    void theyAreCalledByWhatTheyMake();
    void changesAreSteps();
    void exceptionsByName();
    void bakingIsOneStep();
    void wrongUseIsNamed_data();
    void wrongUseIsNamed();
};

// Wrong: what the window can do a script could not.
void TestOperationCommands::everyKindHasItsCommand()
{
    Bench bench;
    for (const OperationKind *kind : operationKinds())
        QVERIFY(bench.commands.contains(std::string("operation.") + kind->key));
}

// Wrong: the ribs would run along the rib.
void TestOperationCommands::inputsByNameAndBySelection()
{
    Bench named;
    QVERIFY(named.run("operation.linear", {{"section", "Rib"},
                                           {"along", "Spine"},
                                           {"count", "5"},
                                           {"side", "both"},
                                           {"name", "Ribs"}}));
    QCOMPARE(named.session.committed().sectionCount(), 6U);
    QCOMPARE(named.document().operations[0]->name, std::string("Ribs"));
    QCOMPARE(named.document().operations[0]->inputs.at("along")[0].name, std::string("Spine"));
    Bench selected;
    selected.interaction.select({selected.bones.rib, selected.bones.spine});
    QVERIFY(selected.run("operation.linear"));
    selected.interaction.select({selected.bones.rib, selected.bones.spine});
    QVERIFY(selected.run("operation.linear", {{"count", "3"}}));
    QCOMPARE(selected.document().operations[0]->name, std::string("Rib row"));
    QCOMPARE(selected.document().operations[1]->name, std::string("Rib row (2)"));
    QCOMPARE(selected.session.committed().sectionCount(), 2U + 7U + 2U);
    // Several in one role, one on a line.
    Bench blend;
    QVERIFY(
        blend.run("operation.linear", {{"section", "Rib"}, {"along", "Spine"}, {"side", "both"}}));
    QVERIFY(blend.run("operation.blend",
                      {{"sections", "Rib\nRib 2"}, {"along", "Spine"}, {"count", "1"}}));
    QCOMPARE(blend.session.committed().evaluation.results[1]->sections.size(), 1U);
}

void TestOperationCommands::theyAreCalledByWhatTheyMake_data()
{
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("shape");
    QTest::addColumn<QString>("name");
    const auto row = [](const char *name, const char *kind, const char *shape = "") {
        QTest::newRow(name) << QString::fromLatin1(kind) << QString::fromLatin1(shape)
                            << QString::fromLatin1(name);
    };
    row("Rib row", "linear");
    row("Rib fan", "revolve");
    row("Spine grid", "grid");
    row("Spine gear", "radial");
    row("Spine star", "radial", "star");
    row("Spine circle", "radial", "circle");
    row("Spine rosette", "radial", "sector");
}

// Wrong: the outline lists "Radial Spine", and nobody knows what that made.
void TestOperationCommands::theyAreCalledByWhatTheyMake()
{
    QFETCH(QString, kind);
    QFETCH(QString, shape);
    QFETCH(QString, name);
    Bench bench;
    CommandParameters parameters{{"section", name.section(u' ', 0, 0).toStdString()}};
    if (kind == QStringLiteral("linear") || kind == QStringLiteral("revolve"))
        parameters["along"] = "Spine";
    if (!shape.isEmpty())
        parameters["kind"] = shape.toStdString();
    const std::string id = "operation." + kind.toStdString();
    QVERIFY(bench.run(id.c_str(), parameters));
    QCOMPARE(QString::fromStdString(bench.document().operations.front()->name), name);
}

// Wrong: a change could not be undone, or would undo more than itself.
void TestOperationCommands::changesAreSteps()
{
    Bench bench;
    QVERIFY(
        bench.run("operation.linear", {{"section", "Rib"}, {"along", "Spine"}, {"name", "Ribs"}}));
    const int steps = bench.session.history()->count();
    QVERIFY(
        bench.run("operation.change", {{"operation", "Ribs"}, {"count", "12"}, {"from", "25"}}));
    QCOMPARE(std::get<double>(bench.document().operations[0]->parameters.at("from")), 0.25);
    QCOMPARE(bench.session.committed().sectionCount(), 2U + 11U);
    QVERIFY(bench.run("operation.switch", {{"operation", "Ribs"}}));
    QCOMPARE(bench.session.committed().sectionCount(), 2U);
    QVERIFY(bench.run("operation.switch", {{"operation", "Ribs"}, {"on", "true"}}));
    QVERIFY(bench.run("operation.revolve",
                      {{"section", "Rib"}, {"along", "Spine"}, {"name", "Round"}}));
    QVERIFY(bench.run("operation.move", {{"operation", "Round"}, {"to", "1"}}));
    QCOMPARE(bench.document().operations[0]->name, std::string("Round"));
    QVERIFY(bench.run("operation.delete", {{"operation", "Round"}}));
    QCOMPARE(bench.session.history()->count(), steps + 6);
    QCOMPARE(bench.session.history()->undoText(), QStringLiteral("Delete Round"));
    while (bench.session.history()->canUndo())
        bench.session.history()->undo();
    QVERIFY(bench.document().isSame(bench.bones.document));
}

// Wrong: a rib that was left out could not be had back, since it has no name then.
void TestOperationCommands::exceptionsByName()
{
    Bench bench;
    QVERIFY(
        bench.run("operation.linear", {{"section", "Rib"}, {"along", "Spine"}, {"name", "Ribs"}}));
    QVERIFY(bench.run("operation.exclude", {{"section", "Rib 3"}}));
    QCOMPARE(bench.session.committed().sectionCount(), 2U + 6U);
    QVERIFY(bench.run("operation.exclude", {{"section", "Ribs/2"}, {"state", "made"}}));
    QCOMPARE(bench.session.committed().sectionCount(), 2U + 7U);
    bench.interaction.select({bench.session.committed().ref(4)});
    QVERIFY(bench.run("operation.exclude", {{"state", "detached"}}));
    QCOMPARE(bench.document().sections.size(), 3U);
}

// Wrong: undo would leave half of it.
void TestOperationCommands::bakingIsOneStep()
{
    Bench bench;
    QVERIFY(
        bench.run("operation.linear", {{"section", "Rib"}, {"along", "Spine"}, {"name", "Ribs"}}));
    const int steps = bench.session.history()->count();
    QVERIFY(bench.run("operation.bake", {{"operation", "Ribs"}}));
    QCOMPARE(bench.document().sections.size(), 9U);
    QCOMPARE(bench.session.history()->count(), steps + 1);
    bench.session.history()->undo();
    QCOMPARE(bench.document().operations.size(), 1U);
}

void TestOperationCommands::wrongUseIsNamed_data()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("value");
    QTest::addColumn<QString>("place");
    QTest::newRow("an unknown section") << "operation.linear"
                                        << "section"
                                        << "Fin"
                                        << "section";
    QTest::newRow("an unknown parameter") << "operation.linear"
                                          << "length"
                                          << "3"
                                          << "length";
    QTest::newRow("too many") << "operation.linear"
                              << "count"
                              << "501"
                              << "count";
    QTest::newRow("half a section") << "operation.linear"
                                    << "count"
                                    << "2.5"
                                    << "count";
    QTest::newRow("words for a number") << "operation.linear"
                                        << "count"
                                        << "many"
                                        << "count";
    QTest::newRow("an unknown choice") << "operation.linear"
                                       << "side"
                                       << "left"
                                       << "side";
    QTest::newRow("a switch that is a number") << "operation.linear"
                                               << "equalDepth"
                                               << "1"
                                               << "equalDepth";
    QTest::newRow("more than all") << "operation.linear"
                                   << "to"
                                   << "101"
                                   << "to";
    QTest::newRow("an unknown operation") << "operation.bake"
                                          << "operation"
                                          << "Ribs"
                                          << "operation";
    QTest::newRow("nothing selected") << "operation.exclude"
                                      << "state"
                                      << "hidden"
                                      << "section";
}

// Wrong: a script that is wrong would do something else, and not say where.
void TestOperationCommands::wrongUseIsNamed()
{
    QFETCH(QString, id);
    QFETCH(QString, key);
    QFETCH(QString, value);
    QFETCH(QString, place);
    Bench bench;
    CommandParameters parameters{{key.toStdString(), value.toStdString()}};
    if (id == QLatin1String("operation.linear")) {
        parameters.emplace("section", "Rib");
        parameters.emplace("along", "Spine");
    }
    const Result<void> run = bench.commands.run(id.toStdString(), parameters);
    QVERIFY(!run);
    QCOMPARE(run.error().code, ErrorCode::BadValue);
    QCOMPARE(QString::fromStdString(run.error().place), place);
    QVERIFY(bench.document().isSame(bench.bones.document));
}

FFF_TEST_WITH(TestOperationCommands,
              fff::testing::runWithin<TestOperationCommands, QGuiApplication>)
#include "tst_operation_commands.moc"
