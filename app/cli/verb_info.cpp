#include "app/cli/all_found.h"
#include "app/cli/analysed_file.h"
#include "app/cli/info.h"
#include "core/analysis/plan_checks.h"
#include "core/fabrication/wholeness.h"

namespace fff::cli {

int runInfo(const QStringList &arguments)
{
    const AnalysedFile model = analysedFile("info", arguments);
    if (model.status)
        return *model.status;
    const InfoContext context{model.file.toStdString(), model.format};
    // What of the rest a missing solid leaves untouched is told.
    if (const auto known = haveParts(model.analysis.model, model.analysis.bodies); !known)
        return report(known.error(), model.file);
    const ModelPlan plan = planOf(model.analysis, timeLimit(kPlanningTime));
    if (plan.failure)
        report(*plan.failure, model.file);
    const std::vector<Finding> found = allFound(model.analysis, plan);
    return model.asJson ? print(infoJson(model.analysis, plan, found, context))
                        : printLines(infoText(model.analysis, found, context));
}

} // namespace fff::cli
