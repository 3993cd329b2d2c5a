#include "ui/files/file_drop.h"

#include <QDropEvent>
#include <QMimeData>
#include <QTimer>
#include <QUrl>
#include <QWidget>

namespace fff::ui {

namespace {

QStringList pathsIn(const QMimeData *data)
{
    QStringList paths;
    if (!data)
        return paths;
    for (const QUrl &url : data->urls()) {
        if (url.isLocalFile())
            paths += url.toLocalFile();
    }
    return paths;
}

} // namespace

FileDrop::FileDrop(QWidget &window) : QObject(&window)
{
    window.setAcceptDrops(true);
    window.installEventFilter(this);
}

bool FileDrop::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::DragEnter && event->type() != QEvent::Drop)
        return QObject::eventFilter(watched, event);
    auto *drop = static_cast<QDropEvent *>(event); // DragEnter is one too
    const QStringList paths = pathsIn(drop->mimeData());
    if (paths.isEmpty())
        return false;
    // What is dropped stays where it is, whatever the other program would do with a move.
    drop->setDropAction(Qt::CopyAction);
    drop->accept();
    if (event->type() == QEvent::Drop) {
        // Later: the other program waits until the drop is over.
        QTimer::singleShot(0, this, [this, paths] { Q_EMIT dropped(paths); });
    }
    return true;
}

} // namespace fff::ui
