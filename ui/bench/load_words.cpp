#include "ui/bench/load_words.h"

#include "ui/bench/measures.h"

#include <QCoreApplication>

#include <cmath>

namespace fff::ui {

namespace {

struct LoadTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::Loads)
};

} // namespace

QString loadName(const Load &load)
{
    if (!load.name.empty())
        return QString::fromStdString(load.name);
    return load.isPush() ? LoadTexts::tr("Push") : LoadTexts::tr("Weight");
}

QString loadTitle(const Load &load, const QString &section)
{
    return load.name.empty() && !section.isEmpty() ? section : loadName(load);
}

QString loadAmount(const Load &load, const QLocale &locale)
{
    return load.isPush() ? forceText(load.push.norm(), locale) : massText(load.mass, locale);
}

QString forceText(double newtons, const QLocale &locale)
{
    const int digits = newtons < 10.0 ? 2 : newtons < 100.0 ? 1 : 0;
    return LoadTexts::tr("%1\u202fN").arg(locale.toString(newtons, 'f', digits));
}

} // namespace fff::ui
