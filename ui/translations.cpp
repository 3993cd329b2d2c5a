#include "ui/translations.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

namespace fff::ui {

void installTranslations(QCoreApplication &application)
{
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
