#include "core/session/scheduler.h"

#include "core/analysis/nested.h"
#include "core/session/journal.h"

#include <QTimer>

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

namespace fff {

namespace {

// ms. Most answers come sooner than the eye sees a change; saying in between that they are older
// would only flicker.
constexpr int kSeen = 100, kLate = 500;
/// ms between two looks at how far something has come.
constexpr int kTick = 200;

Questions withoutSheets(Questions questions)
{
    questions.sheets.reset();
    return questions;
}

using AnyResult = Result<std::shared_ptr<const void>>;

/// What a run came to.
struct Outcome
{
    std::size_t desk = 0; // of the stage
    std::uint64_t revision = 0;
    int generation = 0; // of the document
    AnyResult result;
    bool hasThrown = false;
};

AnyResult guarded(const Stage &stage, const Snapshot &snapshot, const void *previous,
                  Progress &progress, const std::stop_token &stop, bool &hasThrown)
{
    try {
        return stage.compute(snapshot, previous, progress, stop);
    } catch (const std::exception &exception) {
        hasThrown = true;
        return failure(ErrorCode::StageFailed, {}, {exception.what()});
    } catch (...) {
        hasThrown = true;
        return failure(ErrorCode::StageFailed, {}, {"unknown exception"});
    }
}

} // namespace

class Scheduler::Private
{
public:
    Private(Scheduler *scheduler, std::vector<Stage> all);

    /// A stage and where it stands.
    struct Desk
    {
        const Stage *stage = nullptr;
        std::vector<Desk *> inputs;          // that its line names
        std::vector<std::string_view> given; // the others of them
        std::shared_ptr<const void> result;
        std::uint64_t revision = 0;           // of the result
        std::optional<Error> why;             // of the inputs `started`
        Snapshot::Results started;            // with which it ran last, or runs
        std::shared_ptr<const void> previous; // what the next run may use
        bool isWanted = false;
        bool isRunning = false;
        std::shared_ptr<Progress> progress;
        std::jthread worker; // last: of the run that is under way, or was
    };
    /// What a stage would run with now; nothing while something is missing, or of several
    /// revisions.
    struct Inputs
    {
        Snapshot::Results results;
        std::uint64_t revision = 0;
    };

    Desk *find(std::string_view stage);
    Desk &desk(std::string_view stage);
    void want(Desk &desk);
    std::optional<Inputs> inputsOf(const Desk &desk) const;
    bool isWaiting(const Desk &desk) const;
    bool isSettled(const Desk &desk) const;
    void startAll();
    void renew(Desk &desk) const;
    void start(Desk &desk, Inputs inputs);
    void collect();
    bool collectOne();
    void follow();
    void grow(Age to);
    void askAnew(std::string_view what, std::shared_ptr<const void> question);

