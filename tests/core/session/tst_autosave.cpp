// What a crash may cost. If this fails, somebody's work of more than the last seconds is lost, or
// what is offered after a crash is not what was there.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/io/blobs.h"
#include "core/io/document_file.h"
#include "core/io/error_text.h"
#include "core/io/fff_file.h"
#include "core/io/fff_format.h"
#include "core/model/edits.h"
#include "core/session/autosave.h"
#include "core/session/unreadable_work.h"
#include "tests/core/assembly/plates.h"
#include "tests/core/io/made_archive.h"
#include "tests/test_program.h"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QUndoStack>

using namespace fff;
using namespace fff::test;

namespace {

/// A session with its autosave, on a clock that goes only when it is told to.
struct Program
{
    explicit Program(const QString &folder)
        : autosave(std::make_unique<Autosave>(
              session, folder, nullptr,
              AutosaveClock{[this] { return elapsed; },
                            [this] {
                                return QDateTime::fromMSecsSinceEpoch(1'700'000'000'000 + elapsed,
                                                                      Qt::UTC);
                            }}))
    {
        session.reset(newDocument());
        QObject::connect(autosave.get(), &Autosave::kept, &listener,
                         [this](const Document &document) { kept.push_back(document); });
    }

    const Document &document() const { return session.committed().document; }
    void draw(double z = 0.0) { session.commit(QStringLiteral("Draw"), withPlate(document(), z)); }
    void pass(int milliseconds)
    {
        elapsed += milliseconds;
        autosave->writeIfDue();
    }
    /// As far as the disk goes: the slot is let go of, nothing else is written.
    void die() { autosave.reset(); }

    qint64 elapsed = 0;
    Session session;
    QObject listener;
    std::vector<Document> kept;
    std::unique_ptr<Autosave> autosave;
};

/// As a later edit will: a picture that the model is drawn after.
void addPicture(Program &program, const std::string &bytes)
{
    program.session.commit(
        QStringLiteral("Picture"),
        addBlob(program.document(), io::makeBlob(bytes, "image/png", "fish.png")));
}

QString blobsOf(const QString &slot)
{
    return slot + QStringLiteral(".blobs");
}

QString pathOf(const QString &slot, const std::string &bytes)
{
    return blobsOf(slot) + u'/' + QString::fromStdString(io::sha256Of(bytes));
}

/// Of the only one that there is, whoever holds it.
QString slotIn(const QString &folder)
{
    const QStringList names = QDir(folder).entryList({QStringLiteral("*.fff")}, QDir::Files);
    return names.size() == 1 ? folder + u'/' + names.front().chopped(4) : QString();
}

QStringList filesIn(const QString &folder)
{
    return QDir(folder).entryList(QDir::Files | QDir::Hidden);
}

void put(const QString &path, const QByteArray &bytes)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(bytes), bytes.size());
}

} // namespace

class TestAutosave : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void theFirstStepIsKeptSoon();
    void laterStepsAreKeptWithinTheInterval();
    void editsThickAndFastPostponeNothing();
    void anEditDuringAWriteLeadsToAnother();
    void aLoweredIntervalCountsAtOnce();
    void intervalsHaveALimit();
    void cleanMeansGone_data();
    void cleanMeansGone();
    void whatIsOpenIsNotOffered();
    void anEntrySaysWhatItIs();
    void theSlotIsAFileThatOpens();
    void recoveredWorkGoesOn();
    void aSlotOpensOnce();
    void anotherDocumentLeavesNoSlot();
    void whatACrashLeftIsOffered_data();
    void whatACrashLeftIsOffered();
    void brokenSlots_data();
    void brokenSlots();
    void damagedSlotsKeepTheirBlobs();
    void whatIsHeldIsNotSetAside();
    void linksAreLeftAlone();
    void aPackedDocumentIsOffered();
    void aFullFolderIsToldOnceAndTriedAgain();
    void blobsAreKeptBesideTheText();
    void blobsAreWrittenOnce();
    void blobsGoWithWhatRefersToThem();
    void lostBlobsCostOnlyThemselves_data();
    void lostBlobsCostOnlyThemselves();
    void blobsWithoutADocumentAreWaste();

