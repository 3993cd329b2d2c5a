#include "app/cli/enclosed_steps.h"

#include "app/cli/info.h"
#include "core/analysis/plan_checks.h"
#include "core/io/error_text.h"
#include "core/session/assembly_steps.h"
#include "ui/view/steps_files.h"

#include <QCoreApplication>
#include <QGuiApplication>

#include <memory>
#include <utility>

namespace fff::cli {

namespace {

using ui::StepsFiles;

StepsFiles::Options onPaper(const QString &title, std::shared_ptr<const Layout> layout)
{
    StepsFiles::Options options;
    options.kind = StepsFiles::Kind::Paper;
    options.paper.title = title;
    options.paper.layout = std::move(layout);
    options.paper.size = ui::StepsPaper::usualSize(QLocale::system());
    orientationOfView("iso1", options.looking.orientation);
    return options;
}

} // namespace

std::vector<io::NamedBytes> enclosedSteps(const Analysis &analysis, const QString &title,
                                          std::shared_ptr<const Layout> layout, QString &why)
{
    const auto shared = std::make_shared<const Analysis>(analysis);
    const ModelPlan plan = planOf(*shared, timeLimit(kPlanningTime));
    const AssemblyStepsPointer steps = assemblySteps(shared, plan);
    if (!steps) {
        why = plan.failure ? io::errorSentence(*plan.failure) : whyNoSteps(*shared, plan);
        return {};
    }
    why = QCoreApplication::translate("CommandLine", "there is no display with OpenGL 3.3.");
    if (!qobject_cast<QGuiApplication *>(QCoreApplication::instance()))
        return {};
    StepsFiles files(steps, onPaper(title, std::move(layout)));
    if (!files.isUsable())
        return {};
    for (int piece = 0; piece < files.pieceCount(); ++piece)
        if (!files.makePiece(piece))
            return {};
    why.clear();
    return {{QStringLiteral("steps.pdf"), files.take().front()}};
}

} // namespace fff::cli
