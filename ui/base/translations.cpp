#include "ui/base/translations.h"

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
void speak(QLocale::Language language)
{
    const QLocale::Language now = QLocale().language();
    if (language != now && !(language == QLocale::English && now == QLocale::C))
        QLocale::setDefault(localeOf(language));
}

} // namespace

void installTranslations(QCoreApplication &application)
{
    if (const QString code = settings().language(); !code.isEmpty())
        speak(QLocale(code).language());
    const QString folder = QStringLiteral(":/i18n"), name = QStringLiteral("flatfitfab"),
                  gap = QStringLiteral("_");
    auto *ofProgram = new QTranslator(&application);
    auto *ofQt = new QTranslator(&application);
    const bool isTranslated = ofProgram->load(QLocale(), name, gap, folder);
    // The system may have another language for its numbers than for its words, or one that there is
    // no translation into.
    speak(isTranslated ? QLocale(ofProgram->language()).language() : QLocale::English);
    if (isTranslated) {
        // Qt's own buttons only in the language that the rest has.
        if (ofQt->load(QLocale(), QStringLiteral("qtbase"), gap,
                       QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
            QCoreApplication::installTranslator(ofQt);
    } else if (!ofProgram->load(name + gap + QStringLiteral("en"), folder)) {
        return;
    }
    QCoreApplication::installTranslator(ofProgram);
}

} // namespace fff::ui
