// The program's colours, light and dark, and both in high contrast, as set or after the system.
// Widgets take them through the window's palette; what draws by itself asks theme(). Dialogs and
// what comes later is dressed by itself.
#pragma once

#include "ui/view/view_style.h"

#include <QColor>
#include <QPalette>

class QWidget;

namespace fff::ui {

struct Theme
{
    bool isDark = false;
    bool isHighContrast = false; // 7:1 where the others have 4.5:1 and 3:1
    QColor window, panel, alternate, text, muted;
    QColor border, strong; // separators; borders of fields
    QColor accent, onAccent, soft, hover;
    QColor problem, problemSoft, warning, warningSoft, good;
    QColor button;

    QPalette palette() const;
    /// For the few things that the palette cannot say (ui/UI.md, section 4).
    QString styleSheet() const;
    ViewStyle viewStyle() const;
};

/// The one in use.
const Theme &theme();

/// Chooses by the settings, else by the application's palette and what the system asks for, and
/// dresses the window with it, with all that hangs on it. The application's own palette stays the
/// system's, so that a change of it is seen.
void applyTheme(QWidget *window);

/// For dialogs, and for what is put into a window after it was dressed: neither takes the window's
/// palette by itself. When all in it is made. refreshDressed() does it again after a change.
void dress(QWidget *widget);
void refreshDressed(QWidget *window);

} // namespace fff::ui
