// The desks of the scheduler: which stage runs with what, and what came of it. Internal to it.
#pragma once

#include "core/session/scheduler.h"

#include <QTimer>

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string_view>
#include <thread>
#include <vector>

namespace fff {

class Scheduler::Private
{
public:
    Private(Scheduler *scheduler, std::vector<Stage> all);

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

} // namespace fff
