// What is derived from the document is derived in stages: pure functions from a snapshot, and from
// what they gave the last time, to a result. Who runs them, and when, is core/session/scheduler.h.
//
// A new one is a file with its StageOf and its function, and its line in stages.cpp.
#pragma once

#include "core/analysis/finding.h"
#include "core/analysis/findings/not_worked_out.h"
#include "core/base/message.h"
#include "core/model/model.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string_view>
#include <vector>

namespace fff {

using ModelPointer = std::shared_ptr<const Model>;

/// The name of a stage, and what its result is. Names are told apart by what they say.
template <class Out>
struct StageOf
{
    std::string_view name;
};

struct SheetsQuestion;

/// What a person asks besides the checks; each costs more than anybody waits for unasked.
struct Questions
{
    std::optional<SectionRef> bearing = {}; // where this section is strong enough (bearing_map.h)
    bool skin = false;                      // what form the sections suggest (core/skin/skin.h)
    std::shared_ptr<const SheetsQuestion> sheets = {}; // how parts lie on them (nested.h)

    bool operator==(const Questions &) const = default;
};

/// What stages are derived from: the model, what a person wants of the checks, and what they ask.
struct CheckRules;
inline constexpr StageOf<Model> kModel{"model"};
inline constexpr StageOf<CheckRules> kRules{"rules"};
inline constexpr StageOf<Questions> kQuestions{"questions"};

/// How far a stage has come, for whoever waits for it. From any thread.
class Progress
{
public:
    /// share: 0 … 1
    void set(double share) { m_share.store(share, std::memory_order_relaxed); }
    /// Below 0 where the stage does not say.
    double share() const { return m_share.load(std::memory_order_relaxed); }

private:
    std::atomic<double> m_share{-1.0};
};

/// The results that a stage is worked out of: of those that it names as its inputs, all of one
/// revision. Immutable.
class Snapshot
{
public:
    using Results = std::map<std::string_view, std::shared_ptr<const void>>;

    Snapshot(std::uint64_t revision, Results results)
        : m_revision(revision), m_results(std::move(results))
    {
    }

    /// Of the model, as the session counts.
    std::uint64_t revision() const { return m_revision; }
    /// Throws std::out_of_range for what is no input of the stage that asks: a fault of its line in
    /// stages.cpp.
    template <class Out>
    std::shared_ptr<const Out> pointer(const StageOf<Out> &stage) const
    {
        return std::static_pointer_cast<const Out>(result(stage.name));
    }
    const std::shared_ptr<const void> &result(std::string_view stage) const
    {
        return m_results.at(stage);
    }
    template <class Out>
    const Out &get(const StageOf<Out> &stage) const
    {
        return *pointer(stage);
    }

private:
    std::uint64_t m_revision;
    Results m_results;
};

/// A stage as the scheduler knows it.
struct Stage
{
    enum class Runs {
        Always,      // also for what is shown on the way of a drag
        WhenSettled, // for what is committed
    };

    std::string_view name;
    Text title; // what a person calls what it finds out: "the order of assembly"
    std::vector<std::string_view> inputs; // names of stages, of kModel, kRules and kQuestions
    Runs runs = Runs::Always;
    /// previous: what it gave the last time, or null. Errors  what cannot be computed, with the
    /// name of the section or operation at fault; Cancelled once stop is requested, soon.
    std::function<Result<std::shared_ptr<const void>>(const Snapshot &, const void *previous,
                                                      Progress &, std::stop_token)>
        compute;
    /// What is wrong with the model by a result of it; null for one that says nothing of that.
    const std::vector<Finding> &(*findings)(const void *result) = nullptr;
    /// Gives back what a result keeps only to save work the next time; null where it keeps little.
    /// While no run of the stage is under way.
    void (*tidy)(const void *result) = nullptr;
    /// What is said in their place when it fails.
    const FindingKind *failing = &kNotWorkedOut;
    /// The name of a stage that it works out better, or empty: its findings, where it has some,
    /// stand in place of those of that. Nobody waits for it.
    std::string_view refines = {};

    bool isRefining() const { return !refines.empty(); }
    Stage refining(std::string_view other) const
    {
        Stage stage = *this;
        stage.refines = other;
        return stage;
    }
    Stage failingAs(const FindingKind &kind) const
    {
        Stage stage = *this;
        stage.failing = &kind;
        return stage;
    }
};

/// "Working out the order of assembly… 40 %"; share: below 0 where nothing is known.
Message workOf(const Stage &stage, double share);

/// The stage of a function
///     Result<Out> compute(const Snapshot &, const Out *previous, Progress &, std::stop_token)
/// whose result follows from the snapshot alone; `previous` is there to save work. The `findings`
/// of a result, where it has such, are listed among the checks; its tidy(), where it has one, is
/// Stage::tidy.
template <class Out, class Compute>
Stage makeStage(const StageOf<Out> &stage, Text title, std::vector<std::string_view> inputs,
                Stage::Runs runs, Compute compute)
{
    Stage made{stage.name, title, std::move(inputs), runs,
               [compute](const Snapshot &snapshot, const void *previous, Progress &progress,
                         std::stop_token stop) -> Result<std::shared_ptr<const void>> {
                   Result<Out> out = compute(snapshot, static_cast<const Out *>(previous), progress,
                                             std::move(stop));
                   if (!out)
                       return tl::unexpected(std::move(out.error()));
                   return std::make_shared<const Out>(*std::move(out));
               }};
    if constexpr (requires(const Out &out) { out.findings; })
        made.findings = [](const void *result) -> const std::vector<Finding> & {
            return static_cast<const Out *>(result)->findings;
        };
    if constexpr (requires(const Out &out) { out.tidy(); })
        made.tidy = [](const void *result) { static_cast<const Out *>(result)->tidy(); };
    return made;
}

} // namespace fff
