#include "app/cli/analysed_file.h"
#include "app/cli/info.h"

namespace fff::cli {

int runInfo(const QStringList &arguments)
{
    const AnalysedFile model = analysedFile("info", arguments);
    if (model.status)
        return *model.status;
    const InfoContext context{model.file.toStdString(), model.format};
    return print(model.asJson ? infoJson(model.analysis, context)
                              : infoText(model.analysis, context));
}

} // namespace fff::cli
