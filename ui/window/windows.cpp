#include "ui/window/windows.h"

#include "core/interaction/value_editing.h"
#include "core/io/document_file.h"
#include "ui/bench/workbench.h"
#include "ui/files/document_files.h"
#include "ui/start/sample_texts.h"
#include "ui/start/samples.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QFileInfo>
#include <QRegularExpression>
#include <QScreen>

namespace fff::ui {

namespace {

constexpr int kStep = 28; // px that a window lies beside the one before

bool isSameFile(const QString &a, const QString &b)
{
    const QString one = QFileInfo(a).canonicalFilePath();
    return !one.isEmpty() && one == QFileInfo(b).canonicalFilePath();
}

/// A copy of a sample is called as its card says, as far as file systems take that.
QString nameOfCopy(const QString &path)
{
    for (const Sample &sample : samples()) {
        if (sample.path != path)
            continue;
        QString name = sample.name;
        name.replace(QStringLiteral(": "), QStringLiteral(", "));
        name.remove(QRegularExpression(QStringLiteral("[\\\\/:*?\"<>|]")));
        return name + QStringLiteral(".fff");
    }
    return path;
}

void bringForward(MainWindow *window)
{
    window->setWindowState(window->windowState() & ~Qt::WindowMinimized);
    window->raise();
    window->activateWindow();
}

MainWindow *windowOf(const QString &path)
{
    for (MainWindow *window : mainWindows()) {
        if (isSameFile(window->files().path(), path))
            return window;
    }
    return nullptr;
}

} // namespace

QList<MainWindow *> mainWindows()
{
    QList<MainWindow *> windows;
    for (QWidget *widget : QApplication::topLevelWidgets()) {
        auto *window = qobject_cast<MainWindow *>(widget);
        if (window && window->isVisible())
            windows += window;
    }
    return windows;
}

MainWindow *openWindow(const MainWindow *beside)
{
    auto *window = new MainWindow;
    window->setAttribute(Qt::WA_DeleteOnClose);
    if (beside && !beside->isMaximized() && !beside->isFullScreen()) {
        window->resize(beside->size());
        const QPoint place = beside->pos() + QPoint(kStep, kStep);
        const QScreen *screen = beside->screen();
        if (screen && screen->availableGeometry().contains(place + QPoint(200, 200)))
            window->move(place);
    }
    window->show();
    bringForward(window);
    return window;
}

int openFiles(MainWindow &from, const QStringList &paths, bool asCopy)
{
    int count = 0;
    for (const QString &path : paths) {
        if (MainWindow *shows = asCopy ? nullptr : windowOf(path)) {
            bringForward(shows);
            ++count;
            continue;
        }
        std::optional<io::LoadedDocument> loaded = from.files().read(path);
        if (!loaded)
            continue;
        if (path.startsWith(u":/")) // samples, lessons
            loaded->document = inThisLanguage(loaded->document);
        MainWindow *window = from.files().isUntouched() ? &from : openWindow(&from);
        window->files().show(*loaded, asCopy ? nameOfCopy(path) : path, asCopy);
        window->showDocument();
        // A sample with values is there to be adjusted.
        if (asCopy && hasShownValue(loaded->document.values))
            window->bench().run(QStringLiteral("view.values"));
        ++count;
    }
    return count;
}

MainWindow &startNewDocument(MainWindow &from)
{
    MainWindow &window = from.files().isEmpty() ? from : *openWindow(&from);
    window.showDocument();
    return window;
}

bool closeAllWindows()
{
    const QList<MainWindow *> windows = mainWindows();
    for (MainWindow *window : windows) {
        if (!window->files().isSaved())
            bringForward(window);
        if (!window->files().mayClose())
            return false;
    }
    for (MainWindow *window : windows)
        window->closeUnasked();
    return true;
}

} // namespace fff::ui
