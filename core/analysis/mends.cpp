#include "core/analysis/mends.h"

#include "core/analysis/analysed.h"
#include "core/analysis/planned.h"
#include "core/analysis/verdicts.h"

#include <algorithm>
#include <map>

namespace fff {

bool isSameVerdict(const Check &a, const Check &b)
{
    return a.code == b.code && a.sections == b.sections;
}

const std::vector<CheckAction> *Mends::of(const Check &check) const
{
    const auto known = std::find_if(ofChecks.begin(), ofChecks.end(), [&](const auto &mended) {
        return isSameVerdict(mended.first, check);
    });
    return known == ofChecks.end() ? nullptr : &known->second;
}

Result<Mends> mends(const Snapshot &snapshot, const Mends *, Progress &progress,
                    std::stop_token stop)
{
    const Analysis &analysis = *snapshot.get(kAnalysed).analysis;
    const std::optional<Flips> &flips = snapshot.get(kFlips).flips;
    std::vector<Check> checks = snapshot.get(kVerdicts).checks;
    const std::vector<Check> &ofPlan = snapshot.get(kPlanned).checks;
    checks.insert(checks.end(), ofPlan.begin(), ofPlan.end());
    Mends out;
    std::map<CheckCode, int> alike;
    for (std::size_t i = 0; i < checks.size(); ++i) {
        if (stop.stop_requested())
            return failure(ErrorCode::Cancelled);
        progress.set(static_cast<double>(i) / static_cast<double>(checks.size()));
        if (alike[checks[i].code]++ < kMostAlike)
            out.ofChecks.emplace_back(checks[i],
                                      actionsOf(checks[i], analysis, flips ? &*flips : nullptr));
    }
    return out;
}

} // namespace fff
