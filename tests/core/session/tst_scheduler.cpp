#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/analysed.h"
#include "core/analysis/mends.h"
#include "core/analysis/planned.h"
#include "core/analysis/verdicts.h"
#include "core/operations/evaluate.h"
#include "core/session/finding_text.h"
#include "core/session/scheduler.h"
#include "tests/core/assembly/known_models.h"
#include "tests/core/session/all_findings.h"
#include "tests/core/session/random_edits.h"
#include "tests/rounds.h"
#include "tests/test_program.h"

#include <QSignalSpy>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

using namespace fff;
using namespace fff::test;

namespace {

ModelPointer modelOf(int sections)
{
    Document document = newDocument();
    for (int i = 0; i < sections; ++i)
        document = withSection(document, polygonShape(rectangle(-50, 0, 50, 60)), front(20.0 * i));
    return std::make_shared<const Model>(evaluate(document));
}

/// A solver that does not exist: it counts sections, and does what it is told to.
struct Counted
{
    int sections = 0;
    int runs = 0; // its memory of the time before
};
constexpr StageOf<Counted> kCounted{"counted"};
constexpr StageOf<Counted> kDoubled{"doubled"};

class Solver
{
public:
    enum class Does { Count, Fail, Throw, ThrowAnything, WaitForStop };
    std::atomic<Does> does = Does::Count;
    std::atomic<int> running = 0, most = 0, runs = 0;
    std::atomic<bool> holds = false; // until it is let go
    std::atomic<bool> hasSeenStop = false;

    Result<Counted> operator()(const Snapshot &snapshot, const Counted *previous,
                               Progress &progress, std::stop_token stop)
    {
        most = std::max(most.load(), ++running);
        const auto leave = std::shared_ptr<void>(nullptr, [this](void *) { --running; });
        ++runs;
        progress.set(0.5);
        while (holds && !stop.stop_requested())
            std::this_thread::yield();
        switch (does) {
        case Does::Count:
            break;
        case Does::Fail:
            return failure(ErrorCode::NotSolid, {}, {"Rib"});
        case Does::Throw:
            throw std::runtime_error("out of luck");
        case Does::ThrowAnything:
            throw 7;
        case Does::WaitForStop:
            while (!stop.stop_requested())
                std::this_thread::yield();
            hasSeenStop = true;
            return failure(ErrorCode::Cancelled);
        }
        return Counted{static_cast<int>(snapshot.get(kModel).sectionCount()),
                       previous ? previous->runs + 1 : 1};
    }
};

/// One line a stage, as in stages.cpp.
std::vector<Stage> stagesWith(Solver &solver, Stage::Runs runs = Stage::Runs::Always)
{
    return {
        makeStage(kCounted, FFF_TEXT("Stage", "Counting"), {kModel.name}, runs, std::ref(solver)),
        makeStage(kDoubled, FFF_TEXT("Stage", "Doubling"), {kCounted.name}, Stage::Runs::Always,
                  [](const Snapshot &snapshot, const Counted *, Progress &,
                     std::stop_token) -> Result<Counted> {
                      return Counted{2 * snapshot.get(kCounted).sections, 0};
                  })};
}

} // namespace

class TestScheduler : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void resultsFollowOneFromAnother();
    void theNewestRequestWins();
    void thereAndBackIsCurrent_data();
    void thereAndBackIsCurrent();
    void whatFailsSaysWhyAndKeepsWhatWasThere();
    void whatThrowsIsTriedAgainFromScratch();
    void whatTakesForEverIsStopped();
    void whatPassesIsLeftToThoseWhoWantIt();
    void anotherDocumentStopsWhatRuns();
    void onlyInputsAreThere();
    void agesAreSaid();
    void isGoneWhileAStageRuns();
    void whatNobodyWantsDoesNotRun();
    void tidyingForgetsWhatOnlySavesWork();
    void randomEditsWithCancels();
};

