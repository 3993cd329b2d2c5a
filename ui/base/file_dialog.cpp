#include "ui/base/file_dialog.h"

#include "ui/base/theme.h"
#include "ui/settings/settings.h"

#include <QAbstractItemView>
#include <QCompleter>
#include <QFileInfo>
#include <QLineEdit>
#include <QRegularExpression>
#include <QStandardPaths>

namespace fff::ui {

QString documentsFolder()
{
    if (const QString folder = settings().workFolder(); !folder.isEmpty())
        return folder;
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return QFileInfo(documents).isDir() ? documents : QDir::homePath();
}

FileDialog::FileDialog(QWidget *parent, const QString &title, const QString &folder,
                       const QString &filter)
    : QFileDialog(parent, title, folder, filter)
{
    setPalette(theme().palette());
}

/// The suffix is one of those that the filters name.
bool FileDialog::isOfItsKinds(const QString &path) const
{
    static const QRegularExpression pattern(QStringLiteral("\\*(\\.\\w+)"));
    for (const QString &filter : nameFilters())
        for (auto known = pattern.globalMatch(filter); known.hasNext();)
            if (path.endsWith(known.next().captured(1), Qt::CaseInsensitive))
                return true;
    return false;
}

QString FileDialog::target()
{
    // The desktop's own dialog knows nothing of accept(): where the whole name is taken, it is
    // shown again with that, and asks.
    while (exec() == QDialog::Accepted) {
        const QString path = selectedFiles().value(0);
        const QString whole = path + u'.' + defaultSuffix();
        if (isOfItsKinds(path))
            return path;
        if (!QFileInfo::exists(whole))
            return whole;
        selectFile(whole);
    }
    return {};
}

void FileDialog::accept()
{
    const QString path = selectedFiles().value(0);
    if (acceptMode() == AcceptSave && !path.isEmpty() && !QFileInfo(path).isDir() &&
        !isOfItsKinds(path)) {
        const QString whole = path + u'.' + defaultSuffix();
        selectFile(whole);
        // The line that is typed into keeps what is there.
        if (auto *line = findChild<QLineEdit *>(QStringLiteral("fileNameEdit")))
            line->setText(QFileInfo(whole).fileName());
    }
    QFileDialog::accept();
}

void FileDialog::showEvent(QShowEvent *event)
{
    QFileDialog::showEvent(event);
    // A dialog that saves makes buttons and lists anew, in the desktop's colours; the names that
    // fit are listed in a window of their own.
    for (QWidget *part : findChildren<QWidget *>())
        part->setPalette(theme().palette());
    for (const QCompleter *completer : findChildren<QCompleter *>())
        completer->popup()->setPalette(theme().palette());
}

} // namespace fff::ui
