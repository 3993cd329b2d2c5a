#include "app/cli/all_found.h"

#include "core/analysis/checks.h"
#include "core/analysis/findings/doubted_verdicts.h"
#include "core/analysis/holding.h"
#include "core/analysis/plan_checks.h"

#include <iterator>
#include <memory>

namespace fff::cli {

std::vector<Finding> allFound(const Analysis &analysis, const ModelPlan &plan)
{
    std::vector<Finding> found = checks(analysis);
    const auto add = [&](std::vector<Finding> more) {
        std::move(more.begin(), more.end(), std::back_inserter(found));
    };
    add(planChecks(analysis, plan));
    if (analysis.model.sectionCount() > 0) {
        const AnalysisPointer shared(AnalysisPointer(), &analysis); // it outlives what is made
        add(holdingOf(shared, {}, std::make_shared<StrengthCaches>()).findings);
    }
    doubtVerdicts(found);
    return found;
}

} // namespace fff::cli
