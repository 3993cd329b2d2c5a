// Runs the stages beside the window: what is shown is derived as it changes, the newest request
// wins, and each result is published as it becomes ready.
#pragma once

#include "core/analysis/check_rules.h"
#include "core/analysis/stages.h"

#include <QObject>

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

namespace fff {

/// A stage runs once all its inputs are there, of one revision, and other ones than it ran with
/// last; each on a worker of its own, one run at a time: while it is busy only the newest inputs
/// wait. A stage that runs when the model has settled waits for what is committed.
///
/// What is published is immutable and stays until there is something newer: also after a failure,
/// which keeps its reason beside it. A stage that threw is worked out anew the next time, without
/// what it gave before.
class Scheduler : public QObject
{
    Q_OBJECT
public:
    explicit Scheduler(std::vector<Stage> stages = fff::stages(), QObject *parent = nullptr);
    /// Stops what runs, and waits for that.
    ~Scheduler() override;

    /// From now on this stage, and what it is derived from, is worked out; others are not.
    void want(std::string_view stage);

    /// isPassing: it is on the way of a drag. The same model again may settle what was passing.
    void request(std::uint64_t revision, ModelPointer model, bool isPassing);
    /// Another document comes: what runs for the one before is stopped and not published.
    void forget();
    void setRules(const CheckRules &rules);
    const CheckRules &rules() const;
    /// What runs for another question is stopped. Another document has none.
    void ask(const Questions &questions);
    const Questions &questions() const;

    /// The newest one; null until there is one.
    template <class Out>
    std::shared_ptr<const Out> result(const StageOf<Out> &stage) const
    {
        return std::static_pointer_cast<const Out>(resultNamed(stage.name));
    }
    std::shared_ptr<const void> resultNamed(std::string_view stage) const;
    /// That the result is of.
    std::uint64_t revisionOf(std::string_view stage) const;

    enum class Age {
        Current, // of the model that is there, or as far as it comes while that is passing
        Older,   // that has changed since, long enough ago that a person sees it
        Late,    // for half a second by now
    };
    Age age(std::string_view stage) const;
    bool isRunning(std::string_view stage) const;
    /// Nothing more will come of it, or of what it is derived from, for what is there.
    bool isSettled(std::string_view stage) const;
    /// 0 … 1 of the run that is under way; below 0 where nothing is known.
    double progress(std::string_view stage) const;
    /// Why there is no result of the newest inputs: Cancelled, StageFailed, or what it says itself.
    const std::optional<Error> &failureOf(std::string_view stage) const;
    /// The same of the stage, or else of the first that it is derived from.
    std::optional<Error> whyNot(std::string_view stage) const;

    /// Its run ends soon, without a result, until there are other inputs or somebody tries again.
    void cancel(std::string_view stage);
    void tryAgain(std::string_view stage);

    /// Blocks until the stage, and what it is derived from, has nothing more to do for what is
    /// there: published, or why not.
    void finish(std::string_view stage);
    void finish();

    /// Nobody does anything: gives back what stages keep only to be faster the next time, unless
    /// one runs. Results stay.
    void tidy();

    const std::vector<Stage> &stages() const;
    /// Makes a stage do something else: for tests, while none of its runs is under way.
    void setCompute(std::string_view stage, decltype(Stage::compute) compute);

Q_SIGNALS:
    /// A result, or why there is none. Direct: `stage` lives as long as the program.
    void published(std::string_view stage);
    /// Something else.
    void asked();
    /// How old results are.
    void aged();
    /// What runs has come further: now and then while something runs.
    void progressed();

private:
    class Private;
    std::unique_ptr<Private> d;
};

} // namespace fff