void TestScheduler::resultsFollowOneFromAnother()
{
    Solver solver;
    Scheduler scheduler(stagesWith(solver));
    scheduler.want(kDoubled.name);
    QVERIFY(!scheduler.result(kCounted));
    std::vector<std::string> published;
    connect(&scheduler, &Scheduler::published, this,
            [&](std::string_view stage) { published.emplace_back(stage); });
    scheduler.request(7, modelOf(3), false);
    scheduler.finish(kDoubled.name);
    QCOMPARE(scheduler.result(kDoubled)->sections, 6);
    QCOMPARE(scheduler.revisionOf(kDoubled.name), std::uint64_t(7));
    QCOMPARE(published, (std::vector<std::string>{"counted", "doubled"}));
    scheduler.request(7, modelOf(0), false);
    scheduler.finish();
    QCOMPARE(scheduler.result(kDoubled)->sections, 0);
}

void TestScheduler::theNewestRequestWins()
{
    Solver solver;
    solver.holds = true;
    Scheduler scheduler(stagesWith(solver));
    scheduler.want(kDoubled.name);
    for (int i = 1; i <= 50; ++i)
        scheduler.request(static_cast<std::uint64_t>(i), modelOf(i % 5), false);
    solver.holds = false;
    scheduler.finish();
    QCOMPARE(solver.runs.load(), 2);
    QCOMPARE(solver.most.load(), 1);
    QCOMPARE(scheduler.revisionOf(kCounted.name), std::uint64_t(50));
    QCOMPARE(scheduler.result(kCounted)->sections, 0);
    QCOMPARE(scheduler.result(kCounted)->runs, 2);
}

void TestScheduler::thereAndBackIsCurrent_data()
{
    QTest::addColumn<bool>("isSettled");
    QTest::addColumn<bool>("isPassing");
    QTest::newRow("undone and redone while it runs") << false << false;
    QTest::newRow("dragged and given up while it runs") << false << true;
    QTest::newRow("dragged and given up, for what does not follow drags") << true << true;
}

/// Wrong: the model that it runs with comes again as another revision, nothing is left to run, and
/// what follows from it waits for ever.
void TestScheduler::thereAndBackIsCurrent()
{
    QFETCH(bool, isSettled);
    QFETCH(bool, isPassing);
    Solver solver;
    Scheduler scheduler(
        stagesWith(solver, isSettled ? Stage::Runs::WhenSettled : Stage::Runs::Always));
    scheduler.want(kDoubled.name);
    const ModelPointer here = modelOf(2), there = modelOf(3);
    solver.holds = true;
    scheduler.request(1, here, false);
    scheduler.request(2, there, isPassing);
    scheduler.request(3, here, false);
    solver.holds = false;
    scheduler.finish();
    for (const std::string_view stage : {kCounted.name, kDoubled.name}) {
        QCOMPARE(scheduler.revisionOf(stage), std::uint64_t(3));
        QCOMPARE(scheduler.age(stage), Scheduler::Age::Current);
    }
    QCOMPARE(scheduler.result(kDoubled)->sections, 4);
    QCOMPARE(solver.runs.load(), 1);
    if (isSettled) { // and once it has been worked out
        scheduler.request(4, there, true);
        scheduler.request(5, here, false);
        scheduler.finish();
        QCOMPARE(scheduler.age(kDoubled.name), Scheduler::Age::Current);
        QCOMPARE(scheduler.revisionOf(kDoubled.name), std::uint64_t(5));
    }
}