private:
    QString folder() const { return m_folder->filePath(QStringLiteral("recovery")); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestAutosave::theFirstStepIsKeptSoon()
{
    Program program(folder());
    program.pass(60'000);
    QVERIFY2(filesIn(folder()).isEmpty(), "nothing was drawn, nothing is kept");
    program.draw();
    program.pass(Autosave::kFirstDelay);
    QTRY_COMPARE(program.kept.size(), 1u);
    QVERIFY(program.kept.front() == program.document());
}

void TestAutosave::laterStepsAreKeptWithinTheInterval()
{
    Program program(folder());
    program.draw();
    program.pass(Autosave::kFirstDelay);
    QTRY_COMPARE(program.kept.size(), 1u);
    program.draw(10);
    program.pass(Autosave::kDefaultInterval / 2);
    program.draw(20);
    program.pass(Autosave::kDefaultInterval / 2 - 1);
    program.autosave->writeIfDue();
    QCOMPARE(program.kept.size(), 1u);
    program.pass(1);
    QTRY_COMPARE(program.kept.size(), 2u);
    QVERIFY2(program.kept.back() == program.document(), "both steps, in one write");
}

// Wrong: who draws faster than the timer gets its turn has no copy at all.
void TestAutosave::editsThickAndFastPostponeNothing()
{
    Program program(folder());
    for (int i = 0; i < 40; ++i) {
        program.draw(10 * i);
        program.elapsed += 300; // no timer in all this time
    }
    program.autosave->flush();
    QVERIFY(program.kept.size() >= 2);
    QVERIFY2(program.kept.front().sections.size() <= 1 + Autosave::kFirstDelay / 300 + 1,
             "the first steps are kept at once");
    QVERIFY(program.kept.back() == program.document());
}

void TestAutosave::anEditDuringAWriteLeadsToAnother()
{
    Program program(folder());
    for (int i = 0; i < 20; ++i) {
        program.draw(10 * i);
        program.pass(Autosave::kDefaultInterval); // the worker is busy with the one before, or not
    }
    const Document last = program.document();
    program.autosave->flush();
    QVERIFY(program.kept.back() == last);
    for (std::size_t i = 1; i < program.kept.size(); ++i)
        QVERIFY2(program.kept[i].sections.size() > program.kept[i - 1].sections.size(),
                 "nothing older is written after anything newer");
    program.die();
    const QList<RecoveryEntry> entries = listRecoverable(folder());
    QCOMPARE(entries.size(), 1);
    QVERIFY(readRecoverable(entries.front())->document == last);
}

void TestAutosave::aLoweredIntervalCountsAtOnce()
{
    Program program(folder());
    program.draw();
    program.pass(Autosave::kFirstDelay);
    program.draw(10);
    program.pass(2'000);
    program.autosave->setInterval(1'000);
    program.autosave->writeIfDue();
    program.autosave->flush();
    QVERIFY(program.kept.back() == program.document());
}

void TestAutosave::intervalsHaveALimit()
{
    Program program(folder());
    program.autosave->setInterval(3'600'000);
    QVERIFY2(program.autosave->interval() < 30'000, "30 s lost at most, with the write");
    program.autosave->setInterval(-5);
    QCOMPARE(program.autosave->interval(), 0);
}

void TestAutosave::cleanMeansGone_data()
{
    QTest::addColumn<QString>("what");
    QTest::addColumn<bool>("waits");
    for (const char *what : {"save", "undo", "new", "discard"}) {
        QTest::addRow("%s, when it was kept", what) << QString::fromLatin1(what) << true;
        QTest::addRow("%s, while it is being kept", what) << QString::fromLatin1(what) << false;
    }
}

void TestAutosave::cleanMeansGone()
{
    QFETCH(QString, what);
    QFETCH(bool, waits);
    Program program(folder());
    program.draw();
    program.pass(Autosave::kFirstDelay);
    if (waits)
        QTRY_COMPARE(program.kept.size(), 1u);
    if (what == QStringLiteral("save"))
        program.session.setClean();
    else if (what == QStringLiteral("undo"))
        program.session.history()->undo();
    else if (what == QStringLiteral("new"))
        program.session.reset(newDocument());
    else
        program.autosave->discard();
    program.die();
    QVERIFY2(filesIn(folder()).isEmpty(), qPrintable(filesIn(folder()).join(u' ')));
}

void TestAutosave::whatIsOpenIsNotOffered()
{
    Program open(folder());
    open.draw();
    open.pass(Autosave::kFirstDelay);
    QTRY_COMPARE(open.kept.size(), 1u);
    {
        Program other(folder()); // a second window has a slot of its own
        other.draw();
        other.draw(10);
        other.pass(Autosave::kFirstDelay);
    }
    const QList<RecoveryEntry> entries = listRecoverable(folder());
    QCOMPARE(entries.size(), 1);
    QCOMPARE(entries.front().steps, 2);
    open.die();
    QCOMPARE(listRecoverable(folder()).size(), 2);
}

void TestAutosave::anEntrySaysWhatItIs()
{
    Program program(folder());
    const QString path = QStringLiteral("/home/someone/Zug & Brücke.fff");
    program.autosave->setDocument(path, QStringLiteral("Zug & \"Brücke\""));
    program.draw();
    program.draw(10);
    program.session.setClean();
    program.draw(20);
    program.draw(30);
    program.draw(40);
    program.session.history()->undo();
    program.pass(1'000);
    program.die();
    const QList<RecoveryEntry> entries = listRecoverable(folder());
    QCOMPARE(entries.size(), 1);
    QCOMPARE(entries.front().originalPath, path);
    QCOMPARE(entries.front().name, QStringLiteral("Zug & \"Brücke\""));
    QCOMPARE(entries.front().steps, 2);
    QCOMPARE(entries.front().time, QDateTime::fromMSecsSinceEpoch(1'700'000'001'000, Qt::UTC));
}

void TestAutosave::theSlotIsAFileThatOpens()
{
    Program program(folder());
    program.draw();
    program.pass(Autosave::kFirstDelay);
    const Document drawn = program.document();
    program.die();
    const QString path = listRecoverable(folder()).front().slot + QStringLiteral(".fff");
    const Result<io::LoadedDocument> loaded = io::readDocument(path);
    QVERIFY(loaded.has_value());
    QVERIFY(loaded->document == drawn);
}

void TestAutosave::recoveredWorkGoesOn()
{
    Program first(folder());
    first.draw();
    first.draw(10);
    first.pass(Autosave::kFirstDelay);
    const Document drawn = first.document();
    first.die();

    Program second(folder());
    const RecoveryEntry entry = listRecoverable(folder()).front();
    QVERIFY(second.autosave->adopt(entry).has_value());
    QVERIFY(second.document() == drawn);
    QVERIFY2(!second.session.isClean(), "it is on no disk of the person's");
    QVERIFY2(listRecoverable(folder()).isEmpty(), "it is open");
    second.draw(20);
    second.pass(Autosave::kDefaultInterval);
    const Document further = second.document();
    second.die();
    const QList<RecoveryEntry> entries = listRecoverable(folder());
    QCOMPARE(entries.size(), 1);
    QCOMPARE(entries.front().steps, 3);
    QVERIFY(readRecoverable(entries.front())->document == further);
}

void TestAutosave::aSlotOpensOnce()
{
    Program first(folder());
    first.draw();
    first.die();
    const RecoveryEntry entry = listRecoverable(folder()).front();
    Program second(folder()), third(folder());
    QVERIFY(second.autosave->adopt(entry).has_value());
    const auto again = third.autosave->adopt(entry);
    QVERIFY(!again);
    QCOMPARE(again.error().code, ErrorCode::CannotOpen);
    QVERIFY(!discardRecoverable(entry));
    QVERIFY2(third.session.isClean(), "nothing was changed");
    second.session.setClean();
    second.die();
    QVERIFY(filesIn(folder()).isEmpty());
}

void TestAutosave::anotherDocumentLeavesNoSlot()
{
    Program first(folder());
    first.draw();
    first.die();
    Program second(folder());
    QVERIFY(second.autosave->adopt(listRecoverable(folder()).front()).has_value());
    second.session.reset(newDocument());
    QVERIFY2(second.session.isClean(), "a new document is no recovered one");
    second.die();
    QVERIFY(filesIn(folder()).isEmpty());
}

void TestAutosave::whatACrashLeftIsOffered_data()
{
    QTest::addColumn<QByteArray>("lock");
    QTest::newRow("killed before it had written its number") << QByteArray();
    const QByteArray number = QByteArray::number(QCoreApplication::applicationPid());
    QTest::newRow("another program has its number now")
        << number + "\n" + QCoreApplication::applicationName().toUtf8() + "\n\n";
}

// Wrong: a copy is there, and nobody is told.
void TestAutosave::whatACrashLeftIsOffered()
{
    QFETCH(QByteArray, lock);
    Program program(folder());
    program.draw();
    program.die();
    const QString slot = listRecoverable(folder()).front().slot;
    put(slot + QStringLiteral(".lock"), lock);
    const QList<RecoveryEntry> entries = listRecoverable(folder());
    QCOMPARE(entries.size(), 1);
    Program next(folder());
    QVERIFY(next.autosave->adopt(entries.front()).has_value());
}

void TestAutosave::brokenSlots_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("kept"); // where it is then; empty: nowhere
    QTest::addColumn<bool>("isTold");
    const QString aside = QStringLiteral("damaged/a.fff");
    const auto damaged = [&](const char *name, const QByteArray &bytes) {
        QTest::newRow(name) << "a.fff" << bytes << aside << true;
    };
    const QByteArray whole =
        QByteArray::fromStdString(io::writeFff(withPlate(newDocument(), 0)).value());
    damaged("an empty document", {});
    damaged("a document of one byte", "{");
    damaged("half a document", "{\"format\": \"FlatFit");
    damaged("a document that was cut off", whole.left(whole.size() / 2));
    damaged("a stock without a thickness",
            QByteArray(whole).replace("\"thickness\": 3", "\"thickness\": 0"));
    damaged("no model", QByteArray("\x89PNG\0\0", 6));
    damaged("a ZIP of too many entries",
            QByteArray::fromStdString(test::MadeArchive::of(
                {test::MadeEntry::stored("document.json", whole.toStdString())}, 65'535)));
    QTest::newRow("a copy that was being written")
        << "a.fff.Xy12ab" << QByteArray("{}") << QString() << false;
    QTest::newRow("the lock of a program that is gone")
        << "a.lock" << QByteArray("999999999\nflatfitfab\n\n") << QString() << false;
    QTest::newRow("a document of a newer version")
        << "a.fff" << QByteArray("{\"format\": \"FlatFitFab\", \"version\": 99}") << "a.fff"
        << true;
    QTest::newRow("a file of somebody else")
        << "notes.txt" << QByteArray("notes") << "notes.txt" << false;
}

void TestAutosave::brokenSlots()
{
    QFETCH(QString, file);
    QFETCH(QByteArray, bytes);
    QFETCH(QString, kept);
    QFETCH(bool, isTold);
    QVERIFY(QDir().mkpath(folder()));
    put(QDir(folder()).filePath(file), bytes);
    QVERIFY(listRecoverable(folder()).isEmpty());
    const QList<UnreadableWork> works = setUnreadableAside(folder());
    QVERIFY(listRecoverable(folder()).isEmpty());
    QCOMPARE(works.size(), isTold ? 1 : 0);
    const QString path = QDir(folder()).filePath(kept);
    QVERIFY(!isTold || works.front().path == path);
    if (!kept.isEmpty())
        QCOMPARE(io::readFile(path).value(), bytes.toStdString());
    QCOMPARE(filesIn(folder()), kept == file ? QStringList(file) : QStringList());
    // Wrong: it is told at each start, or moved on and on.
    QCOMPARE(setUnreadableAside(folder()).size(), isTold && kept == file ? 1 : 0);
    QVERIFY(kept.isEmpty() || QFile::exists(path));
}

// Wrong: pictures of what could still be mended by hand are gone; an earlier copy is replaced.
void TestAutosave::damagedSlotsKeepTheirBlobs()
{
    const QString slot = QDir(folder()).filePath(QStringLiteral("a"));
    for (const QByteArray bytes : {"first", "second"}) {
        QVERIFY(QDir().mkpath(blobsOf(slot)));
        put(pathOf(slot, "one"), bytes);
        put(slot + QStringLiteral(".fff"), bytes);
        QCOMPARE(setUnreadableAside(folder()).size(), 1);
    }
    QVERIFY(listRecoverable(folder()).isEmpty());
    const QString aside = QDir(folder()).filePath(QStringLiteral("damaged/a"));
    for (const auto &[to, bytes] :
         {std::pair(aside, "first"), std::pair(aside + QStringLiteral("-2"), "second")}) {
        QCOMPARE(io::readFile(to + QStringLiteral(".fff")).value(), std::string(bytes));
        QCOMPARE(io::readFile(pathOf(to, "one")).value(), std::string(bytes));
    }
}

// Wrong: what somebody writes just now is taken from under their hands.
void TestAutosave::whatIsHeldIsNotSetAside()
{
    const QString slot = QDir(folder()).filePath(QStringLiteral("a"));
    QVERIFY(QDir().mkpath(folder()));
    const auto held = RecoverySlot::take(slot);
    put(slot + QStringLiteral(".fff"), "{");
    QVERIFY(held && setUnreadableAside(folder()).isEmpty());
    QVERIFY(QFile::exists(slot + QStringLiteral(".fff")));
}

// Wrong: a file elsewhere is taken for a copy, or what leads to it goes.
void TestAutosave::linksAreLeftAlone()
{
    QVERIFY(QDir().mkpath(folder()));
    const QDir elsewhere(m_folder->path());
    put(elsewhere.filePath(QStringLiteral("mine.fff")), "{");
    const QStringList links{folder() + QStringLiteral("/a.fff"),
                            folder() + QStringLiteral("/b.fff"),
                            folder() + QStringLiteral("/c.blobs")};
    QVERIFY(QFile::link(elsewhere.filePath(QStringLiteral("mine.fff")), links[0]));
    QVERIFY(QFile::link(elsewhere.filePath(QStringLiteral("nowhere.fff")), links[1]));
    QVERIFY(QFile::link(elsewhere.path(), links[2]));
    put(folder() + QStringLiteral("/b.lock"), "");
    QVERIFY(listRecoverable(folder()).isEmpty());
    QVERIFY(setUnreadableAside(folder()).isEmpty());
    for (const QString &link : links)
        QVERIFY2(QFileInfo(link).isSymLink(), qPrintable(link));
    QVERIFY(QFile::exists(elsewhere.filePath(QStringLiteral("mine.fff"))));
}

// A copy may be the very file that somebody put there by hand.
void TestAutosave::aPackedDocumentIsOffered()
{
    QVERIFY(QDir().mkpath(folder()));
    const Document document =
        addBlob(withPlate(newDocument(), 0), io::makeBlob("one", "image/png", "fish.png"));
    put(folder() + QStringLiteral("/a.fff"),
        QByteArray::fromStdString(io::writeFffFile(document).value()));
    QVERIFY(setUnreadableAside(folder()).isEmpty());
    const QList<RecoveryEntry> entries = listRecoverable(folder());
    QCOMPARE(entries.size(), 1);
    QVERIFY(readRecoverable(entries.front())->document == document);
}

void TestAutosave::aFullFolderIsToldOnceAndTriedAgain()
{
    put(folder(), "a file where the folder should be");
    Program program(folder());
    QSignalSpy failed(program.autosave.get(), &Autosave::failed);
    program.draw();
    program.pass(Autosave::kFirstDelay);
    QTRY_COMPARE(failed.count(), 1);
    for (int i = 0; i < 3; ++i) {
        program.pass(Autosave::kDefaultInterval);
        program.autosave->flush();
    }
    QCOMPARE(failed.count(), 1);
    QVERIFY(QFile::remove(folder()));
    program.pass(Autosave::kDefaultInterval); // without another step
    QTRY_COMPARE(program.kept.size(), 1u);
    QVERIFY(program.kept.front() == program.document());
}

void TestAutosave::blobsAreKeptBesideTheText()
{
    Program program(folder());
    program.draw();
    addPicture(program, "one");
    addPicture(program, "two");
    const Document drawn = program.document();
    program.die();
    const QList<RecoveryEntry> entries = listRecoverable(folder());
    QCOMPARE(entries.size(), 1);
    const QString slot = entries.front().slot;
    QStringList names{QFileInfo(pathOf(slot, "one")).fileName(),
                      QFileInfo(pathOf(slot, "two")).fileName()};
    names.sort();
    QCOMPARE(filesIn(blobsOf(slot)), names);
    QFile text(slot + QStringLiteral(".fff"));
    QVERIFY(text.open(QIODevice::ReadOnly));
    QVERIFY2(text.read(1) == "{", "a slot is text");
    const auto read = readRecoverable(entries.front());
    QVERIFY(read && read->warnings.empty());
    QVERIFY(read->document == drawn);

    Program second(folder());
    const auto adopted = second.autosave->adopt(entries.front());
    QVERIFY(adopted && adopted->empty());
    QVERIFY(second.document() == drawn);
    QVERIFY(*second.document().blobs.front()->bytes == *drawn.blobs.front()->bytes);
}

// Wrong: a mesh of a hundred megabytes is written every ten seconds.
void TestAutosave::blobsAreWrittenOnce()
{
    Program program(folder());
    addPicture(program, "one");
    program.pass(Autosave::kFirstDelay);
    QTRY_COMPARE(program.kept.size(), 1u);
    const QString slot = slotIn(folder());
    put(pathOf(slot, "one"), "ONE"); // which nobody else would
    program.draw();
    program.autosave->flush();
    QCOMPARE(program.kept.size(), 2u);
    QFile file(pathOf(slot, "one"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), QByteArray("ONE"));
    put(pathOf(slot, "one"), "half of it");
    program.draw(10);
    program.autosave->flush();
    QFile again(pathOf(slot, "one"));
    QVERIFY(again.open(QIODevice::ReadOnly));
    QVERIFY2(again.readAll() == "one", "what is not whole is written again");
}

void TestAutosave::blobsGoWithWhatRefersToThem()
{
    Program program(folder());
    program.draw();
    addPicture(program, "one");
    program.autosave->flush();
    const QString slot = slotIn(folder());
    addPicture(program, "two");
    program.autosave->flush();
    QCOMPARE(filesIn(blobsOf(slot)).size(), 2);
    program.session.history()->undo();
    program.autosave->flush();
    QCOMPARE(filesIn(blobsOf(slot)), QStringList(QFileInfo(pathOf(slot, "one")).fileName()));
    program.session.history()->undo();
    program.autosave->flush();
    QVERIFY2(!QFileInfo::exists(blobsOf(slot)), "without any there is no folder");
    program.session.history()->redo();
    program.autosave->flush();
    QVERIFY(QFileInfo::exists(pathOf(slot, "one")));
    program.session.setClean();
    program.die();
    QVERIFY(QDir(folder()).isEmpty());
}

void TestAutosave::lostBlobsCostOnlyThemselves_data()
{
    QTest::addColumn<QString>("what");
    QTest::addColumn<QString>("sentence");
    QTest::newRow("missing") << "missing"
                             << "fish.png was left out: its data is missing";
    QTest::newRow("half of it") << "t"
                                << "fish.png was left out: its data is damaged";
    QTest::newRow("other bytes") << "TWO"
                                 << "fish.png was left out: its data is damaged";
}

void TestAutosave::lostBlobsCostOnlyThemselves()
{
    QFETCH(QString, what);
    QFETCH(QString, sentence);
    Program first(folder());
    first.draw();
    addPicture(first, "one");
    const Document before = first.document();
    addPicture(first, "two");
    first.die();
    const RecoveryEntry entry = listRecoverable(folder()).front();
    const QString path = pathOf(entry.slot, "two");
    if (what == QStringLiteral("missing"))
        QVERIFY(QFile::remove(path));
    else
        put(path, what.toLatin1());
    QCOMPARE(listRecoverable(folder()).size(), 1);
    Program second(folder());
    const auto adopted = second.autosave->adopt(entry);
    QVERIFY(adopted);
    QCOMPARE(adopted->size(), 1u);
    QVERIFY2(io::warningText(adopted->front()).endsWith(sentence),
             qPrintable(io::warningText(adopted->front())));
    QVERIFY2(second.document() == before, "all but that picture is there");
    second.draw(10);
    second.autosave->flush();
    QCOMPARE(filesIn(blobsOf(entry.slot)).size(), 1);
}

void TestAutosave::blobsWithoutADocumentAreWaste()
{
    const QString slot = QDir(folder()).filePath(QStringLiteral("a"));
    QVERIFY(QDir().mkpath(blobsOf(slot)));
    put(pathOf(slot, "one"), "one");
    QVERIFY(listRecoverable(folder()).isEmpty());
    QVERIFY(QDir(folder()).isEmpty());
}

FFF_TEST(TestAutosave)
#include "tst_autosave.moc"
