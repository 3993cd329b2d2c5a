#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/model/edits.h"
#include "core/session/latest_job.h"
#include "core/session/session.h"
#include "core/session/session_host.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"

#include <QSignalSpy>

#include <atomic>
#include <stdexcept>

using namespace fff;
using namespace fff::test;

namespace {

/// Every change that a session announces.
struct Changes
{
    explicit Changes(Session &session)
    {
        QObject::connect(&session, &Session::modelChanged, &listener,
                         [this](const Model &before, const Model &after) {
                             pairs.emplace_back(&before, &after);
                         });
    }
    QObject listener;
    std::vector<std::pair<const Model *, const Model *>> pairs;
};

void draw(Session &session, int count)
{
    for (int i = 0; i < count; ++i)
        session.commit(QStringLiteral("Draw"), withPlate(session.committed().document, i));
}

} // namespace

class TestSession : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void undoGivesBackTheVeryObjects();
    void jumpAnnouncesOnce();
    void nothingIsNoStep();
    void previewLeavesNoTrace();
    void previewEndsWithUndo();
    void commitOfThePreviewIsQuiet();
    void resetStartsAnew();
    void cleanFollowsTheHistory();
    void savedIsWhatWasWritten_data();
    void savedIsWhatWasWritten();
    void aStrokeGoesOnAfterACommittedPreview();
    void revisionCountsEveryChange();
    void analysisBelongsToItsRevision();
    void goneWhileTheJobRuns();
    void latestJobDropsWhatIsOutdated();
};

void TestSession::undoGivesBackTheVeryObjects()
{
    Session session;
    const Model *empty = &session.model();
    draw(session, 2);
    const Model *drawn = &session.model();
    const Section *first = drawn->section(0).get();
    session.history()->undo();
    QCOMPARE(session.model().section(0).get(), first);
    session.history()->redo();
    QCOMPARE(&session.model(), drawn);
    session.history()->setIndex(0);
    QCOMPARE(&session.model(), empty);
    QCOMPARE(&session.committed(), empty);
}

void TestSession::jumpAnnouncesOnce()
{
    Session session;
    const Model *empty = &session.model();
    draw(session, 5);
    const Model *last = &session.model();
    Changes changes(session);
    session.history()->setIndex(0);
    QCOMPARE(changes.pairs.size(), std::size_t(1));
    QCOMPARE(changes.pairs[0].first, last);
    QCOMPARE(changes.pairs[0].second, empty);
    session.history()->setIndex(5);
    QCOMPARE(changes.pairs.size(), std::size_t(2));
    QCOMPARE(changes.pairs[1].second, last);
}

void TestSession::nothingIsNoStep()
{
    Session session;
    draw(session, 1);
    Changes changes(session);
    session.commit(QStringLiteral("Nothing"), session.committed().document);
    QCOMPARE(session.history()->count(), 1);
    QVERIFY(changes.pairs.empty());
}

void TestSession::previewLeavesNoTrace()
{
    Session session;
    draw(session, 1);
    const Model *committed = &session.committed();
    Changes changes(session);
    session.preview(withPlate(committed->document));
    QVERIFY(session.hasPreview());
    QCOMPARE(session.model().sectionCount(), std::size_t(2));
    QCOMPARE(&session.committed(), committed);
    session.cancelPreview();
    QVERIFY(!session.hasPreview());
    QCOMPARE(&session.model(), committed);
    QCOMPARE(session.history()->count(), 1);
    QCOMPARE(changes.pairs.size(), std::size_t(2));
    session.cancelPreview(); // none runs: nothing to say
    QCOMPARE(changes.pairs.size(), std::size_t(2));
}

void TestSession::previewEndsWithUndo()
{
    Session session;
    draw(session, 1);
    session.preview(withPlate(session.committed().document));
    const Model *preview = &session.model();
    Changes changes(session);
    session.history()->undo();
    QVERIFY(!session.hasPreview());
    QCOMPARE(changes.pairs.size(), std::size_t(1));
    QCOMPARE(changes.pairs[0].first, preview);
    QCOMPARE(session.model().sectionCount(), std::size_t(0));
}

