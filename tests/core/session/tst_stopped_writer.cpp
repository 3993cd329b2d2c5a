// The program stopped at every single call by which it touches the recovery folder: killed there,
// or told that the disk is full. If this fails, a crash at a bad moment costs somebody all that was
// not saved.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/io/blobs.h"
#include "core/io/document_file.h"
#include "core/io/error_text.h"
#include "core/model/edits.h"
#include "core/session/autosave.h"
#include "tests/core/session/traced_child.h"
#include "tests/test_program.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <array>
#include <fcntl.h>

using namespace fff;
using fff::test::TracedChild;

namespace {

/// Its number of sections tells it from others.
Document documentOf(int sections)
{
    Document document = newDocument();
    for (int i = 0; i < sections; ++i) {
        NewSection section;
        section.shape =
            *Shape::make(*Contour::fromPolygon({{-50, -40}, {50, -40}, {50, 40}, {-50, 40}}));
        section.frame.origin.z() = 10.0 * i;
        document = *addSection(std::move(document), std::move(section));
    }
    return document;
}

/// With a picture of its own beside one that all of them have.
Document withPictures(Document document)
{
    const std::string number = std::to_string(document.sections.size());
    document = addBlob(std::move(document), io::makeBlob("a picture"));
    return addBlob(std::move(document), io::makeBlob("picture " + number));
}

/// What has lost a picture is not found.
int numberOf(const Result<io::LoadedDocument> &loaded)
{
    return loaded && loaded->warnings.empty() ? static_cast<int>(loaded->document.sections.size())
                                              : 0;
}

RecoveryEntry entryNow()
{
    RecoveryEntry entry;
    entry.steps = 1;
    entry.time = QDateTime::fromMSecsSinceEpoch(1'700'000'000'000, Qt::UTC);
    return entry;
}

/// What the program says on its way, through a pipe: the newest document that it has promised to
/// be safe, and sentences about what went wrong.
class Reports
{
public:
    Reports() { QVERIFY(pipe2(m_ends.data(), O_CLOEXEC | O_NONBLOCK) == 0); }
    ~Reports()
    {
        for (const int end : m_ends)
            ::close(end);
    }
    Reports(const Reports &) = delete;
    Reports &operator=(const Reports &) = delete;

    int handle() const { return m_ends[1]; }
    void promise(int document) const { say("+" + QByteArray::number(document)); }
    void complain(const Error &error) const { say("!" + io::errorText(error).toUtf8()); }

    void read()
    {
        std::array<char, 4096> buffer = {};
        for (ssize_t n = 0; (n = ::read(m_ends[0], buffer.data(), buffer.size())) > 0;)
            m_text += QByteArray(buffer.data(), static_cast<int>(n));
    }
    int promised() const
    {
        int newest = 0;
        for (const QByteArray &line : m_text.split('\n'))
            if (line.startsWith('+'))
                newest = line.mid(1).toInt();
        return newest;
    }
    QByteArray complaint() const
    {
        const auto at = m_text.indexOf('!');
        return at < 0 ? QByteArray() : m_text.mid(at + 1).split('\n').front();
    }

private:
    void say(const QByteArray &line) const
    {
        const QByteArray text = line + '\n';
        Q_UNUSED(!::write(m_ends[1], text.constData(), static_cast<std::size_t>(text.size())));
    }

    std::array<int, 2> m_ends = {-1, -1};
    QByteArray m_text;
};

/// Where one program works: its folder, the person's file, and what it says.
struct Place
{
    QString recovery() const { return home.filePath(QStringLiteral("recovery")); }
    QString file() const { return home.filePath(QStringLiteral("model.fff")); }
    QStringList leftovers() const
    {
        QStringList names = QDir(recovery()).entryList(QDir::Files | QDir::Hidden) +
                            QDir(home.path()).entryList(QDir::Files);
        for (const QString &blobs : QDir(recovery()).entryList({QStringLiteral("*.blobs")}))
            names += QDir(recovery() + u'/' + blobs).entryList(QDir::Files | QDir::Hidden);
        names.removeIf([](const QString &name) {
            return name.endsWith(QStringLiteral(".fff")) ||
                   name.endsWith(QStringLiteral(".lock")) || io::isSha256(name.toStdString());
        });
        return names;
    }
    /// The newest that a person finds after the end, saved or offered.
    int found() const
    {
        int newest = numberOf(io::readDocument(file()));
        for (const RecoveryEntry &entry : listRecoverable(recovery()))
            newest = std::max(newest, numberOf(readRecoverable(entry)));
        return newest;
    }

