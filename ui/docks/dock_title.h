// A dock's title: its name, and the buttons that float and close it.
#pragma once

class QDockWidget;

namespace fff::ui {

/// Gives the dock this title, a stable object name and the window's habits.
void dressDock(QDockWidget *dock, const char *objectName);
/// Where its tab says the name, a title would say it again.
void setDockTitled(QDockWidget &dock, bool isTitled);
/// It stays where it is, without these buttons.
void setDockFixed(QDockWidget &dock, bool isFixed);

} // namespace fff::ui
