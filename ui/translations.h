// The window's languages.
#pragma once

class QCoreApplication;

namespace fff::ui {

/// The system's language when there is a translation into it, else English. English has a file too:
/// it says "1 section" and "2 sections".
void installTranslations(QCoreApplication &application);

} // namespace fff::ui
