#include "app/cli/analysed_file.h"
#include "app/cli/info.h"
#include "core/session/plan_checks.h"

namespace fff::cli {

int runInfo(const QStringList &arguments)
{
    const AnalysedFile model = analysedFile("info", arguments);
    if (model.status)
        return *model.status;
    const InfoContext context{model.file.toStdString(), model.format};
    const ModelPlan plan = planOf(model.analysis, timeLimit(kPlanningTime));
    return print(model.asJson ? infoJson(model.analysis, plan, context)
                              : infoText(model.analysis, plan, context));
}

} // namespace fff::cli