void TestScheduler::whatFailsSaysWhyAndKeepsWhatWasThere()
{
    Solver solver;
    Scheduler scheduler(stagesWith(solver));
    scheduler.want(kDoubled.name);
    scheduler.request(1, modelOf(2), false);
    scheduler.finish();
    solver.does = Solver::Does::Fail;
    scheduler.request(2, modelOf(3), false);
    scheduler.finish();
    QCOMPARE(scheduler.failureOf(kCounted.name)->code, ErrorCode::NotSolid);
    QCOMPARE(scheduler.failureOf(kCounted.name)->args, std::vector<std::string>{"Rib"});
    QVERIFY(!scheduler.failureOf(kDoubled.name));
    QCOMPARE(scheduler.result(kCounted)->sections, 2);
    QCOMPARE(scheduler.revisionOf(kCounted.name), std::uint64_t(1));
    QVERIFY(scheduler.age(kCounted.name) != Scheduler::Age::Current);
    QVERIFY(scheduler.age(kDoubled.name) != Scheduler::Age::Current);
    QVERIFY(!scheduler.isRunning(kCounted.name));
    solver.does = Solver::Does::Count;
    scheduler.tryAgain(kCounted.name);
    QVERIFY(!scheduler.failureOf(kCounted.name));
    scheduler.finish();
    QCOMPARE(scheduler.result(kDoubled)->sections, 6);
    QCOMPARE(scheduler.age(kDoubled.name), Scheduler::Age::Current);
    QCOMPARE(scheduler.result(kCounted)->runs, 2); // it went on from what it had
}

/// It may have left what it keeps in the middle of something.
void TestScheduler::whatThrowsIsTriedAgainFromScratch()
{
    Solver solver;
    Scheduler scheduler(stagesWith(solver));
    scheduler.want(kDoubled.name);
    scheduler.request(1, modelOf(1), false);
    scheduler.finish();
    for (const auto does : {Solver::Does::Throw, Solver::Does::ThrowAnything}) {
        solver.does = does;
        QTest::ignoreMessage(QtWarningMsg, QRegularExpression(QStringLiteral("counted could not")));
        scheduler.request(scheduler.revisionOf(kCounted.name) + 1, modelOf(2), false);
        scheduler.finish();
        QCOMPARE(scheduler.failureOf(kCounted.name)->code, ErrorCode::StageFailed);
        QVERIFY(!scheduler.failureOf(kCounted.name)->args.front().empty());
        solver.does = Solver::Does::Count;
        scheduler.tryAgain(kCounted.name);
        scheduler.finish();
        QCOMPARE(scheduler.result(kCounted)->runs, 1);
    }
}

void TestScheduler::whatTakesForEverIsStopped()
{
    Solver solver;
    solver.does = Solver::Does::WaitForStop;
    Scheduler scheduler(stagesWith(solver));
    scheduler.want(kDoubled.name);
    QSignalSpy ticks(&scheduler, &Scheduler::progressed);
    scheduler.request(1, modelOf(1), false);
    QTRY_COMPARE(scheduler.progress(kCounted.name), 0.5);
    QTRY_VERIFY(ticks.count() > 0);
    QVERIFY(scheduler.isRunning(kCounted.name));
    scheduler.cancel(kCounted.name);
    scheduler.finish();
    QCOMPARE(scheduler.failureOf(kCounted.name)->code, ErrorCode::Cancelled);
    QVERIFY(!scheduler.isRunning(kCounted.name));
    QVERIFY(scheduler.progress(kCounted.name) < 0.0);
    // It is not begun anew until there is something new, or somebody wants it.
    scheduler.request(1, modelOf(0), false);
    QVERIFY(scheduler.isRunning(kCounted.name));
    scheduler.cancel(kCounted.name);
    scheduler.finish();
    solver.does = Solver::Does::Count;
    scheduler.tryAgain(kCounted.name);
    scheduler.finish();
    QVERIFY(!scheduler.failureOf(kCounted.name));
}

void TestScheduler::whatPassesIsLeftToThoseWhoWantIt()
{
    Solver solver;
    Scheduler scheduler(stagesWith(solver, Stage::Runs::WhenSettled));
    scheduler.want(kDoubled.name);
    const ModelPointer model = modelOf(4);
    scheduler.request(1, model, true);
    scheduler.finish();
    QCOMPARE(solver.runs.load(), 0);
    QCOMPARE(scheduler.age(kCounted.name), Scheduler::Age::Current);
    scheduler.request(1, model, false);
    scheduler.finish();
    QCOMPARE(solver.runs.load(), 1);
    QCOMPARE(scheduler.result(kDoubled)->sections, 8);
}

