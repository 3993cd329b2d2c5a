#include "ui/base/naming.h"

#include <QCoreApplication>
#include <QDir>
#include <QTranslator>

namespace fff::ui {

namespace {

constexpr char kContext[] = "fff::ui::Naming";
//: the name of a section that nobody has named; %1 is its number
constexpr const char *kSection = QT_TRANSLATE_NOOP("fff::ui::Naming", "Section %1");

} // namespace

Naming naming()
{
    Naming names;
    names.others.push_back(names.section); // the command line's, and those of old files
    names.section = QCoreApplication::translate(kContext, kSection).toStdString();
    const QDir languages(QStringLiteral(":/i18n"));
    for (const QString &file : languages.entryList({QStringLiteral("flatfitfab_*.qm")})) {
        QTranslator other;
        if (!other.load(languages.filePath(file)))
            continue;
        const std::string section = other.translate(kContext, kSection).toStdString();
        if (!section.empty())
            names.others.push_back(section);
    }
    std::erase(names.others, names.section);
    return names;
}

} // namespace fff::ui
