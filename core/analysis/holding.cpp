#include "core/analysis/holding.h"

#include "core/analysis/analysed.h"
#include "core/analysis/check_rules.h"
#include "core/analysis/findings/strength_findings.h"

namespace fff {

Holding holdingOf(AnalysisPointer analysis, const StrengthRules &rules,
                  std::shared_ptr<StrengthCaches> caches)
{
    Holding out{std::move(analysis), {}, {}, {}, std::move(caches)};
    out.strength = strengthOf(*out.analysis, rules, *out.caches);
    out.bearable = bearableMass(*out.analysis, out.strength, rules, *out.caches);
    out.findings = strengthFindings(*out.analysis, out.strength, out.bearable, rules);
    return out;
}

Result<Holding> holding(const Snapshot &snapshot, const Holding *previous, Progress &,
                        std::stop_token stop)
{
    Holding out = holdingOf(snapshot.get(kAnalysed).analysis, snapshot.get(kRules).strength,
                            previous ? previous->caches : std::make_shared<StrengthCaches>());
    if (stop.stop_requested())
        return failure(ErrorCode::Cancelled);
    return out;
}

} // namespace fff
