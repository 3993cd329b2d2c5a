#include "tests/core/session/staged.h"

#include "core/analysis/analysed.h"
#include "core/analysis/findings/doubted_verdicts.h"
#include "core/analysis/nested.h"
#include "core/analysis/planned.h"
#include "core/analysis/stages.h"
#include "core/operations/evaluate.h"

namespace fff::test {

namespace {

Staged stagedTo(const Document &document, bool wantsMends)
{
    CheckRules patient;
    patient.planningTime = std::chrono::minutes(10);
    Snapshot::Results results{{kModel.name, std::make_shared<const Model>(evaluate(document))},
                              {kRules.name, std::make_shared<const CheckRules>(patient)},
                              {kQuestions.name, std::make_shared<const Questions>()},
                              {kSheetsAsked.name, nullptr}};
    Staged out;
    for (const Stage &stage : stages()) {
        const bool isForMends = stage.name == kFlips.name || stage.name == kMends.name;
        if (stage.isRefining() || (isForMends && !wantsMends))
            continue;
        Progress progress;
        const auto result = stage.compute(Snapshot(0, results), nullptr, progress, {});
        if (!result)
            return {};
        results[stage.name] = *result;
        if (stage.findings) {
            const std::vector<Finding> &found = stage.findings(result->get());
            out.found.insert(out.found.end(), found.begin(), found.end());
        }
    }
    doubtVerdicts(out.found);
    out.analysis = Snapshot(0, results).get(kAnalysed).analysis;
    if (wantsMends)
        out.mends = Snapshot(0, results).pointer(kMends);
    return out;
}

} // namespace

Staged staged(const Document &document)
{
    return stagedTo(document, false);
}

Staged stagedWithMends(const Document &document)
{
    return stagedTo(document, true);
}

} // namespace fff::test