    QTemporaryDir home;
    Reports reports;
};

/// False, and said, when it could not be kept.
bool keep(RecoverySlot *slot, int document, const Place &place, bool hasPictures = false)
{
    if (!slot) {
        place.reports.complain({ErrorCode::CannotWrite, "recovery", {"the folder cannot be used"}});
        return false;
    }
    const Document plain = documentOf(document);
    const Result<void> kept = slot->write(hasPictures ? withPictures(plain) : plain, entryNow());
    if (kept)
        place.reports.promise(document);
    else
        place.reports.complain(kept.error());
    return kept.has_value();
}

int firstCopy(const Place &place)
{
    const auto slot = RecoverySlot::make(place.recovery());
    return keep(slot.get(), 1, place) ? 0 : 1;
}

int secondCopy(const Place &place)
{
    const auto slot = RecoverySlot::make(place.recovery());
    const bool first = keep(slot.get(), 1, place), second = keep(slot.get(), 2, place);
    return first && second ? 0 : 1;
}

int copiesWithPictures(const Place &place)
{
    const auto slot = RecoverySlot::make(place.recovery());
    const bool first = keep(slot.get(), 1, place, true), second = keep(slot.get(), 2, place, true);
    return first && second ? 0 : 1;
}

/// A crash has left document 1, and its lock.
void leaveACopy(const Place &place)
{
    QString path;
    {
        const auto slot = RecoverySlot::make(place.recovery());
        QVERIFY(slot && slot->write(documentOf(1), entryNow()));
        path = slot->path();
    }
    QFile lock(path + QStringLiteral(".lock"));
    QVERIFY(lock.open(QIODevice::WriteOnly));
}

int recoveredWork(const Place &place)
{
    const QList<RecoveryEntry> entries = listRecoverable(place.recovery());
    const auto slot = entries.isEmpty() ? nullptr : RecoverySlot::take(entries.front().slot);
    return keep(slot.get(), 2, place) ? 0 : 1;
}

int startPage(const Place &place)
{
    return listRecoverable(place.recovery()).size() == 1 ? 0 : 1;
}

int savedAndEditedAgain(const Place &place)
{
    auto slot = RecoverySlot::make(place.recovery());
    bool isGood = keep(slot.get(), 1, place);
    if (io::writeDocument(place.file(), documentOf(1)) && slot)
        slot->remove();
    slot = RecoverySlot::make(place.recovery());
    isGood = keep(slot.get(), 2, place) && isGood;
    return isGood ? 0 : 1;
}

/// The window's own way: an edit every 300 ms on a clock that goes only with them.
int edits(const Place &place)
{
    constexpr int kEdits = 12, kBetween = 300;
    qint64 now = 0;
    Session session;
    Autosave autosave(
        session, place.recovery(), nullptr,
        {[&now] { return now; }, [&now] { return QDateTime::fromMSecsSinceEpoch(now, Qt::UTC); }});
    autosave.setInterval(1'000);
    bool isGood = true;
    QObject::connect(&autosave, &Autosave::kept, &autosave, [&](const Document &document) {
        place.reports.promise(static_cast<int>(document.sections.size()));
    });
    QObject::connect(&autosave, &Autosave::failed, &autosave, [&](const Error &error) {
        place.reports.complain(error);
        isGood = false;
    });
    session.reset(newDocument());
    for (int i = 1; i <= kEdits; ++i, now += kBetween)
        session.commit(QStringLiteral("Draw"), documentOf(i));
    autosave.flush();
    return isGood ? 0 : 1;
}

struct Scenario
{
    const char *name;
    int (*run)(const Place &);
    bool hasCopy; // document 1, before it begins
    int last;     // document that it promises; after that it lets go
};

constexpr std::array kScenarios = {
    Scenario{"a first copy", firstCopy, false, 1},
    Scenario{"a second copy", secondCopy, false, 2},
    Scenario{"copies with pictures", copiesWithPictures, false, 2},
    Scenario{"recovered work goes on", recoveredWork, true, 2},
    Scenario{"the start page", startPage, true, 0},
    Scenario{"saved and edited again", savedAndEditedAgain, false, 2},
    Scenario{"an edit every 300 ms", edits, false, 12},
};

void scenarios()
{
    QTest::addColumn<int>("which");
    for (std::size_t i = 0; i < kScenarios.size(); ++i)
        QTest::newRow(kScenarios[i].name) << static_cast<int>(i);
}

} // namespace

class TestStoppedWriter : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void killedAtEachCall_data() { scenarios(); }
    void killedAtEachCall();
    void refusedAtEachCall_data();
    void refusedAtEachCall();
    void anotherWindowLooksOn_data() { scenarios(); }
    void anotherWindowLooksOn();
    void theFirstCopyWaitsForNoDisk();
};

void TestStoppedWriter::initTestCase()
{
    if (TracedChild([] { return 0; }).wasRefused())
        QSKIP("no process may look at another one here");
}