    Scheduler *q;
    std::vector<Stage> stages;
    Snapshot::Results given; // the model, the rules and the questions
    CheckRules rules;
    Questions questions;
    std::uint64_t revision = 0;
    bool isPassing = false;
    int generation = 0;
    Age age = Age::Current; // of what is not current
    QTimer becomesOlder, becomesLate, ticks;
    std::mutex mutex;
    std::condition_variable isReady;
    std::deque<Outcome> outcomes; // guarded by the mutex
    QObject receiver;
    std::vector<Desk> desks; // one a stage; last: their workers end before the rest goes
};

Scheduler::Private::Private(Scheduler *scheduler, std::vector<Stage> all)
    : q(scheduler), stages(std::move(all))
{
    desks.reserve(stages.size()); // they point at each other
    for (const Stage &stage : stages) {
        Desk &desk = desks.emplace_back();
        desk.stage = &stage;
        for (const std::string_view name : stage.inputs) {
            if (Desk *input = find(name))
                desk.inputs.push_back(input);
            else
                desk.given.push_back(name);
        }
    }
    given[kRules.name] = std::make_shared<const CheckRules>();
    given[kQuestions.name] = std::make_shared<const Questions>();
    given[kSheetsAsked.name] = nullptr;
    for (QTimer *timer : {&becomesOlder, &becomesLate})
        timer->setSingleShot(true);
    becomesOlder.setInterval(kSeen);
    becomesLate.setInterval(kLate);
    ticks.setInterval(kTick);
    connect(&becomesOlder, &QTimer::timeout, q, [this] { grow(Age::Older); });
    connect(&becomesLate, &QTimer::timeout, q, [this] { grow(Age::Late); });
    connect(&ticks, &QTimer::timeout, q, &Scheduler::progressed);
}

/// Null for the model, the rules and the questions, which are given.
Scheduler::Private::Desk *Scheduler::Private::find(std::string_view stage)
{
    const auto at = std::find_if(desks.begin(), desks.end(),
                                 [&](const Desk &desk) { return stage == desk.stage->name; });
    return at == desks.end() ? nullptr : &*at;
}

Scheduler::Private::Desk &Scheduler::Private::desk(std::string_view stage)
{
    Desk *known = find(stage);
    Q_ASSERT(known);
    return *known;
}

void Scheduler::Private::want(Desk &desk)
{
    desk.isWanted = true;
    for (Desk *input : desk.inputs)
        want(*input);
}

std::optional<Scheduler::Private::Inputs> Scheduler::Private::inputsOf(const Desk &desk) const
{
    Inputs inputs;
    std::optional<std::uint64_t> common;
    for (const std::string_view name : desk.given) {
        const auto known = given.find(name);
        if (known == given.end())
            return {};
        inputs.results.insert(*known);
    }
    for (const Desk *input : desk.inputs) {
        if (!input->result || (common && *common != input->revision))
            return {};
        common = input->revision;
        inputs.results[input->stage->name] = input->result;
    }
    inputs.revision = common.value_or(revision);
    return inputs;
}

/// It would run if it were not running.
bool Scheduler::Private::isWaiting(const Desk &desk) const
{
    const bool isForSettled = desk.stage->runs == Stage::Runs::WhenSettled;
    if (!desk.isWanted || (isForSettled && isPassing))
        return false;
    const std::optional<Inputs> inputs = inputsOf(desk);
    return inputs && inputs->results != desk.started &&
           (!isForSettled || inputs->revision == revision);
}

/// Nothing more will come of it for what is there.
bool Scheduler::Private::isSettled(const Desk &desk) const
{
    if (desk.isRunning || isWaiting(desk))
        return false;
    if (desk.stage->runs == Stage::Runs::WhenSettled && isPassing)
        return true;
    return std::all_of(desk.inputs.begin(), desk.inputs.end(),
                       [this](const Desk *input) { return isSettled(*input); });
}

void Scheduler::Private::startAll()
{
    for (Desk &desk : desks) {
        if (desk.isRunning)
            continue;
        if (isWaiting(desk))
            start(desk, *inputsOf(desk));
        else
            renew(desk);
    }
}

/// Undo and redo lead back to what it ran with: then its result is of what is there now.
void Scheduler::Private::renew(Desk &desk) const
{
    const std::optional<Inputs> inputs = inputsOf(desk);
    if (desk.result && !desk.why && inputs && inputs->results == desk.started)
        desk.revision = inputs->revision;
}

void Scheduler::Private::start(Desk &desk, Inputs inputs)
{
    desk.started = inputs.results;
    desk.why.reset();
    desk.isRunning = true;
    desk.progress = std::make_shared<Progress>();
    ticks.start();
    // A thread costs less than what any stage does.
    desk.worker =
        std::jthread([this, at = static_cast<std::size_t>(&desk - desks.data()), stage = desk.stage,
                      of = generation, previous = desk.previous, progress = desk.progress,
                      snapshot = Snapshot(inputs.revision, std::move(inputs.results))](
                         const std::stop_token &stop) {
            Outcome outcome{at, snapshot.revision(), of, {}, false};
            outcome.result =
                guarded(*stage, snapshot, previous.get(), *progress, stop, outcome.hasThrown);
            {
                const std::lock_guard lock(mutex);
                outcomes.push_back(std::move(outcome));
            }
            isReady.notify_all();
            // Dropped by Qt when the receiver is gone by then.
            QMetaObject::invokeMethod(
                &receiver, [this] { collect(); }, Qt::QueuedConnection);
        });
}

/// Also called late, for what finish() has taken already.
void Scheduler::Private::collect()
{
    while (collectOne()) {
    }
}

bool Scheduler::Private::collectOne()
{
    std::optional<Outcome> outcome;
    {
        const std::lock_guard lock(mutex);
        if (outcomes.empty())
            return false;
        outcome = std::move(outcomes.front());
        outcomes.pop_front();
    }
    Desk &desk = desks[outcome->desk];
    const Stage &stage = *desk.stage;
    desk.isRunning = false;
    desk.progress.reset();
    if (std::none_of(desks.begin(), desks.end(), [](const Desk &one) { return one.isRunning; }))
        ticks.stop();
    const bool isOfThis = outcome->generation == generation;
    if (outcome->hasThrown)
        desk.previous.reset();
    if (outcome->result) {
        desk.previous = *outcome->result;
        if (isOfThis) {
            desk.result = *std::move(outcome->result);
            desk.revision = outcome->revision;
        }
    } else if (isOfThis) {
        desk.why = std::move(outcome->result.error());
        if (desk.why->code != ErrorCode::Cancelled)
            qCWarning(journal, "%s could not be worked out: %s", std::string(stage.name).c_str(),
                      desk.why->args.empty() ? "" : desk.why->args.front().c_str());
    }
    startAll();
    follow();
    if (isOfThis)
        Q_EMIT q->published(stage.name);
    return true;
}

/// How old everything is by now: results age from the first change on that they do not know.
void Scheduler::Private::follow()
{
    const bool isCurrent = std::all_of(desks.begin(), desks.end(),
                                       [this](const Desk &desk) { return isSettled(desk); });
    if (isCurrent) {
        becomesOlder.stop();
        becomesLate.stop();
        if (std::exchange(age, Age::Current) != Age::Current)
            Q_EMIT q->aged();
    } else if (age == Age::Current && !becomesOlder.isActive()) {
        becomesOlder.start();
        becomesLate.start();
    }
}

void Scheduler::Private::grow(Age to)
{
    age = to;
    Q_EMIT q->aged();
}

void Scheduler::Private::askAnew(std::string_view what, std::shared_ptr<const void> question)
{
    given[what] = std::move(question);
    for (Desk &desk : desks)
        if (std::find(desk.given.begin(), desk.given.end(), what) != desk.given.end())
            desk.worker.request_stop();
}

Scheduler::Scheduler(std::vector<Stage> stages, QObject *parent)
    : QObject(parent), d(std::make_unique<Private>(this, std::move(stages)))
{
}

Scheduler::~Scheduler()
{
    for (Private::Desk &desk : d->desks)
        desk.worker.request_stop();
}

void Scheduler::want(std::string_view stage)
{
    d->want(d->desk(stage));
    d->startAll();
    d->follow();
}

void Scheduler::request(std::uint64_t revision, ModelPointer model, bool isPassing)
{
    d->revision = revision;
    d->isPassing = isPassing;
    d->given[kModel.name] = std::move(model);
    d->startAll();
    d->follow();
}

void Scheduler::forget()
{
    ++d->generation;
    d->given.erase(kModel.name);
    d->questions = {};
    d->given[kQuestions.name] = std::make_shared<const Questions>();
    d->given[kSheetsAsked.name] = nullptr;
    for (Private::Desk &desk : d->desks) {
        desk.worker.request_stop();
        desk.started.clear();
        desk.why.reset();
    }
}

void Scheduler::setRules(const CheckRules &rules)
{
    if (rules == d->rules)
        return;
    d->rules = rules;
    d->given[kRules.name] = std::make_shared<const CheckRules>(rules);
    d->startAll();
    d->follow();
}

const CheckRules &Scheduler::rules() const
{
    return d->rules;
}

void Scheduler::ask(const Questions &questions)
{
    if (questions == d->questions)
        return;
    const Questions before = std::exchange(d->questions, questions);
    if (questions.sheets != before.sheets)
        d->askAnew(kSheetsAsked.name, questions.sheets);
    if (withoutSheets(questions) != withoutSheets(before))
        d->askAnew(kQuestions.name, std::make_shared<const Questions>(withoutSheets(questions)));
    d->startAll();
    d->follow();
    Q_EMIT asked();
}

const Questions &Scheduler::questions() const
{
    return d->questions;
}

std::shared_ptr<const void> Scheduler::resultNamed(std::string_view stage) const
{
    return d->desk(stage).result;
}

std::uint64_t Scheduler::revisionOf(std::string_view stage) const
{
    return d->desk(stage).revision;
}

Scheduler::Age Scheduler::age(std::string_view stage) const
{
    const Private::Desk &desk = d->desk(stage);
    if (!desk.isWanted)
        return Age::Current;
    if (!d->isSettled(desk))
        return d->age;
    const bool isForSettled = desk.stage->runs == Stage::Runs::WhenSettled;
    // What has failed, or stands on what has, stays older.
    return desk.revision == d->revision || (isForSettled && d->isPassing) ? Age::Current
                                                                          : Age::Late;
}

bool Scheduler::isRunning(std::string_view stage) const
{
    return d->desk(stage).isRunning;
}

bool Scheduler::isSettled(std::string_view stage) const
{
    return d->isSettled(d->desk(stage));
}

double Scheduler::progress(std::string_view stage) const
{
    const auto &progress = d->desk(stage).progress;
    return progress ? progress->share() : -1.0;
}

const std::optional<Error> &Scheduler::failureOf(std::string_view stage) const
{
    return d->desk(stage).why;
}

std::optional<Error> Scheduler::whyNot(std::string_view stage) const
{
    const Private::Desk &desk = d->desk(stage);
    for (const Private::Desk *input : desk.inputs)
        if (const auto why = whyNot(input->stage->name))
            return why;
    return desk.why;
}

void Scheduler::cancel(std::string_view stage)
{
    d->desk(stage).worker.request_stop();
}

void Scheduler::tryAgain(std::string_view stage)
{
    Private::Desk &desk = d->desk(stage);
    if (desk.isRunning)
        return;
    desk.started.clear();
    desk.why.reset();
    d->startAll();
    d->follow();
    Q_EMIT aged();
}

void Scheduler::finish(std::string_view stage)
{
    while (!d->isSettled(d->desk(stage))) {
        {
            std::unique_lock lock(d->mutex);
            d->isReady.wait(lock, [this] { return !d->outcomes.empty(); });
        }
        d->collectOne();
    }
}

void Scheduler::finish()
{
    for (const Stage &stage : d->stages)
        finish(stage.name);
}

const std::vector<Stage> &Scheduler::stages() const
{
    return d->stages;
}

void Scheduler::setCompute(std::string_view stage, decltype(Stage::compute) compute)
{
    const auto at = std::find_if(d->stages.begin(), d->stages.end(),
                                 [&](const Stage &known) { return stage == known.name; });
    at->compute = std::move(compute);
}

} // namespace fff
