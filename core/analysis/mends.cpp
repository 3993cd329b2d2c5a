#include "core/analysis/mends.h"

#include "core/analysis/analysed.h"
#include "core/analysis/planned.h"

#include <algorithm>
#include <map>

namespace fff {

namespace {

Result<Mends> mends(const std::vector<Finding> &findings, const Snapshot &snapshot,
                    Progress &progress, const std::stop_token &stop)
{
    const Analysis &analysis = *snapshot.get(kAnalysed).analysis;
    const std::optional<Flips> &flips = snapshot.get(kFlips).flips;
    Mends out;
    std::map<const FindingKind *, int> alike;
    for (std::size_t i = 0; i < findings.size(); ++i) {
        if (stop.stop_requested())
            return failure(ErrorCode::Cancelled);
        progress.set(static_cast<double>(i) / static_cast<double>(findings.size()));
        if (alike[findings[i].kind]++ < kMostAlike)
            out.ofFindings.emplace_back(
                findings[i], actionsOf(findings[i], analysis, flips ? &*flips : nullptr));
    }
    return out;
}

} // namespace

const std::vector<FindingAction> *Mends::of(const Finding &finding) const
{
    const auto known = std::find_if(ofFindings.begin(), ofFindings.end(), [&](const auto &mended) {
        return isSameVerdict(mended.first, finding);
    });
    return known == ofFindings.end() ? nullptr : &known->second;
}

Stage mendsOf(const std::vector<Stage> &others)
{
    std::vector<const char *> inputs{kAnalysed.name, kFlips.name};
    std::vector<Stage> finding;
    for (const Stage &stage : others) {
        if (!stage.findings)
            continue;
        finding.push_back(stage);
        inputs.push_back(stage.name);
    }
    return makeStage(kMends, FFF_TEXT("Stage", "what can be done about problems"),
                     std::move(inputs), Stage::Runs::WhenSettled,
                     [finding](const Snapshot &snapshot, const Mends *, Progress &progress,
                               std::stop_token stop) {
                         std::vector<Finding> all;
                         for (const Stage &stage : finding) {
                             const auto &found = stage.findings(snapshot.result(stage.name).get());
                             all.insert(all.end(), found.begin(), found.end());
                         }
                         return mends(all, snapshot, progress, stop);
                     });
}

} // namespace fff
