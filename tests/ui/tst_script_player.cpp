// Scripts in the window. If this fails, a demo or a test of the whole program does something else
// than the same script does on the command line.
#include <QTest>

#include "core/session/replay_script.h"
#include "tests/test_program.h"
#include "tests/ui/window_program.h"
#include "ui/bench/workbench.h"
#include "ui/settings/settings.h"
#include "ui/window/main_window.h"
#include "ui/window/script_player.h"

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>

using namespace fff;
using namespace fff::ui;

class TestScriptPlayer : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();
    void cleanup() { m_window.reset(); }

    void strokesMakeSections();
    void commandsAndKeysRun();
    void aWrongEventStopsIt_data();
    void aWrongEventStopsIt();

private:
    ScriptPlayer &play(const QByteArray &text);
    std::size_t count() { return m_window->bench().session().committed().sectionCount(); }

    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;
};

void TestScriptPlayer::initTestCase()
{
    QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, false);
    Settings::setFile(m_folder.filePath(QStringLiteral("settings.ini")));
}

void TestScriptPlayer::init()
{
    m_window = std::make_unique<MainWindow>();
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
}

ScriptPlayer &TestScriptPlayer::play(const QByteArray &text)
{
    Result<ReplayScript> script = ReplayScript::read(text);
    if (!script)
        qFatal("no script");
    auto *view = m_window->findChild<QWidget *>(QStringLiteral("viewport"));
    auto *player = new ScriptPlayer(m_window->bench(), *view, *std::move(script), m_window.get());
    player->start();
    return *player;
}

void TestScriptPlayer::strokesMakeSections()
{
    QFile file(QStringLiteral(FFF_TEST_DATA "/strokes/second_section.json"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QSignalSpy finished(&play(file.readAll()), &ScriptPlayer::finished);
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 30'000);
    QCOMPARE(count(), std::size_t(2));
    const Model &model = m_window->bench().session().committed();
    QVERIFY2(model.section(1)->parent.has_value(), "the second was drawn on the first");
}

void TestScriptPlayer::commandsAndKeysRun()
{
    QSignalSpy finished(&play(R"({"viewport": [400, 400], "events": [
        {"type": "view", "name": "front"},
        {"type": "press", "x": 300, "y": 200}, {"type": "move", "x": 200, "y": 300},
        {"type": "move", "x": 100, "y": 200}, {"type": "move", "x": 200, "y": 100},
        {"type": "release", "x": 300, "y": 200},
        {"type": "command", "name": "edit.undo"},
        {"type": "key", "key": "Z", "modifiers": ["control", "shift"]}]})"),
                        &ScriptPlayer::finished);
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 30'000);
    QCOMPARE(count(), std::size_t(1));
    QCOMPARE(m_window->bench().session().history()->index(), 1);
}

void TestScriptPlayer::aWrongEventStopsIt_data()
{
    QTest::addColumn<QByteArray>("event");
    QTest::newRow("no event") << QByteArray("7");
    QTest::newRow("an unknown command") << QByteArray(R"({"type": "command", "name": "fly"})");
    QTest::newRow("a key that does nothing") << QByteArray(R"({"type": "key", "key": "Hyper"})");
}

void TestScriptPlayer::aWrongEventStopsIt()
{
    QFETCH(QByteArray, event);
    ScriptPlayer &player =
        play(R"({"viewport": [400, 400], "events": [{"type": "wait", "ms": 1},)" + event + "]}");
    QString place;
    connect(&player, &ScriptPlayer::failed, this,
            [&](const Error &error) { place = QString::fromStdString(error.place); });
    QTRY_COMPARE(place, QStringLiteral("events[1]"));
}

FFF_TEST_WITH(TestScriptPlayer, runInWindowProgram<TestScriptPlayer>)
#include "tst_script_player.moc"
