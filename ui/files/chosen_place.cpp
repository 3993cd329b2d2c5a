#include "ui/files/chosen_place.h"

#include "core/io/file_set.h"
#include "core/io/formats.h"
#include "ui/base/file_dialog.h"
#include "ui/dialogs/export_choices.h"
#include "ui/files/format_filters.h"
#include "ui/files/replace_question.h"
#include "ui/files/workshop.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

namespace fff::ui {

namespace {

struct ChosenPlaceTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::ChosenPlace)
};

/// Without what the kinds of files end in; what follows another dot ("chair.v2") is no suffix.
QString withoutExportSuffix(const QString &path)
{
    const QString suffix = QFileInfo(path).suffix();
    return io::formatWritten(suffix, &io::Format::isExported) ? path.chopped(suffix.size() + 1)
                                                              : path;
}

/// Its folder has not gone, and takes files.
bool canTake(const QString &path)
{
    const QFileInfo folder(QFileInfo(path).absolutePath());
    return folder.isDir() && folder.isWritable();
}

} // namespace

QString baseOf(const ExportTarget &target, const QString &suggestion)
{
    const QFileInfo folder(target.path);
    return exportKindNamed(target.kind).isFolder
               ? folder.dir().filePath(QFileInfo(suggestion).fileName())
               : withoutExportSuffix(target.path);
}

QString askForExport(QWidget *parent, const ExportKind &kind, const QString &suggestion)
{
    if (kind.isFolder)
        return askForWorkshopFolder(parent, suggestion);
    FileDialog dialog(parent, ChosenPlaceTexts::tr("Export to"),
                      QFileInfo(suggestion).absolutePath(), kind.filter);
    const QString suffix = kind.format->suffix();
    dialog.setObjectName(QStringLiteral("exportFileDialog"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(suffix);
    // The name is then none of a file.
    dialog.setOption(QFileDialog::DontConfirmOverwrite, kind.isFilePerSheet);
    dialog.selectFile(QFileInfo(suggestion).fileName() + u'.' + suffix);
    return dialog.target();
}

ChosenPlace::ChosenPlace(const QString &suggestion, std::optional<ExportTarget> before,
                         std::function<bool(const QString &)> isOurs)
    : m_base(suggestion), m_isOurs(std::move(isOurs))
{
    if (before && canTake(before->path)) {
        m_before = std::move(before);
        m_base = baseOf(*m_before, suggestion);
    } else if (!canTake(m_base)) {
        m_base = QDir(documentsFolder()).filePath(QFileInfo(m_base).fileName());
    }
}

ExportTarget ChosenPlace::target(const ExportFile &file) const
{
    if (const auto &known = m_chosen ? m_chosen : m_before; known && known->kind == file.key)
        return *known;
    const ExportKind kind = exportKindNamed(file.key);
    return {kind.isFolder ? workshopFolder(m_base) : m_base + u'.' + kind.format->suffix(),
            file.key};
}

QString ChosenPlace::pathOf(const ExportFile &file) const
{
    const QString path = target(file).path;
    return file.isFilePerSheet
               ? io::numberedFiles(path, {{}}, exportKindNamed(file.key).format->suffix())
                     .front()
                     .path
               : path;
}

bool ChosenPlace::change(QWidget *dialog, const ExportFile &file)
{
    const QString path =
        askForExport(dialog, exportKindNamed(file.key), file.isFolder ? target(file).path : m_base);
    if (path.isEmpty())
        return false;
    m_chosen = ExportTarget{path, file.key};
    m_base = baseOf(*m_chosen, m_base);
    return true;
}

bool ChosenPlace::mayWrite(QWidget *dialog, const ExportFile &file)
{
    // The file box has asked about the one that was chosen there; what is in several files is known
    // only when they are made.
    const ExportTarget now = target(file);
    return m_chosen == now || file.isFilePerSheet || file.isFolder || m_isOurs(now.path) ||
           mayReplace(*dialog, {{now.path, {}}});
}

} // namespace fff::ui
