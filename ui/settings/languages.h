// The languages that the window can speak: those that a translation is embedded for.
#pragma once

#include <QStringList>

class QLocale;

namespace fff::ui {

/// As the settings name them: "de", "en", "pt_BR". Found when it is asked; Latin letters first.
const QStringList &languagesThere();
/// In itself, so that whoever got lost finds back: "Deutsch", "Português (Brasil)".
QString nameOfLanguage(const QString &code);
/// The one that suits these wishes best: of its territory or writing, else of its language where
/// the writing is the same; empty: there is none.
QString languageFor(const QLocale &wanted);

} // namespace fff::ui
