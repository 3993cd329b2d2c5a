// The program killed with SIGKILL at random moments of editing, saving and keeping. If this fails,
// a crash or a power cut costs somebody a file, or more work than the last seconds.
#include <QApplication>
#include <QTest>

#include "core/io/document_file.h"
#include "core/session/journal.h"
#include "core/session/recovery.h"
#include "tests/test_program.h"

#include <QDeadlineTimer>
#include <QDir>
#include <QProcess>
#include <QRandomGenerator>
#include <QTemporaryDir>

#include <array>
#include <cmath>
#include <memory>
#include <set>

using namespace fff;

namespace {

constexpr int kRounds = 50;
constexpr int kRoundsOfRow = 10;
constexpr int kAtOnce = 2;        // programs that run side by side
constexpr int kPatience = 60'000; // ms, for a step to come
constexpr int kSaveIsDue = 3'000; // ms, for a save to come after it

/// When it is killed: some time after its first step, within a save, or about when it is kept
/// first.
enum class Moment { Any, Saving, Keeping };
constexpr int kLongestLife = 1200; // ms, Any
constexpr int kLongestSave = 12;   // ms, Saving
constexpr int kKeptAfter = 480;    // ms, Keeping: a little before Autosave::kFirstDelay
constexpr int kKeptWithin = 80;    // ms, Keeping

struct Line
{
    QByteArray what, digest;
};

/// Steps that come thick and fast: rings of other sizes about the middle, strokes out of them,
/// undo, and a save now and then. Every document is another one.
QByteArray script(QRandomGenerator &random)
{
    QByteArray events = R"({"type": "view", "name": "front"})";
    const auto pointer = [&](const char *type, double x, double y) {
        events += QByteArray(",\n{\"type\": \"") + type + "\", \"x\": " + QByteArray::number(x) +
                  ", \"y\": " + QByteArray::number(y) + '}';
    };
    const auto command = [&](const char *name) {
        events += QByteArray(",\n{\"type\": \"command\", \"name\": \"") + name + "\"}";
    };
    const auto wait = [&](int ms) {
        events += ",\n{\"type\": \"wait\", \"ms\": " + QByteArray::number(ms) + '}';
    };
    for (int cycle = 0; cycle < 40; ++cycle) {
        const double r = 150 + random.bounded(150);
        // On an empty document a section; on one that is there, a stroke out of it or an orbit.
        pointer("press", 640 + r, 400);
        for (int i = 1; i < 12; ++i)
            pointer("move", 640 + r * std::cos(i * 0.5236), 400 + r * std::sin(i * 0.5236));
        pointer("release", 640 + r, 400);
        wait(random.bounded(120));
        switch (random.bounded(5)) {
        case 0:
        case 4:
            command("file.save");
            break;
        case 1:
            command("edit.selectAll");
            command("edit.delete");
            break;
        case 2:
            command("edit.undo");
            wait(random.bounded(60));
            command("edit.redo");
            break;
        default:
            command("edit.selectAll");
            command("edit.delete");
            wait(random.bounded(700)); // long enough to be kept, now and then
            break;
        }
    }
    return "{\"viewport\": [1280, 800], \"events\": [" + events + "]}";
}

/// One run of the program in a home of its own.
class Program
{
public:
    explicit Program(QRandomGenerator &random);

    /// False when it went by itself before.
    bool kill(Moment moment, QRandomGenerator &random);
    std::vector<Line> journal() const;
    Result<io::LoadedDocument> savedFile() const { return io::readDocument(m_file); }
    QString recoveryFolder() const
    {
        return m_home.filePath(QStringLiteral("data/flatfitfab/recovery"));
    }
    QByteArray opened() const { return m_opened; }
    /// How it ended and what it said, for when that is what went wrong.
    QByteArray lastWords() const;

private:
    bool waitFor(const char *what, int patience);

