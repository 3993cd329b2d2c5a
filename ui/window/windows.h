// The program's windows: one process, each window with a document of its own.
#pragma once

#include <QList>
#include <QStringList>

namespace fff::ui {

class MainWindow;

/// Those that are shown.
QList<MainWindow *> mainWindows();

/// Made, shown, and gone when it is closed. A little beside `beside`.
MainWindow *openWindow(const MainWindow *beside = nullptr);

/// Each in its own window: the one that has it already, `from` while nothing was done in it, else a
/// new one. So no question is needed. What cannot be read is said in `from`.
/// Returns how many were opened or found open.
int openFiles(MainWindow &from, const QStringList &paths, bool asCopy = false);

/// An empty document, in `from` while nothing was done in it, else in a new window, which is
/// returned.
MainWindow &startNewDocument(MainWindow &from);

/// Asks for each window that has unsaved changes, closes all, or none when one of the questions was
/// given up.
bool closeAllWindows();

} // namespace fff::ui
