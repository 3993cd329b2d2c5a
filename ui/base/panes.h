// Going round the window by key: tool bar, left docks, view, right docks.
#pragma once

class QDockWidget;
class QMainWindow;
class QWidget;

namespace fff::ui {

/// Gives the focus to the next pane (step 1) or to the one before (−1), to what had it there last.
/// `view` is what stands in the middle. Panes that cannot be seen are left out.
void goToPane(QMainWindow &window, QWidget *toolBar, QWidget *view, int step);

/// False also for what lies in a dock behind another tab, which says that it is visible.
bool isSeen(const QWidget *widget);

bool isInDock(const QWidget *widget);

/// To the first field of a dock, which is opened for it.
void goInto(QDockWidget &dock);

} // namespace fff::ui
