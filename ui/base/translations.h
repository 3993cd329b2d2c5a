// The window's languages.
#pragma once

class QCoreApplication;

namespace fff::ui {

/// The language that is set, else the system's when there is a translation into it, else English.
/// Once, before the first window: texts are read when a window is made. English has a file too: it
/// says "1 section" and "2 sections".
void installTranslations(QCoreApplication &application);

} // namespace fff::ui
