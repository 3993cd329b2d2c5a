#include "ui/settings/languages.h"

#include <QDir>
#include <QLocale>

#include <algorithm>

namespace fff::ui {

namespace {

constexpr char kBefore[] = "flatfitfab_", kBehind[] = ".qm";

/// Brazil's Portuguese is read in Portugal, simplified Chinese is none for Taiwan.
bool isReadBy(const QLocale &language, const QLocale &reader)
{
    return language.language() == reader.language() && language.script() == reader.script();
}

} // namespace

const QStringList &languagesThere()
{
    static const QStringList there = [] {
        QStringList codes;
        for (QString file : QDir(QStringLiteral(":/i18n"))
                                .entryList({QLatin1String(kBefore) + u'*' + QLatin1String(kBehind)},
                                           QDir::Files, QDir::Name)) {
            file.remove(QLatin1String(kBefore));
            codes += file.chopped(qstrlen(kBehind));
        }
        // Those in letters that most of the others' readers cannot read come last.
        std::stable_sort(codes.begin(), codes.end(), [](const QString &a, const QString &b) {
            const auto isLatin = [](const QString &code) {
                return QLocale(code).script() == QLocale::LatinScript;
            };
            return isLatin(a) > isLatin(b);
        });
        return codes;
    }();
    return there;
}

QString nameOfLanguage(const QString &code)
{
    const QLocale locale(code);
    QString name = locale.nativeLanguageName();
    if (name.isEmpty())
        return code;
    name[0] = locale.toUpper(name.first(1)).front();
    if (locale.script() != QLocale::LatinScript)
        return name;
    // Qt says where it is spoken where that is most usual: "American English", "Español de España".
    if (locale.language() == QLocale::English)
        return QStringLiteral("English");
    name = name.section(u' ', 0, 0);
    return code.contains(u'_') ? QStringLiteral("%1 (%2)").arg(name, locale.nativeTerritoryName())
                               : name;
}

QString languageFor(const QLocale &wanted)
{
    for (const QString &name : wanted.uiLanguages())
        for (const QString &code : languagesThere())
            if (QString(code).replace(u'_', u'-') == name)
                return code;
    for (const QString &name : wanted.uiLanguages())
        for (const QString &code : languagesThere())
            if (isReadBy(QLocale(code), QLocale(name)))
                return code;
    return {};
}

} // namespace fff::ui
