#include "core/analysis/holding.h"

#include "core/analysis/analysed.h"
#include "core/analysis/check_rules.h"
#include "core/analysis/findings/strength_findings.h"

namespace fff {

Holding holdingOf(AnalysisPointer analysis, const StrengthRules &rules,
                  std::shared_ptr<StrengthCaches> caches, const LongWork &work)
{
    Holding out{std::move(analysis), {}, {}, {}, std::move(caches)};
    out.strength = strengthOf(*out.analysis, rules, *out.caches, work);
    out.bearable = bearableMass(*out.analysis, out.strength, rules, *out.caches, work);
    out.findings = strengthFindings(*out.analysis, out.strength, out.bearable, rules);
    return out;
}

Result<Holding> holding(const Snapshot &snapshot, const Holding *previous, Progress &,
                        std::stop_token stop)
{
    StrengthRules rules = snapshot.get(kRules).strength;
    rules.isElastic = false;
    Holding out =
        holdingOf(snapshot.get(kAnalysed).analysis, rules,
                  previous ? previous->caches : std::make_shared<StrengthCaches>(), {stop, {}});
    if (stop.stop_requested())
        return failure(ErrorCode::Cancelled);
    return out;
}

} // namespace fff
