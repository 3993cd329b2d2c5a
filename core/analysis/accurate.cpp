#include "core/analysis/accurate.h"

#include "core/analysis/analysed.h"
#include "core/analysis/check_rules.h"
#include "core/analysis/findings/strength_findings.h"
#include "core/analysis/stress_lines.h"

#include <algorithm>

namespace fff {

namespace {

/// Of all its time, about: how bodies bend, and the stress all over them. Between the two is what
/// they bear, which nobody can tell beforehand.
constexpr double kBendingShare = 0.5, kFieldShare = 0.3;

} // namespace

Result<Accurate> accurate(const Snapshot &snapshot, const Accurate *previous, Progress &progress,
                          std::stop_token stop)
{
    Accurate out;
    out.caches = previous ? previous->caches : std::make_shared<StrengthCaches>();
    const StrengthRules &rules = snapshot.get(kRules).strength;
    if (!rules.isElastic)
        return out;
    const LongWork work{stop, [&progress](double share) {
                            progress.set(std::max(progress.share(), kBendingShare * share));
                        }};
    auto held = std::make_shared<Holding>(
        holdingOf(snapshot.get(kAnalysed).analysis, rules, out.caches, work));
    if (stop.stop_requested())
        return failure(ErrorCode::Cancelled);
    if (areStressesKnown(held->strength)) {
        const LongWork rest{stop, [&progress](double share) {
                                progress.set(
                                    std::max(progress.share(), 1.0 - kFieldShare * (1.0 - share)));
                            }};
        auto bent = bentModel(held->analysis, held->strength, *out.caches, rest);
        if (!bent)
            return tl::unexpected(bent.error());
        tellBending(held->findings, bent->most);
        out.bent = std::make_shared<const BentModel>(*std::move(bent));
    }
    out.findings = held->findings;
    out.held = std::move(held);
    return out;
}

} // namespace fff
