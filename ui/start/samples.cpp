#include "ui/start/samples.h"

#include <QCoreApplication>
#include <QFile>

namespace fff::ui {

namespace {

struct SamplesTexts
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
    // With values to adjust, as lamp and gears have them, too.
    {"shelf", QT_TRANSLATE_NOOP("fff::ui::Samples", "Shelf")},
    {"drawer_organiser", QT_TRANSLATE_NOOP("fff::ui::Samples", "Drawer organiser")},
    {"name_plate", QT_TRANSLATE_NOOP("fff::ui::Samples", "Name plate")},
    {"glass_four_legs", QT_TRANSLATE_NOOP("fff::ui::Samples", "Glass stand")},
    // Drawn over a mesh, over pictures, and cut from a mesh.
    {"bear", QT_TRANSLATE_NOOP("fff::ui::Samples", "Bear over a mesh")},
    {"owl", QT_TRANSLATE_NOOP("fff::ui::Samples", "Owl from pictures")},
    {"hedgehog", QT_TRANSLATE_NOOP("fff::ui::Samples", "Hedgehog in slices")},
    // With operations to play with.
    {"bony_fish", QT_TRANSLATE_NOOP("fff::ui::Samples", "Fish bones")},
    {"dinosaur", QT_TRANSLATE_NOOP("fff::ui::Samples", "Dinosaur")},
    {"beetle", QT_TRANSLATE_NOOP("fff::ui::Samples", "Stag beetle")},
    {"growing_tree", QT_TRANSLATE_NOOP("fff::ui::Samples", "Growing tree")},
    {"two_poses", QT_TRANSLATE_NOOP("fff::ui::Samples", "Dancers in two poses")},
    {"bridge", QT_TRANSLATE_NOOP("fff::ui::Samples", "Footbridge")},
    {"gears", QT_TRANSLATE_NOOP("fff::ui::Samples", "Gears")},
    {"whale", QT_TRANSLATE_NOOP("fff::ui::Samples", "Whale in cells")},
    {"cutlery_man", QT_TRANSLATE_NOOP("fff::ui::Samples", "Cutlery man")},
    {"glass_three_legs", QT_TRANSLATE_NOOP("fff::ui::Samples", "Glass on three legs")},
    {"acrylic_thin_three", QT_TRANSLATE_NOOP("fff::ui::Samples", "Three thin legs: too weak")},
    {"acrylic_thin_four", QT_TRANSLATE_NOOP("fff::ui::Samples", "Four thin legs: too weak")},
    {"acrylic_thick_three", QT_TRANSLATE_NOOP("fff::ui::Samples", "Three thick legs: barely")},
    {"acrylic_thick_four", QT_TRANSLATE_NOOP("fff::ui::Samples", "Four thick legs: safe")},
};

} // namespace

QList<Sample> samples()
{
    QList<Sample> all;
    for (const Row &row : kRows)
        all.append({SamplesTexts::tr(row.name),
                    QStringLiteral(":/samples/%1.fff").arg(QLatin1String(row.file))});
    return all;
}

} // namespace fff::ui
