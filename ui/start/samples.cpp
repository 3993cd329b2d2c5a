#include "ui/start/samples.h"

#include <QCoreApplication>
#include <QFile>

namespace fff::ui {

namespace {

struct Words
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::Samples)
};

struct Row
{
    const char *file;
    const char *name;
};

const Row kRows[] = {
    {"fish", QT_TRANSLATE_NOOP("fff::ui::Samples", "Fish")},
    {"dachshund", QT_TRANSLATE_NOOP("fff::ui::Samples", "Dachshund")},
    {"tree", QT_TRANSLATE_NOOP("fff::ui::Samples", "Fir tree")},
    {"lamp", QT_TRANSLATE_NOOP("fff::ui::Samples", "Lamp shade")},
    {"chair", QT_TRANSLATE_NOOP("fff::ui::Samples", "Doll’s chair")},
    {"glass_holder", QT_TRANSLATE_NOOP("fff::ui::Samples", "Glass holder")},
    {"organiser", QT_TRANSLATE_NOOP("fff::ui::Samples", "Desk organiser")},
};

} // namespace

QList<Sample> samples()
{
    QList<Sample> all;
    for (const Row &row : kRows)
        all.append(
            {Words::tr(row.name), QStringLiteral(":/samples/%1.fff").arg(QLatin1String(row.file))});
    return all;
}

} // namespace fff::ui
