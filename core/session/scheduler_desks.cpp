#include "core/analysis/nested.h"
#include "core/session/journal.h"
#include "core/session/scheduler_private.h"

#include <algorithm>
#include <exception>
#include <string>
#include <utility>

namespace fff {

namespace {

// ms. Most answers come sooner than the eye sees a change; saying in between that they are older
// would only flicker.
constexpr int kSeen = 100, kLate = 500;
/// ms between two looks at how far something has come.
constexpr int kTick = 200;

Result<std::shared_ptr<const void>> guarded(const Stage &stage, const Snapshot &snapshot,
                                            const void *previous, Progress &progress,
                                            const std::stop_token &stop, bool &hasThrown)
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

} // namespace fff