    QTemporaryDir m_home;
    QString m_file;
    QByteArray m_opened; // digest of what the file held at first
    QProcess m_process;
    QByteArray m_output;
};

Program::Program(QRandomGenerator &random) : m_file(m_home.filePath(QStringLiteral("model.fff")))
{
    const Document empty = newDocument();
    m_opened = digestOf(empty);
    QFile play(m_home.filePath(QStringLiteral("script.json")));
    if (!io::writeDocument(m_file, empty) || !play.open(QIODevice::WriteOnly))
        qFatal("no place for test files");
    play.write(script(random));
    play.close();

    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("XDG_CONFIG_HOME"),
                       m_home.filePath(QStringLiteral("config")));
    environment.insert(QStringLiteral("XDG_DATA_HOME"), m_home.filePath(QStringLiteral("data")));
    environment.insert(QStringLiteral("XDG_CACHE_HOME"), m_home.filePath(QStringLiteral("cache")));
    environment.insert(QStringLiteral("QT_LOGGING_RULES"),
                       QStringLiteral("flatfitfab.journal.debug=true"));
    environment.insert(QStringLiteral("QT_MESSAGE_PATTERN"),
                       QStringLiteral("%{category} %{message}"));
    m_process.setProcessEnvironment(environment);
    m_process.setProcessChannelMode(QProcess::MergedChannels);
    // Small: the picture is most of the work where there is no graphics card.
    m_process.start(QStringLiteral(FFF_WINDOW),
                    {QStringLiteral("-qwindowgeometry"), QStringLiteral("1024x640"),
                     QStringLiteral("--play"), play.fileName(), m_file});
}

bool Program::waitFor(const char *what, int patience)
{
    const QByteArray line = QByteArray("flatfitfab.journal ") + what + ' ';
    QDeadlineTimer deadline(patience);
    while (!m_output.contains(line) && !deadline.hasExpired() &&
           m_process.state() != QProcess::NotRunning) {
        m_process.waitForReadyRead(static_cast<int>(deadline.remainingTime()));
        m_output += m_process.readAll();
    }
    return m_output.contains(line);
}

bool Program::kill(Moment moment, QRandomGenerator &random)
{
    waitFor("step", kPatience);
    if (moment == Moment::Saving)
        waitFor("saving", kSaveIsDue);
    QTest::qWait(moment == Moment::Any      ? random.bounded(kLongestLife)
                 : moment == Moment::Saving ? random.bounded(kLongestSave)
                                            : kKeptAfter + random.bounded(kKeptWithin));
    const bool wasRunning = m_process.state() == QProcess::Running;
    m_process.kill();
    m_process.waitForFinished();
    m_output += m_process.readAll();
    return wasRunning;
}

QByteArray Program::lastWords() const
{
    return (m_process.exitStatus() == QProcess::CrashExit ? "crashed, " : "left, code ") +
           QByteArray::number(m_process.exitCode()) + ", " + m_process.errorString().toUtf8() +
           '\n' + m_output.right(4000);
}

std::vector<Line> Program::journal() const
{
    std::vector<Line> lines;
    for (const QByteArray &line : m_output.split('\n')) {
        const QList<QByteArray> words = line.trimmed().split(' ');
        if (words.value(0) == "flatfitfab.journal")
            lines.push_back({words.value(1), words.value(2)});
    }
    return lines;
}

/// Position of the last line that says so, or -1.
int lastOf(const std::vector<Line> &lines, const char *what)
{
    int last = -1;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].what == what)
            last = static_cast<int>(i);
    }
    return last;
}

/// Digests of such lines from a position on.
std::set<QByteArray> digests(const std::vector<Line> &lines, std::set<QByteArray> whats, int from)
{
    std::set<QByteArray> found;
    for (std::size_t i = static_cast<std::size_t>(std::max(from, 0)); i < lines.size(); ++i) {
        if (whats.contains(lines[i].what))
            found.insert(lines[i].digest);
    }
    return found;
}

/// The line of the step that this digest was at first.
int stepOf(const std::vector<Line> &lines, const QByteArray &digest)
{
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].digest == digest && (lines[i].what == "step" || lines[i].what == "opened"))
            return static_cast<int>(i);
    }
    return -1;
}

} // namespace

class TestKilled : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void nothingIsBrokenAndLittleIsLost_data();
    void nothingIsBrokenAndLittleIsLost();
    void thereWasSomethingToLose();

private:
    void look(const Program &program, const QByteArray &round);

    QRandomGenerator m_random;
    int m_saves = 0, m_cutSaves = 0, m_recovered = 0;
};

void TestKilled::initTestCase()
{
    const quint32 seed = qEnvironmentVariableIsSet("FFF_SEED")
                             ? qEnvironmentVariable("FFF_SEED").toUInt()
                             : QRandomGenerator::global()->generate();
    qInfo("seed %u (FFF_SEED)", seed);
    m_random.seed(seed);
}

void TestKilled::nothingIsBrokenAndLittleIsLost_data()
{
    // Rows, since Qt Test gives each five minutes.
    QTest::addColumn<int>("first");
    for (int first = 0; first < kRounds; first += kRoundsOfRow)
        QTest::addRow("rounds %d to %d", first, first + kRoundsOfRow - 1) << first;
}

