#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/interaction/stroke_words.h"
#include "core/model/edits.h"
#include "tests/core/io/io_samples.h"
#include "tests/core/session/script_run.h"
#include "tests/test_program.h"

#include <cmath>

using namespace fff;
using namespace fff::test;

namespace {

QByteArray script(const QByteArray &events)
{
    return "{\"viewport\": [1280, 800], \"events\": [" + events + "]}";
}

} // namespace

class TestReplay : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void makesTheDocument_data();
    void makesTheDocument();
    void slitsAreCut();
    void replaysExactly();
    void throughAHole();
    void startsFromWhatIsThere();
    void timeDefaults();
    void keysAndCommands();
    void badScripts_data();
    void badScripts();
    void eventsBeforeABadOneHaveHappened();
};

void TestReplay::makesTheDocument_data()
{
    QTest::addColumn<int>("sections");
    QTest::addColumn<int>("steps");
    QTest::addColumn<Text>("hint"); // at the end; none: not looked at
    const auto row = [](const char *name, int sections, int steps, Text hint = {}) {
        QTest::newRow(name) << sections << steps << hint;
    };
    row("first_section", 1, 1);
    row("first_section_by_corners", 1, 1);
    row("second_section", 2, 2);
    row("second_then_front", 2, 2);
    row("in_a_moment", 2, 2);
    row("press_without_drag", 1, 1);
    row("release_in_slit", 1, 1, hints::kNeverLeft);
    row("release_in_turn", 1, 1, hints::kTooShort);
    row("release_in_dead_zone", 1, 1, hints::kTooShort);
    row("tiny_first_stroke", 0, 0, hints::kTooShort);
    row("straight_first_stroke", 0, 0, hints::kNoArea);
    row("escape_in_slit", 1, 1);
    row("escape_in_turn", 1, 1);
    row("escape_in_dead_zone", 1, 1);
    row("escape_in_contour", 1, 1);
    row("self_crossing", 1, 1, hints::kCrossesItself);
    row("undo_and_redo", 1, 2);
    row("undo_at_the_bottom", 0, 1);
    row("delete_by_keys", 2, 3);
    row("orbit_and_zoom", 1, 1);
}

void TestReplay::makesTheDocument()
{
    QFETCH(int, sections);
    QFETCH(int, steps);
    QFETCH(Text, hint);
    ScriptRun run;
    const Result<void> done = run.playFile(QString::fromUtf8(QTest::currentDataTag()));
    QVERIFY2(done, done ? "" : done.error().args.front().c_str());
    QCOMPARE(static_cast<int>(run.sections().size()), sections);
    QCOMPARE(run.session.history()->count(), steps);
    QVERIFY(!run.session.hasPreview());
    QVERIFY(!run.interaction.hasGesture());
    if (hint.source)
        QCOMPARE(run.interaction.hint().words.text, hint);
    for (const SectionPointer &section : run.sections()) {
        QVERIFY(section->shape->area() > 100.0);
        if (section->parent)
            QVERIFY(standsOnItsSlit(*run.sections().front(), *section));
    }
}

/// Drawing across a section is what a joint needs: both get a slit.
void TestReplay::slitsAreCut()
{
    ScriptRun run;
    QVERIFY(run.playFile(QStringLiteral("second_section")));
    const Analysis &analysis = run.session.currentAnalysis();
    QCOMPARE(analysis.assembly.joints.size(), std::size_t(1));
    for (std::size_t i = 0; i < 2; ++i) {
        QCOMPARE(analysis.assembly.slits[i].size(), std::size_t(1));
        QVERIFY(analysis.cuts[i]->area() < run.sections()[i]->shape->area());
    }
}

void TestReplay::replaysExactly()
{
    ScriptRun once, twice;
    QVERIFY(once.playFile(QStringLiteral("second_section")));
    QVERIFY(twice.playFile(QStringLiteral("second_section")));
    QVERIFY(once.session.committed().document == twice.session.committed().document);
}

void TestReplay::throughAHole()
{
    ScriptRun run;
    Document document = newDocument();
    NewSection plate;
    plate.shape =
        *Shape::make(*Contour::fromPolygon({{-100, -60}, {100, -60}, {100, 60}, {-100, 60}}),
                     {*Contour::fromPolygon({{-15, -15}, {-15, 15}, {15, 15}, {15, -15}})});
    plate.frame.origin = {0, 83.82, 0};
    run.session.reset(*addSection(std::move(document), std::move(plate)));
    QVERIFY(run.playFile(QStringLiteral("through_a_hole")));
    QCOMPARE(run.sections().size(), std::size_t(2));
    QVERIFY(standsOnItsSlit(*run.sections()[0], *run.sections()[1]));
    QVERIFY(std::abs(run.sections()[1]->parent->slitTo.x() + 15.0) < 1e-9);
}

