// When something was, in words: "2 minutes ago", "yesterday", "3 March".
#pragma once

#include <QDateTime>
#include <QLocale>

namespace fff::ui {

/// Both in local time. A time that is still to come (a clock was set back) reads as just now.
QString agoText(const QDateTime &then, const QDateTime &now, const QLocale &locale);

} // namespace fff::ui
