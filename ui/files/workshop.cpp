#include "ui/files/workshop.h"

#include "core/analysis/planned.h"
#include "core/io/error_text.h"
#include "core/io/full_stop.h"
#include "core/session/assembly_steps.h"
#include "core/session/scheduler.h"
#include "core/session/session.h"
#include "ui/base/file_dialog.h"
#include "ui/files/progress.h"
#include "ui/properties/stock_choice.h"
#include "ui/settings/settings.h"
#include "ui/view/steps_files.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

namespace fff::ui {

namespace {

struct WorkshopTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::Workshop)
};

const QString kStepsFile = QStringLiteral("steps.pdf");

QString folderName(const QString &model)
{
    //: %1 is a model's name: what a folder of its files for a workshop is called
    return WorkshopTexts::tr("%1 for the workshop").arg(model);
}

WorkshopSteps withoutSteps(const QString &why)
{
    //: %1 is a sentence
    const QString text = WorkshopTexts::tr("The steps are not among the files: %1").arg(why);
    return {{}, text, false};
}

StepsFiles::Options paperOptions(const QWidget &window, const QString &title,
                                 std::shared_ptr<const Layout> layout)
{
    StepsFiles::Options options;
    options.kind = StepsFiles::Kind::Paper;
    options.paper = {title, StepsPaper::usualSize(window.locale()), settings().unit(), stockName,
                     std::move(layout)};
    orientationOfView("iso1", options.looking.orientation);
    return options;
}

} // namespace

QString workshopFolder(const QString &model)
{
    const QFileInfo file(model);
    return file.fileName().endsWith(folderName({}))
               ? model
               : file.dir().filePath(folderName(file.fileName()));
}

QString askForWorkshopFolder(QWidget *parent, const QString &suggestion)
{
    const QFileInfo folder(workshopFolder(suggestion));
    const QString name = folder.fileName();
    FileDialog dialog(parent, WorkshopTexts::tr("Where to put the folder “%1”").arg(name),
                      folder.absolutePath());
    dialog.setObjectName(QStringLiteral("exportFolderDialog"));
    dialog.setFileMode(QFileDialog::Directory);
    dialog.setOption(QFileDialog::ShowDirsOnly);
    dialog.setLabelText(QFileDialog::Accept, WorkshopTexts::tr("Put it here"));
    if (dialog.exec() != QDialog::Accepted)
        return {};
    return QDir(dialog.selectedFiles().value(0)).filePath(name);
}

std::vector<io::NamedBytes> inWorkshopFolder(const QString &folder,
                                             std::vector<io::NamedBytes> files)
{
    QDir().mkpath(folder);
    for (io::NamedBytes &file : files)
        file.path = QDir(folder).filePath(file.path);
    return files;
}

WorkshopSteps workshopSteps(QWidget &window, const Session &session, const QString &doing,
                            const QString &title, std::shared_ptr<const Layout> layout)
{
    const Scheduler &scheduler = session.scheduler();
    if (!waitWithProgress(window, doing, MayCancel::Yes,
                          [&scheduler] { return scheduler.isSettled(kPlanned.name); }))
        return {{}, {}, true};
    if (const auto why = scheduler.whyNot(kPlanned.name))
        return withoutSteps(withFullStop(io::errorSentence(*why)));
    const auto planned = scheduler.result(kPlanned);
    const AssemblyStepsPointer steps =
        planned ? assemblySteps(planned->analysis, planned->plan) : nullptr;
    if (!steps)
        return withoutSteps(whyNoSteps(session.analysis(), planned ? planned->plan : ModelPlan()));
    StepsFiles files(steps, paperOptions(window, title, std::move(layout)));
    if (!files.isUsable())
        return withoutSteps(WorkshopTexts::tr("no picture can be made on this display."));
    const Pieces made = doInPieces(window, doing, files.pieceCount(),
                                   [&files](int piece) { return files.makePiece(piece); });
    if (made == Pieces::GivenUp)
        return {{}, {}, true};
    if (made == Pieces::Failed)
        return withoutSteps(WorkshopTexts::tr("no picture can be made on this display."));
    return {{{kStepsFile, files.take().front()}}, {}, false};
}

} // namespace fff::ui