void TestReplay::startsFromWhatIsThere()
{
    ScriptRun first;
    QVERIFY(first.playFile(QStringLiteral("first_section")));
    ScriptRun second;
    second.session.reset(first.session.committed().document);
    QVERIFY(second.play(script(R"({"type": "press", "x": 640, "y": 400},
                                  {"type": "release", "x": 640, "y": 400})")));
    QCOMPARE(second.interaction.selection().size(), std::size_t(1));
}

/// An event without a time comes 8 ms after the one before.
void TestReplay::timeDefaults()
{
    const auto turnIsOver = [](int moves, const QByteArray &last) {
        ScriptRun run;
        QByteArray events = R"({"type": "press", "x": 500, "y": 300},
            {"type": "move", "x": 800, "y": 300}, {"type": "move", "x": 800, "y": 500},
            {"type": "release", "x": 500, "y": 500},
            {"type": "press", "x": 700, "y": 400}, {"type": "move", "x": 900, "y": 400})";
        for (int i = 0; i < moves; ++i)
            events += R"(, {"type": "move", "x": 901, "y": 401})";
        const Result<void> played = run.play(script(events + last));
        return played && run.interaction.hasGesture() && !run.interaction.isAnimating();
    };
    QVERIFY(!turnIsOver(99, {}));
    QVERIFY(turnIsOver(100, {}));
    QVERIFY(!turnIsOver(0, R"(, {"type": "wait", "ms": 799})"));
    QVERIFY(turnIsOver(0, R"(, {"type": "wait", "ms": 800})"));
    QVERIFY(turnIsOver(0, R"(, {"type": "move", "x": 900, "y": 400, "t": 5000})"));
}

void TestReplay::keysAndCommands()
{
    ScriptRun run;
    QVERIFY(run.playFile(QStringLiteral("second_section")));
    QVERIFY(run.play(script(R"({"type": "command", "name": "edit.selectAll", "parameters": {}},
                               {"type": "key", "key": "Escape"})")));
    QVERIFY(run.interaction.selection().empty());
    QVERIFY(run.play(script(R"({"type": "key", "key": "3"}, {"type": "wait", "ms": 400})")));
    QVERIFY((run.interaction.camera().backward() - Vec3::UnitX()).norm() < 1e-9);
    QVERIFY(run.play(script(R"({"type": "command", "name": "file.new"})")));
    QVERIFY(run.sections().empty());
    QCOMPARE(run.session.history()->count(), 0);
}

void TestReplay::badScripts_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("place");
    const auto whole = [](const char *name, const QByteArray &text, ErrorCode code,
                          const char *place) {
        QTest::newRow(name) << text << int(code) << QString::fromUtf8(place);
    };
    whole("no JSON", "{\n\"viewport\": [1280, 800\n", ErrorCode::BadSyntax, "3");
    whole("an array", "[]", ErrorCode::BadSyntax, "1");
    whole("no viewport", "{\"events\": []}", ErrorCode::BadValue, "viewport");
    whole("a viewport of one number", "{\"viewport\": [3], \"events\": []}", ErrorCode::BadValue,
          "viewport");
    whole("an empty viewport", "{\"viewport\": [0, 800], \"events\": []}", ErrorCode::BadValue,
          "viewport");
    whole("no events", "{\"viewport\": [1280, 800]}", ErrorCode::BadValue, "events");
    whole("events that are no array", "{\"viewport\": [1280, 800], \"events\": {}}",
          ErrorCode::BadValue, "events");

    whole("no bytes", "", ErrorCode::BadSyntax, "1");
    whole("no text", QByteArray("\x89PNG\r\n\x1a\n\0\0", 10), ErrorCode::BadSyntax, "1");
    whole("a number", "17", ErrorCode::BadSyntax, "1");
    whole("a thousand levels", QByteArray(3000, '['), ErrorCode::BadSyntax, "1");
    whole("NaN", "{\"viewport\":\n[NaN, 800], \"events\": []}", ErrorCode::BadSyntax, "2");
    whole("a viewport larger than any", "{\"viewport\": [1e9, 800], \"events\": []}",
          ErrorCode::BadValue, "viewport");
    whole("a viewport of words", "{\"viewport\": [\"a\", \"b\"], \"events\": []}",
          ErrorCode::BadValue, "viewport");
    whole("a viewport with line ends", "{\"viewport\": \"a\\nb\", \"events\": []}",
          ErrorCode::BadValue, "viewport");
    whole("events with line ends", "{\"viewport\": [1280, 800], \"events\": \"\\u0085\\u001b\"}",
          ErrorCode::BadValue, "events");

    const auto row = [](const char *name, const QByteArray &events, int index = 0) {
        QTest::newRow(name) << script(events) << int(ErrorCode::BadEvent)
                            << QStringLiteral("events[%1]").arg(index);
    };
    row("an event that is no object", "7");
    row("no type", R"({"x": 1})");
    row("an unknown type", R"({"type": "hover", "x": 1, "y": 1})");
    row("a type that is no text", R"({"type": 5})");
    row("release without press",
        R"({"type": "move", "x": 1, "y": 1}, {"type": "release", "x": 1, "y": 1})", 1);
    row("press twice", R"({"type": "press", "x": 1, "y": 1}, {"type": "press", "x": 1, "y": 1})",
        1);
    row("release of another button",
        R"({"type": "press", "x": 1, "y": 1}, {"type": "release", "x": 1, "y": 1, "button": "right"})",
        1);
    row("no x", R"({"type": "move", "y": 1})");
    row("x as text", R"({"type": "move", "x": "1", "y": 1})");
    row("an unknown button", R"({"type": "press", "x": 1, "y": 1, "button": "fourth"})");
    row("modifiers as text", R"({"type": "press", "x": 1, "y": 1, "modifiers": "shift"})");
    row("an unknown modifier", R"({"type": "press", "x": 1, "y": 1, "modifiers": ["meta"]})");
    row("time that goes back",
        R"({"type": "move", "x": 1, "y": 1, "t": 50}, {"type": "move", "x": 1, "y": 1, "t": 49})",
        1);
    row("time before the start", R"({"type": "move", "x": 1, "y": 1, "t": -1})");
    row("an unknown view", R"({"type": "view", "name": "sideways"})");
    row("a wait below zero", R"({"type": "wait", "ms": -1})");
    row("a wait without ms", R"({"type": "wait"})");
    row("an unknown command",
        R"({"type": "wait", "ms": 1}, {"type": "command", "name": "edit.fly"})", 1);
    row("parameters as text", R"({"type": "command", "name": "edit.undo", "parameters": "a"})");
    row("a parameter that is an array",
        R"({"type": "command", "name": "edit.undo", "parameters": {"a": [7]}})");
    row("an unknown key", R"({"type": "key", "key": "Hyper"})");
    row("a key that is no text", R"({"type": "key", "key": 1})");
    row("an event that is null", "null");
    row("an event in an event", R"([{"type": "wait", "ms": 1}])");
    row("a type with line ends", R"({"type": "a\nb\u001b\u0085\u2028"})");
    row("a view with line ends", R"({"type": "view", "name": "a\nb"})");
    row("a command with line ends", R"({"type": "command", "name": "edit.\n\u009f"})");
    row("a key with line ends", R"({"type": "key", "key": "\r\n"})");
    row("a parameter with line ends",
        R"({"type": "command", "name": "edit.undo", "parameters": {"a\nb": {}}})");
    row("a name of a million letters",
        "{\"type\": \"command\", \"name\": \"" + QByteArray(1'000'000, 'x') + "\"}");
    row("time in words", R"({"type": "move", "x": 1, "y": 1, "t": "now"})");
    row("a button that is no text", R"({"type": "press", "x": 1, "y": 1, "button": 1})");
    row("steps in words", R"({"type": "wheel", "x": 1, "y": 1, "steps": "two"})");
    row("a view without a name", R"({"type": "view"})");
    row("a command without a name", R"({"type": "command"})");
    row("a key without a key", R"({"type": "key"})");
    row("a wait in words", R"({"type": "wait", "ms": "long"})");
    row("a wheel without steps", R"({"type": "wheel", "x": 1, "y": 1})");
}

void TestReplay::badScripts()
{
    QFETCH(QByteArray, text);
    QFETCH(int, code);
    QFETCH(QString, place);
    ScriptRun run;
    const Result<void> done = run.play(text);
    QVERIFY(!done);
    QCOMPARE(int(done.error().code), code);
    QCOMPARE(QString::fromStdString(done.error().place), place);
    QCOMPARE(done.error().args.size(), std::size_t(2));
    QCOMPARE(test::unclear(done.error()), QString());
}

void TestReplay::eventsBeforeABadOneHaveHappened()
{
    ScriptRun run;
    QVERIFY(!run.play(script(R"({"type": "press", "x": 500, "y": 300},
        {"type": "move", "x": 800, "y": 300}, {"type": "move", "x": 800, "y": 500},
        {"type": "release", "x": 500, "y": 500}, {"type": "nonsense"})")));
    QCOMPARE(run.sections().size(), std::size_t(1));
}

FFF_TEST(TestReplay)
#include "tests/told.h"
#include "tst_replay.moc"
