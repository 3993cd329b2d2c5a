#include "ui/base/translations.h"

#include "ui/settings/languages.h"
#include "ui/settings/settings.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

namespace fff::ui {

namespace {

/// The language in the person's country where that writes its numbers as the language does: in an
/// English sentence a German comma would be read as something else.
QLocale localeOf(QLocale::Language language)
{
    const QLocale usual(language), there(language, QLocale::system().territory());
    return there.decimalPoint() == usual.decimalPoint() ? there : usual;
}

/// Numbers and dates as the sentences that they stand in. Who has the language as the system's has
/// it with all that was chosen there; so has C, which is English.
void speak(const QString &code)
{
    const QLocale spoken(code), now;
    const bool isEnglishAnyway =
        spoken.language() == QLocale::English && now.language() == QLocale::C;
    if ((spoken.language() == now.language() && spoken.script() == now.script()) || isEnglishAnyway)
        return;
    QLocale::setDefault(code.contains(u'_') ? spoken : localeOf(spoken.language()));
}

} // namespace

void installTranslations(QCoreApplication &application)
{
    if (const QString code = settings().language(); !code.isEmpty())
        speak(code);
    // The system may have another language for its numbers than for its words, or one that there is
    // no translation into.
    const QString wanted = languageFor(QLocale());
    const QString code = wanted.isEmpty() ? QStringLiteral("en") : wanted;
    speak(code);
    auto *ofProgram = new QTranslator(&application);
    auto *ofQt = new QTranslator(&application);
    // Qt's own buttons only in the language that the rest has.
    if (ofQt->load(QLocale(code), QStringLiteral("qtbase"), QStringLiteral("_"),
                   QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(ofQt);
    if (ofProgram->load(QStringLiteral(":/i18n/flatfitfab_") + code))
        QCoreApplication::installTranslator(ofProgram);
}

} // namespace fff::ui