void TestScheduler::anotherDocumentStopsWhatRuns()
{
    Solver solver;
    solver.does = Solver::Does::WaitForStop;
    Scheduler scheduler(stagesWith(solver));
    scheduler.want(kDoubled.name);
    scheduler.request(1, modelOf(1), false);
    QTRY_COMPARE(solver.runs.load(), 1);
    scheduler.forget();
    QTRY_VERIFY(solver.hasSeenStop);
    solver.does = Solver::Does::Count;
    scheduler.request(2, modelOf(2), false);
    scheduler.finish();
    QVERIFY(!scheduler.failureOf(kCounted.name));
    QCOMPARE(scheduler.result(kCounted)->sections, 2);
}

/// A stage that takes what its line does not name would miss when that changes.
void TestScheduler::onlyInputsAreThere()
{
    Scheduler scheduler(
        {makeStage(kCounted, FFF_TEXT("Stage", "Counting"), {kRules.name}, Stage::Runs::Always,
                   [](const Snapshot &snapshot, const Counted *, Progress &,
                      std::stop_token) -> Result<Counted> {
                       return Counted{static_cast<int>(snapshot.get(kModel).sectionCount()), 0};
                   })});
    scheduler.want(kCounted.name);
    QTest::ignoreMessage(QtWarningMsg, QRegularExpression(QStringLiteral("counted could not")));
    scheduler.request(1, modelOf(1), false);
    scheduler.finish();
    QCOMPARE(scheduler.failureOf(kCounted.name)->code, ErrorCode::StageFailed);
}

void TestScheduler::agesAreSaid()
{
    Solver solver;
    Scheduler scheduler(stagesWith(solver));
    scheduler.want(kDoubled.name);
    scheduler.request(1, modelOf(1), false);
    scheduler.finish();
    QCOMPARE(scheduler.age(kCounted.name), Scheduler::Age::Current);
    solver.holds = true;
    scheduler.request(2, modelOf(2), false);
    QCOMPARE(scheduler.age(kCounted.name), Scheduler::Age::Current); // nobody saw it yet
    QTRY_COMPARE(scheduler.age(kCounted.name), Scheduler::Age::Older);
    QTRY_COMPARE(scheduler.age(kCounted.name), Scheduler::Age::Late);
    solver.holds = false;
    QTRY_COMPARE(scheduler.age(kDoubled.name), Scheduler::Age::Current);
}

void TestScheduler::isGoneWhileAStageRuns()
{
    for (int i = 0; i < 20; ++i) {
        Solver solver;
        solver.does = Solver::Does::WaitForStop;
        Scheduler scheduler(stagesWith(solver));
        scheduler.want(kDoubled.name);
        scheduler.want(kDoubled.name);
        scheduler.request(1, modelOf(1), false);
    }
    QCoreApplication::processEvents(); // what the workers posted finds nobody
}

/// A script that is replayed has no use for a plan of each of its steps.
void TestScheduler::whatNobodyWantsDoesNotRun()
{
    Solver solver;
    Scheduler scheduler(stagesWith(solver));
    scheduler.request(1, modelOf(1), false);
    scheduler.finish();
    QCOMPARE(solver.runs.load(), 0);
    scheduler.want(kCounted.name);
    scheduler.finish();
    QCOMPARE(solver.runs.load(), 1);
    QVERIFY(!scheduler.result(kDoubled));
}

