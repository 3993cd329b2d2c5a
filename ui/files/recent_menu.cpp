#include "ui/files/recent_menu.h"

#include "ui/base/icon.h"
#include "ui/settings/settings.h"

#include <QDir>
#include <QFileInfo>

namespace fff::ui {

RecentMenu::RecentMenu(QWidget *parent) : QMenu(tr("Open &recent"), parent)
{
    setObjectName(QStringLiteral("recentMenu"));
    setIcon(themedIcon(QStringLiteral("clock")));
    setToolTipsVisible(true);
    connect(&settings(), &Settings::recentFilesChanged, this, &RecentMenu::rebuild,
            Qt::QueuedConnection); // its own entries change the list
    connect(this, &QMenu::aboutToShow, this, &RecentMenu::rebuild);
    rebuild();
}

void RecentMenu::rebuild()
{
    clear();
    const QStringList files = settings().recentFiles();
    for (const QString &path : files) {
        QString name = QFileInfo(path).fileName();
        name.replace(u'&', QStringLiteral("&&"));
        const bool exists = QFileInfo::exists(path);
        QAction *entry = addAction(exists ? name : tr("%1 (missing)").arg(name));
        entry->setObjectName(QStringLiteral("recent"));
        entry->setIcon(themedIcon(exists ? QStringLiteral("new") : QStringLiteral("warn")));
        entry->setToolTip(QDir::toNativeSeparators(path));
        connect(entry, &QAction::triggered, this, [this, path] { Q_EMIT chosen(path); });
    }
    menuAction()->setEnabled(!files.isEmpty());
    if (files.isEmpty())
        return;
    addSeparator();
    QAction *forget = addAction(themedIcon(QStringLiteral("trash")), tr("&Clear this list"));
    forget->setObjectName(QStringLiteral("clearRecent"));
    forget->setToolTip(tr("Forget these names; the files stay"));
    connect(forget, &QAction::triggered, this, [] { settings().clearRecentFiles(); });
}

} // namespace fff::ui
