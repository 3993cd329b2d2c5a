#include "ui/base/file_dialog.h"

#include "ui/base/theme.h"

#include <QAbstractItemView>
#include <QCompleter>
#include <QFileInfo>
#include <QStandardPaths>

namespace fff::ui {

QString documentsFolder()
{
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return QFileInfo(documents).isDir() ? documents : QDir::homePath();
}

FileDialog::FileDialog(QWidget *parent, const QString &title, const QString &folder,
                       const QString &filter)
    : QFileDialog(parent, title, folder, filter)
{
    setPalette(theme().palette());
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
