#include "ui/steps/steps_export.h"

#include "core/io/document_file.h"
#include "core/io/file_set.h"
#include "ui/base/file_dialog.h"
#include "ui/base/message_bar.h"
#include "ui/bench/status_line.h"
#include "ui/files/failures.h"
#include "ui/files/progress.h"
#include "ui/files/replace_question.h"
#include "ui/properties/stock_choice.h"
#include "ui/settings/settings.h"

#include <QFileInfo>

namespace fff::ui {

namespace {

const QString kPaper = QStringLiteral("pdf"), kPage = QStringLiteral("html"),
              kPictures = QStringLiteral("png");

bool hasSuffix(const QString &path, const QString &suffix)
{
    return QFileInfo(path).suffix().compare(suffix, Qt::CaseInsensitive) == 0;
}

bool isPage(const QString &path)
{
    return hasSuffix(path, kPage);
}

bool isPictures(const QString &path)
{
    return hasSuffix(path, kPictures);
}

/// What follows a dot in a model's name ("chair.v2") is no suffix.
QString withoutSuffix(const QString &path)
{
    return hasSuffix(path, kPaper) || isPage(path) || isPictures(path)
               ? path.chopped(QFileInfo(path).suffix().size() + 1)
               : path;
}

} // namespace

StepsExport::StepsExport(MessageBar &messages, StatusLine &status, QWidget &window)
    : QObject(&window), m_messages(messages), m_status(status), m_window(window)
{
}

bool StepsExport::ask(const Subject &subject, const QString &suggestion)
{
    const QString paper = tr("All steps, to print (*.pdf)"), page = tr("Web page (*.html)"),
                  pictures = tr("Pictures, one for each step (*.png)");
    FileDialog dialog(&m_window, tr("Export steps"), QFileInfo(suggestion).absolutePath(),
                      QStringList{paper, page, pictures}.join(QStringLiteral(";;")));
    dialog.setObjectName(QStringLiteral("stepsExportDialog"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(kPaper);
    dialog.selectFile(QFileInfo(suggestion).fileName() + u'.' + kPaper);
    connect(&dialog, &QFileDialog::filterSelected, &dialog, [&](const QString &filter) {
        const QString suffix = filter == pictures ? kPictures : filter == page ? kPage : kPaper;
        dialog.setDefaultSuffix(suffix);
        // The name is then none of a file.
        dialog.setOption(QFileDialog::DontConfirmOverwrite, filter == pictures);
        const QFileInfo chosen(dialog.selectedFiles().value(0));
        if (!chosen.isDir())
            dialog.selectFile(withoutSuffix(chosen.fileName()) + u'.' + suffix);
    });
    // A suffix that was typed is meant, with any other one the filter decides.
    const QString path = dialog.target();
    if (path.isEmpty())
        return false;
    // With the filter of pictures the dialog has asked about nothing.
    const bool wasAsked = !dialog.testOption(QFileDialog::DontConfirmOverwrite);
    if (!isPictures(path) && !wasAsked && !mayReplace(m_window, {{path, {}}}))
        return false;
    return write(subject, path);
}

StepsFiles::Options StepsExport::optionsFor(const Subject &subject, const QString &path) const
{
    StepsFiles::Options options;
    options.kind = isPictures(path) ? StepsFiles::Kind::Pictures
                   : isPage(path)   ? StepsFiles::Kind::Page
                                    : StepsFiles::Kind::Paper;
    options.paper = {subject.title, StepsPaper::usualSize(m_window.locale()), settings().unit(),
                     stockName, nullptr};
    options.looking = subject.looking;
    return options;
}

bool StepsExport::write(const Subject &subject, const QString &path)
{
    const AssemblyStepsPointer &steps = subject.steps;
    const QString name = QFileInfo(path).fileName();
    StepsFiles::Options options = optionsFor(subject, path);
    if (!isPictures(path))
        options.paper.layout = *inBackground<std::shared_ptr<const Layout>>(
            m_window, tr("Exporting %1…").arg(name), MayCancel::No,
            [analysis = steps->analysis, cutting = subject.cutting] {
                return layoutFor(*analysis, cutting);
            });
    StepsFiles files(steps, options);
    const auto count = static_cast<std::size_t>(steps->playback.stepCount());
    if (isPictures(path) &&
        !mayReplace(m_window, io::numberedFiles(path, std::vector<std::string>(count), kPictures,
                                                io::digitsFor(count))))
        return false;
    const Pieces made = doInPieces(m_window, tr("Exporting %1…").arg(name), files.pieceCount(),
                                   [&](int piece) { return files.makePiece(piece); });
    if (made == Pieces::GivenUp) {
        m_status.say(tr("Nothing was written: the export was cancelled."));
        return false;
    }
    if (made == Pieces::Failed) {
        m_messages.show(MessageBar::Severity::Error,
                        {tr("The steps could not be exported: no picture can be made on this "
                            "display.")});
        return false;
    }
    const std::vector<io::NamedBytes> named =
        isPictures(path) ? io::numberedFiles(path, files.take(), kPictures, io::digitsFor(count))
                         : std::vector<io::NamedBytes>{{path, files.take().front()}};
    const auto written =
        inBackground<Result<void>>(m_window, tr("Exporting %1…").arg(name), MayCancel::No, [named] {
            return named.size() == 1 ? io::writeFile(named[0].path, named[0].bytes)
                                     : io::writeFiles(named);
        });
    if (!*written)
        return tellFailure(subject, path, written->error());
    m_messages.dismiss();
    const auto nameOf = [](const io::NamedBytes &one) { return QFileInfo(one.path).fileName(); };
    const QString said = tr("%n step(s)", nullptr, static_cast<int>(count));
    m_status.say(
        named.size() == 1
            ? tr("Exported %1 to %2.").arg(said, nameOf(named.front()))
            : tr("Exported %1 to %2 … %3.").arg(said, nameOf(named.front()), nameOf(named.back())));
    return true;
}

bool StepsExport::tellFailure(const Subject &subject, const QString &path, const Error &error)
{
    const QString base = QFileInfo(path).absolutePath() + u'/' + QFileInfo(path).completeBaseName();
    m_messages.show(MessageBar::Severity::Error, {saveFailure(path, error)},
                    {{tr("Export somewhere else…"), [this, subject, base] { ask(subject, base); }}},
                    failureDetails(path, error));
    return false;
}

} // namespace fff::ui
