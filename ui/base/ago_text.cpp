#include "ui/base/ago_text.h"

#include <QCoreApplication>

namespace fff::ui {

namespace {

struct AgoTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::AgoText)
};

constexpr qint64 kMinute = 60, kHour = 60 * kMinute; // s

} // namespace

QString agoText(const QDateTime &then, const QDateTime &now, const QLocale &locale)
{
    const qint64 seconds = then.secsTo(now);
    if (seconds < kMinute)
        return AgoTexts::tr("just now");
    if (seconds < kHour)
        return AgoTexts::tr("%n minute(s) ago", nullptr, static_cast<int>(seconds / kMinute));
    const qint64 days = then.date().daysTo(now.date());
    if (days == 0)
        return AgoTexts::tr("%n hour(s) ago", nullptr, static_cast<int>(seconds / kHour));
    if (days == 1)
        return AgoTexts::tr("yesterday");
    if (days < 7)
        return AgoTexts::tr("%n day(s) ago", nullptr, static_cast<int>(days));
    return locale.toString(then.date(), QLocale::ShortFormat);
}

} // namespace fff::ui
