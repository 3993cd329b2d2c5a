// What would be said of a model that is not there: an edit is tried on a copy and judged by all
// that finds something, before it is offered.
#pragma once

#include "core/analysis/analysis.h"
#include "core/analysis/check_rules.h"
#include "core/analysis/stage.h"

#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace fff {

/// Not for several threads at once.
class Trials
{
public:
    /// Those of the stages that have findings judge, after what they are derived from; none may be
    /// derived from what is found here.
    explicit Trials(const std::vector<Stage> &stages);

    struct Outcome
    {
        AnalysisPointer analysis;
        std::vector<Finding> findings;
    };
    /// Nothing where a stage fails, or is stopped: what cannot be judged is not offered. An edit
    /// after another one costs the work of what differs between the two.
    std::optional<Outcome> of(Model model, const CheckRules &rules, std::stop_token stop);
    /// What is kept of the trial before: the next one costs the work of the whole model.
    void forget() { m_before.clear(); }

private:
    std::vector<Stage> m_stages; // in the order in which they run
    Snapshot::Results m_before;  // of the trial before
};

/// What all problems of one subject, or of one kind among those of joints, come to. The less, the
/// better; a problem more weighs less than a graver one.
struct Burden
{
    int errors = 0, unknown = 0, warnings = 0;
    auto operator<=>(const Burden &) const = default;
};

/// Whether nothing is worse: no badge, no kind of problem of joints or of what holds together, and
/// none of what is said of the same sections before and after. What is amber has to keep its
/// distance from red, but for a tenth of it; and a loss is none to be had for anything.
bool isNoWorse(std::span<const Finding> before, std::span<const Finding> after);
/// Whether what it says has gone, or become less, and less is wrong with what it is about.
bool helps(const Finding &finding, std::span<const Finding> before, std::span<const Finding> after);

/// What differs, in a few words for whoever asks before it is done: "6 joints turned round, nothing
/// is cut through." before, after: what is found of each.
Message changesBetween(const Analysis &before, const Analysis &after,
                       std::span<const Finding> foundBefore, std::span<const Finding> foundAfter);

} // namespace fff