/// The preview becomes the section without a jump.
void TestSession::commitOfThePreviewIsQuiet()
{
    Session session;
    const Document next = withPlate(session.committed().document);
    session.preview(next);
    const Model *preview = &session.model();
    Changes changes(session);
    session.commit(QStringLiteral("Draw"), next);
    QCOMPARE(&session.model(), preview);
    QCOMPARE(&session.committed(), preview);
    QVERIFY(!session.hasPreview());
    QVERIFY(changes.pairs.empty());
    QCOMPARE(session.history()->count(), 1);
    session.history()->undo();
    QCOMPARE(changes.pairs.size(), std::size_t(1));
}

void TestSession::resetStartsAnew()
{
    Session session;
    draw(session, 3);
    session.history()->undo();
    Changes changes(session);
    session.reset(withPlate(newDocument()));
    QCOMPARE(changes.pairs.size(), std::size_t(1));
    QCOMPARE(session.history()->count(), 0);
    QVERIFY(session.isClean());
    QCOMPARE(session.model().sectionCount(), std::size_t(1));
}

void TestSession::cleanFollowsTheHistory()
{
    Session session;
    QVERIFY(session.isClean());
    QSignalSpy spy(&session, &Session::cleanChanged);
    draw(session, 2);
    QVERIFY(!session.isClean());
    session.setClean();
    QVERIFY(session.isClean());
    session.history()->undo();
    QVERIFY(!session.isClean());
    session.history()->redo();
    QVERIFY(session.isClean());
    QCOMPARE(spy.count(), 4);
}

void TestSession::savedIsWhatWasWritten_data()
{
    QTest::addColumn<int>("written");   // the step that is being written
    QTest::addColumn<int>("before");    // the step that was clean then
    QTest::addColumn<int>("now");       // the step that is shown when it is on disk
    QTest::addColumn<int>("cleanStep"); // -1: none
    QTest::newRow("nothing happened meanwhile") << 2 << 0 << 2 << 2;
    QTest::newRow("a section was drawn meanwhile") << 2 << 0 << 3 << 2;
    QTest::newRow("two steps were undone meanwhile") << 3 << 1 << 1 << 3;
    QTest::newRow("undone to what the file held before") << 2 << 0 << 0 << 2;
}

/// What is edited while a file is being written is not in it: closing must ask, and only the step
/// that was written may say that there is nothing to lose.
void TestSession::savedIsWhatWasWritten()
{
    QFETCH(int, written);
    QFETCH(int, before);
    QFETCH(int, now);
    QFETCH(int, cleanStep);
    Session session;
    draw(session, 3);
    QUndoStack &history = *session.history();
    history.setIndex(before);
    session.setClean();
    history.setIndex(written);
    const Document document = session.committed().document;
    history.setIndex(now);

    const Model *shown = &session.model();
    Changes changes(session);
    QSignalSpy steps(&history, &QUndoStack::indexChanged);
    bool saidClean = session.isClean();
    connect(&session, &Session::cleanChanged, this, [&](bool clean) { saidClean = clean; });
    session.setSaved(document);
    QCOMPARE(&session.model(), shown);
    QVERIFY(changes.pairs.empty());
    QCOMPARE(steps.count(), 0);
    QCOMPARE(session.isClean(), now == cleanStep);
    QCOMPARE(saidClean, session.isClean());
    for (int step = 0; step <= 3; ++step) {
        history.setIndex(step);
        QCOMPARE(session.isClean(), step == cleanStep);
    }
    history.setIndex(1);
    session.commit(QStringLiteral("Draw"), withPlate(session.committed().document, 9.0));
    session.setSaved(document);
    const bool isThere = cleanStep <= 1; // the steps above were given up for the new one
    for (int step = 0; step <= 2; ++step) {
        history.setIndex(step);
        QCOMPARE(session.isClean(), isThere && step == cleanStep);
    }
}

