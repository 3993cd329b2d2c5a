#include "ui/translations.h"

#include "ui/settings/settings.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

namespace fff::ui {

namespace {

/// The language that is set, in the numbers of the person's country where that is known.
void applyLanguage()
{
    const QString code = settings().language();
    if (code.isEmpty())
        return;
    const QLocale chosen(code), system = QLocale::system();
    if (chosen.language() != system.language())
        QLocale::setDefault(QLocale(chosen.language(), system.territory()));
}

} // namespace

void installTranslations(QCoreApplication &application)
{
    applyLanguage();
    const QString folder = QStringLiteral(":/i18n"), name = QStringLiteral("flatfitfab"),
                  gap = QStringLiteral("_");
    auto *ofProgram = new QTranslator(&application);
    auto *ofQt = new QTranslator(&application);
    if (ofProgram->load(QLocale(), name, gap, folder)) {
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