void TestKilled::nothingIsBrokenAndLittleIsLost()
{
    QFETCH(int, first);
    for (int round = first; round < first + kRoundsOfRow; round += kAtOnce) {
        std::vector<std::unique_ptr<Program>> programs;
        for (int i = 0; i < kAtOnce; ++i)
            programs.push_back(std::make_unique<Program>(m_random));
        for (int i = 0; i < kAtOnce; ++i) {
            const QByteArray name = "round " + QByteArray::number(round + i);
            constexpr std::array<Moment, 4> moments = {Moment::Any, Moment::Saving, Moment::Keeping,
                                                       Moment::Saving};
            const Moment moment = moments[static_cast<std::size_t>(round / kAtOnce + i) % 4];
            Program &program = *programs[static_cast<std::size_t>(i)];
            QVERIFY2(program.kill(moment, m_random),
                     name + ": it went by itself, " + program.lastWords());
            look(program, name);
            if (QTest::currentTestFailed())
                return;
        }
    }
}

void TestKilled::thereWasSomethingToLose()
{
    qInfo("%d ended with a save behind them, %d of them in one, %d with work to recover", m_saves,
          m_cutSaves, m_recovered);
    QVERIFY(m_saves >= kRounds / 10);
    QVERIFY(m_recovered >= kRounds / 10);
}

void TestKilled::look(const Program &program, const QByteArray &round)
{
    const std::vector<Line> lines = program.journal();
    QByteArray log = round;
    for (const Line &line : lines)
        log += "\n  " + line.what + ' ' + line.digest;
    QVERIFY2(lastOf(lines, "step") >= 0, log + "\n  no step was made");

    // The person's file is complete, and what was saved last or was being saved since.
    const Result<io::LoadedDocument> file = program.savedFile();
    QVERIFY2(file.has_value(), log + "\n  the saved file is broken");
    const QByteArray onDisk = digestOf(file->document);
    const int saved = lastOf(lines, "saved"), saving = lastOf(lines, "saving");
    std::set<QByteArray> possible = digests(lines, {"saving"}, saved);
    possible.insert(saved < 0 ? program.opened() : lines[static_cast<std::size_t>(saved)].digest);
    QVERIFY2(possible.contains(onDisk), log + "\n  the saved file is none of these: " + onDisk);
    m_saves += saving >= 0;
    m_cutSaves += saving > saved;

    // What is in the recovery folder is complete, and no older than what was said to be kept.
    const QStringList kept =
        QDir(program.recoveryFolder()).entryList({QStringLiteral("*.fff")}, QDir::Files);
    const QList<RecoveryEntry> entries = listRecoverable(program.recoveryFolder());
    QVERIFY2(entries.size() == kept.size(), log + "\n  a kept document is broken");
    QVERIFY2(entries.size() <= 1, log + "\n  one window kept several documents");
    const int lastKept = lastOf(lines, "kept");
    const int lastClean = std::max({lastOf(lines, "cleared"), saved, lastOf(lines, "opened")});
    if (!entries.isEmpty()) {
        ++m_recovered;
        const QByteArray digest = digestOf(readRecoverable(entries.front())->document);
        const bool isPromised = lastKept > lastClean;
        const int from =
            isPromised ? stepOf(lines, lines[static_cast<std::size_t>(lastKept)].digest) : 0;
        QVERIFY2(digests(lines, {"step", "opened"}, from).contains(digest),
                 log + "\n  what is recovered is older or unknown: " + digest);
        QVERIFY2(entries.front().originalPath.endsWith(QStringLiteral("model.fff")), log);
        QVERIFY2(entries.front().steps > 0, log);
    } else {
        // A clean document needs none; that it is clean may not have been said any more.
        const int lastStep = lastOf(lines, "step");
        const bool mayBeClean = saving > lastKept || lastStep > lastKept;
        // What was kept while it was being saved, too, is in the file.
        const bool isSaved =
            lastKept >= 0 && lines[static_cast<std::size_t>(lastKept)].digest == onDisk;
        QVERIFY2(lastKept < 0 || lastClean > lastKept || mayBeClean || isSaved,
                 log + "\n  what was kept is gone");
    }
}

FFF_TEST_WITH(TestKilled, fff::testing::runWithin<TestKilled, QApplication>)
#include "tst_killed.moc"