/// Its result stays; while something runs nothing is taken from it.
void TestScheduler::tidyingForgetsWhatOnlySavesWork()
{
    struct Keeping
    {
        int sections = 0;
        std::shared_ptr<std::optional<int>> memory = {}; // of the time before
        void tidy() const { memory->reset(); }
    };
    constexpr StageOf<Keeping> kKeeping{"keeping"};
    Solver solver;
    std::vector<Stage> stages = stagesWith(solver);
    stages.push_back(
        makeStage(kKeeping, FFF_TEXT("Stage", "Keeping"), {kModel.name}, Stage::Runs::Always,
                  [](const Snapshot &snapshot, const Keeping *, Progress &,
                     std::stop_token) -> Result<Keeping> {
                      const int sections = static_cast<int>(snapshot.get(kModel).sectionCount());
                      return Keeping{sections, std::make_shared<std::optional<int>>(sections)};
                  }));
    Scheduler scheduler(std::move(stages));
    scheduler.want(kKeeping.name);
    scheduler.want(kCounted.name);
    solver.holds = true;
    scheduler.request(1, modelOf(2), false);
    scheduler.finish(kKeeping.name);
    scheduler.tidy(); // the solver runs
    QCOMPARE(*scheduler.result(kKeeping)->memory, std::optional(2));
    solver.holds = false;
    scheduler.finish();
    scheduler.tidy();
    QCOMPARE(*scheduler.result(kKeeping)->memory, std::optional<int>());
    QCOMPARE(scheduler.result(kKeeping)->sections, 2);
}

/// What a person sees after any edits and any stops is what follows from the document alone.
void TestScheduler::randomEditsWithCancels()
{
    std::mt19937 random(4);
    const auto below = [&random](int limit) {
        return std::uniform_int_distribution<int>(0, limit - 1)(random);
    };
    const auto wantAll = [](Scheduler &of) {
        for (const Stage &stage : of.stages())
            of.want(stage.name);
    };
    Scheduler scheduler;
    wantAll(scheduler);
    CheckRules patient;
    patient.planningTime = std::chrono::minutes(10); // else what is found depends on the clock
    scheduler.setRules(patient);
    RandomEdits edits(17);
    Document document = newDocument();
    ModelPointer model;
    for (int i = 1; i <= rounds(10000); ++i) {
        document = i % 40 == 0 ? newDocument() : edits.next(document);
        model = std::make_shared<const Model>(evaluate(document));
        if (below(50) == 0)
            scheduler.forget();
        scheduler.request(static_cast<std::uint64_t>(i), model, below(4) != 0);
        if (below(3) == 0)
            scheduler.cancel(scheduler
                                 .stages()[static_cast<std::size_t>(
                                     below(static_cast<int>(scheduler.stages().size())))]
                                 .name);
        if (below(10) == 0)
            QCoreApplication::processEvents();
        if (below(10) == 0)
            scheduler.tidy();
        if (i % 250 != 0)
            continue;
        scheduler.request(static_cast<std::uint64_t>(i), model, false);
        for (int again = 0; again < 2; ++again) {
            scheduler.finish();
            for (const Stage &stage : scheduler.stages())
                if (scheduler.failureOf(stage.name)) {
                    QCOMPARE(scheduler.failureOf(stage.name)->code, ErrorCode::Cancelled);
                    scheduler.tryAgain(stage.name);
                    scheduler.finish();
                }
        }
        Scheduler fresh;
        wantAll(fresh);
        fresh.setRules(patient);
        fresh.request(static_cast<std::uint64_t>(i), model, false);
        fresh.finish();
        for (const Stage &stage : scheduler.stages()) {
            QVERIFY2(!scheduler.failureOf(stage.name), stage.name.data());
            QCOMPARE(scheduler.revisionOf(stage.name), static_cast<std::uint64_t>(i));
            QCOMPARE(scheduler.age(stage.name), Scheduler::Age::Current);
        }
        const auto sentences = [](const Scheduler &of) {
            std::vector<Finding> all = of.result(kVerdicts)->findings;
            const std::vector<Finding> &planned = of.result(kPlanned)->findings;
            all.insert(all.end(), planned.begin(), planned.end());
            QStringList lines;
            for (const Finding &finding : all) {
                lines += findingText(finding, of.result(kAnalysed)->analysis->model);
                if (const auto *mends = of.result(kMends)->of(finding))
                    for (const Mend &mend : *mends)
                        lines += messageText(mend.action.kind->words(
                            mend.action, finding, of.result(kAnalysed)->analysis->model));
            }
            return lines;
        };
        QVERIFY(document.sections.empty() || !sentences(fresh).empty());
        QCOMPARE(sentences(scheduler), sentences(fresh));
    }
}

FFF_TEST(TestScheduler)
#include "tst_scheduler.moc"