// Wrong: there is a moment in which a crash leaves nothing, although something was kept.
void TestStoppedWriter::killedAtEachCall()
{
    QFETCH(int, which);
    const Scenario &scenario = kScenarios[static_cast<std::size_t>(which)];
    bool hasEnded = false;
    int kills = 0;
    for (; !hasEnded; ++kills) {
        Place place;
        if (scenario.hasCopy)
            leaveACopy(place);
        TracedChild child([&] { return scenario.run(place); });
        for (int left = kills; left >= 0;) {
            const std::optional<TracedChild::Call> call = child.next();
            hasEnded = !call;
            if (!call)
                break;
            left -= fff::test::touchesFiles(call->number) && call->first != place.reports.handle();
        }
        child.kill(); // and nobody has noticed yet
        place.reports.read();
        const int least = std::max(place.reports.promised(), scenario.hasCopy ? 1 : 0);
        const int found = place.found();
        QVERIFY2(found >= least, qPrintable(QStringLiteral("killed at call %1: %2 instead of %3")
                                                .arg(kills + 1)
                                                .arg(found)
                                                .arg(least)));
        QVERIFY(listRecoverable(place.recovery()).size() <= 1);
        if (hasEnded)
            QCOMPARE(child.status(), 0);
    }
    qInfo("killed %d times", kills - 1);
    QVERIFY(kills > 5);
}

void TestStoppedWriter::refusedAtEachCall_data()
{
    QTest::addColumn<int>("which");
    QTest::addColumn<int>("error");
    for (std::size_t i = 0; i < kScenarios.size(); ++i) {
        QTest::addRow("%s, disk full", kScenarios[i].name) << static_cast<int>(i) << ENOSPC;
        QTest::addRow("%s, folder read-only", kScenarios[i].name) << static_cast<int>(i) << EACCES;
        QTest::addRow("%s, disk broken", kScenarios[i].name) << static_cast<int>(i) << EIO;
    }
}

// Wrong: a full disk takes the copy that was there, or nobody is told that there is none.
void TestStoppedWriter::refusedAtEachCall()
{
    QFETCH(int, which);
    QFETCH(int, error);
    const Scenario &scenario = kScenarios[static_cast<std::size_t>(which)];
    bool hasEnded = false;
    int complaints = 0;
    for (int refused = 0; !hasEnded; ++refused) {
        Place place;
        if (scenario.hasCopy)
            leaveACopy(place);
        TracedChild child([&] { return scenario.run(place); });
        hasEnded = true;
        long refusedCall = -1;
        int at = 0;
        while (const std::optional<TracedChild::Call> call = child.next()) {
            if (call->first == place.reports.handle() || call->number == SYS_close ||
                !fff::test::touchesFiles(call->number))
                continue;
            if (at++ == refused) {
                hasEnded = false;
                refusedCall = call->number;
                child.refuse(error);
            }
        }
        child.reap();
        place.reports.read();
        const int least = std::max(place.reports.promised(), scenario.hasCopy ? 1 : 0);
        const QString where =
            QStringLiteral("call %1, number %2").arg(refused + 1).arg(refusedCall);
        const int found = place.found();
        QVERIFY2(
            found >= least,
            qPrintable(QStringLiteral("%1: %2 instead of %3").arg(where).arg(found).arg(least)));
        const bool isSaid = !place.reports.complaint().isEmpty();
        QVERIFY2(child.status() == 0 || isSaid || scenario.run == startPage, qPrintable(where));
        const bool mayLeave = refusedCall == SYS_unlink || refusedCall == SYS_unlinkat;
        QVERIFY2(mayLeave || place.leftovers().isEmpty(),
                 qPrintable(where + u' ' + place.leftovers().join(u' ')));
        complaints += isSaid;
    }
    QVERIFY(complaints > 0 || scenario.run == startPage);
}

// Wrong: a second window takes what the first one is about to write for what a crash has left.
void TestStoppedWriter::anotherWindowLooksOn()
{
    QFETCH(int, which);
    const Scenario &scenario = kScenarios[static_cast<std::size_t>(which)];
    Place place;
    if (scenario.hasCopy)
        leaveACopy(place);
    TracedChild child([&] { return scenario.run(place); });
    bool isTaken = false;
    while (child.next()) {
        const qsizetype offered = listRecoverable(place.recovery()).size();
        isTaken = isTaken || offered == 0;
        place.reports.read();
        const bool hasLetGo = place.reports.promised() == scenario.last;
        QVERIFY2(offered == 0 || (scenario.hasCopy && !isTaken) || hasLetGo,
                 "what is open is offered");
    }
    QCOMPARE(child.status(), 0);
    place.reports.read();
    QCOMPARE(place.found(), std::max(place.reports.promised(), scenario.hasCopy ? 1 : 0));
}

// Wrong: a disk that is busy for seconds keeps the first copy from those who look for it after a
// crash.
void TestStoppedWriter::theFirstCopyWaitsForNoDisk()
{
    Place place;
    TracedChild child([&] { return firstCopy(place); });
    bool waits = false;
    while (const std::optional<TracedChild::Call> call = child.next()) {
        waits = call->number == SYS_fsync || call->number == SYS_fdatasync;
        if (waits)
            break;
    }
    QVERIFY(waits);
    child.kill();
    QCOMPARE(place.found(), 1);
}

FFF_TEST(TestStoppedWriter)
#include "tst_stopped_writer.moc"
