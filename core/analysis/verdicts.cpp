#include "core/analysis/verdicts.h"

#include "core/analysis/analysed.h"
#include "core/analysis/check_rules.h"

namespace fff {

Result<Verdicts> verdicts(const Snapshot &snapshot, const Verdicts *previous, Progress &,
                          std::stop_token)
{
    Verdicts out{snapshot.get(kAnalysed).analysis,
                 {},
                 previous ? previous->caches : std::make_shared<CheckCaches>()};
    out.findings = checks(*out.analysis, *out.caches, {}, snapshot.get(kRules));
    return out;
}

} // namespace fff
