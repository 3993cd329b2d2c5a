#include "ui/base/file_dialog.h"

#include "ui/base/theme.h"

#include <QAbstractItemView>
#include <QCompleter>

namespace fff::ui {

FileDialog::FileDialog(QWidget *parent, const QString &title, const QString &folder,
                       const QString &filter)
    : QFileDialog(parent, title, folder, filter)
{
    setPalette(theme().palette());
}

void FileDialog::showEvent(QShowEvent *event)
{
    QFileDialog::showEvent(event);
    // The names that fit are listed in a window of their own.
    for (const QCompleter *completer : findChildren<QCompleter *>())
        completer->popup()->setPalette(theme().palette());
}

} // namespace fff::ui
