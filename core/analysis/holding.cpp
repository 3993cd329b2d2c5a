#include "core/analysis/holding.h"

#include "core/analysis/analysed.h"
#include "core/analysis/check_rules.h"
#include "core/analysis/findings/strength_findings.h"

namespace fff {

Result<Holding> holding(const Snapshot &snapshot, const Holding *previous, Progress &,
                        std::stop_token stop)
{
    const StrengthRules &rules = snapshot.get(kRules).strength;
    Holding out{snapshot.get(kAnalysed).analysis,
                {},
                {},
                {},
                previous ? previous->caches : std::make_shared<StrengthCaches>()};
    out.strength = strengthOf(*out.analysis, rules, *out.caches);
    if (stop.stop_requested())
        return failure(ErrorCode::Cancelled);
    out.bearable = bearableMass(*out.analysis, out.strength, rules, *out.caches);
    out.findings = strengthFindings(*out.analysis, out.strength, out.bearable, rules);
    return out;
}

} // namespace fff