/// Dragging the thickness previews what is then committed. The interaction must hear of that, or
/// takes the first preview of the next stroke for an edit by someone else and gives the stroke up.
void TestSession::aStrokeGoesOnAfterACommittedPreview()
{
    Session session;
    SessionHost host(session);
    Interaction interaction(host);
    host.attach(interaction);
    interaction.setViewport({1000.0, 800.0});
    const Document &document = session.committed().document;
    Stock stock = *document.stocks.front();
    stock.thickness = 5.0;
    const Document thicker = *setStock(document, stock);
    session.preview(thicker);
    session.commit(QStringLiteral("Thicker"), thicker);

    const std::vector<Vec2> way{{400, 300}, {600, 300}, {600, 500}, {400, 500}, {400, 320}};
    PointerEvent event;
    event.type = PointerEvent::Type::Press;
    event.button = Button::Left;
    event.position = way.front();
    interaction.handle(event);
    event.type = PointerEvent::Type::Move;
    for (std::size_t i = 1; i < way.size(); ++i) {
        for (int part = 1; part <= 10; ++part) {
            event.time += 10.0;
            event.position = way[i - 1] + (way[i] - way[i - 1]) * (part / 10.0);
            interaction.handle(event);
        }
    }
    QVERIFY(interaction.hasGesture());
    event.type = PointerEvent::Type::Release;
    interaction.handle(event);
    QCOMPARE(session.committed().sectionCount(), std::size_t(1));
    QCOMPARE(session.history()->count(), 2);
}

void TestSession::revisionCountsEveryChange()
{
    Session session;
    const std::uint64_t start = session.revision();
    draw(session, 1);
    session.preview(withPlate(session.committed().document));
    session.cancelPreview();
    session.history()->undo();
    QCOMPARE(session.revision(), start + 4);
}

void TestSession::analysisBelongsToItsRevision()
{
    Session session;
    QCOMPARE(session.analysedRevision(), session.revision());
    QVERIFY(session.analysis().cuts.empty());
    draw(session, 3);
    const Analysis &current = session.currentAnalysis();
    QCOMPARE(session.analysedRevision(), session.revision());
    QCOMPARE(current.cuts.size(), std::size_t(3));
    QVERIFY(current.model.document.isSame(session.model().document));

    QSignalSpy spy(&session, &Session::analysisChanged);
    session.history()->undo();
    QVERIFY(spy.wait());
    QTRY_COMPARE(session.analysedRevision(), session.revision());
    QCOMPARE(session.analysis().cuts.size(), std::size_t(2));
}

void TestSession::goneWhileTheJobRuns()
{
    for (int i = 0; i < 20; ++i) {
        Session session;
        draw(session, 4);
    }
    QCoreApplication::processEvents(); // what the workers posted finds nobody
}

void TestSession::latestJobDropsWhatIsOutdated()
{
    std::atomic<int> running = 0, most = 0, runs = 0;
    std::vector<std::uint64_t> published;
    LatestJob<int, int> job(
        [&](const int &input) {
            most = std::max(most.load(), ++running);
            ++runs;
            QTest::qSleep(20);
            --running;
            return 2 * input;
        },
        [&](std::uint64_t revision, int output) {
            QCOMPARE(output, 2 * static_cast<int>(revision));
            published.push_back(revision);
        });
    for (int i = 1; i <= 50; ++i)
        job.request(static_cast<std::uint64_t>(i), i);
    job.finish();
    QVERIFY(!job.isBusy());
    QCOMPARE(published, (std::vector<std::uint64_t>{1, 50}));
    QCOMPARE(runs.load(), 2);
    QCOMPARE(most.load(), 1);
    job.request(51, 51);
    QTRY_COMPARE(published.back(), std::uint64_t(51));
}

FFF_TEST(TestSession)
#include "tst_session.moc"
