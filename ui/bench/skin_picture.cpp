#include "ui/bench/skin_picture.h"

#include "core/analysis/asked_skin.h"
#include "core/io/full_stop.h"
#include "core/io/listing.h"
#include "core/session/scheduler.h"
#include "core/session/session.h"
#include "ui/bench/workbench.h"
#include "ui/view/skin_scene.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace fff::ui {

namespace {

struct SkinStateTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::SkinPicture)
};

/// So many places, and sections of each, are named; more nobody reads.
constexpr std::size_t kNamedPlaces = 3, kNamedSections = 4;

QString namesOf(const OpenPlace &place, const std::vector<SectionPointer> &sections)
{
    QStringList names;
    for (const int section : place.sections) {
        if (names.size() == static_cast<qsizetype>(kNamedSections)) {
            names += QStringLiteral("…");
            break;
        }
        names += QString::fromStdString(sections[static_cast<std::size_t>(section)]->name);
    }
    return separated(names);
}

/// Why the first of the places stay open, a line each.
QString whyOpen(const AskedSkin &asked)
{
    using Why = OpenPlace::Why;
    QString lines;
    for (std::size_t i = 0; i < std::min(asked.skin.places.size(), kNamedPlaces); ++i) {
        const OpenPlace &place = asked.skin.places[i];
        //: %1 names the sections round a place
        const QString line =
            place.why == Why::Bulging
                ? SkinStateTexts::tr("Between %1 it would bulge far out: one more section across "
                                     "says how far.")
            //: %1 names the sections round a place
            : place.why == Why::Folded
                ? SkinStateTexts::tr("Between %1 it would fold over itself.")
                //: %1 names the sections round a place
                : SkinStateTexts::tr("What is between %1 cannot be told from their contours.");
        lines += u'\n';
        lines += line.arg(namesOf(place, asked.sections));
    }
    return lines;
}

} // namespace

QString skinState(const Scheduler &scheduler)
{
    if (!scheduler.questions().skin)
        return {};
    if (scheduler.isRunning(kSkin.name)) {
        const double share = scheduler.progress(kSkin.name);
        return share >= 0.0
                   ? SkinStateTexts::tr("Skin: working… %1\u202f%").arg(std::lround(100.0 * share))
                   : SkinStateTexts::tr("Skin: working…");
    }
    if (const auto &why = scheduler.failureOf(kSkin.name))
        return why->code == ErrorCode::Cancelled
                   ? SkinStateTexts::tr("Skin: stopped")
                   : SkinStateTexts::tr("Skin: could not be worked out");
    const auto asked = scheduler.result(kSkin);
    if (!asked || !asked->isAsked)
        return SkinStateTexts::tr("Skin: working…");
    if (asked->skin.mesh)
        return SkinStateTexts::tr("Skin");
    return asked->skin.open > 0 ? SkinStateTexts::tr("Skin: nothing to cover")
                                : SkinStateTexts::tr("Skin: no contours cross");
}

QString skinDetails(const Scheduler &scheduler)
{
    const auto asked = scheduler.result(kSkin);
    if (!scheduler.questions().skin || !asked || !asked->isAsked)
        return SkinStateTexts::tr("Click to stop.");
    if (!asked->skin.mesh)
        return SkinStateTexts::tr("A skin needs sections that cross each other and end in the same "
                                  "place there.");
    const QString patches = SkinStateTexts::tr("%n patches", "", asked->skin.patches);
    const QString open =
        asked->skin.open > 0
            ? SkinStateTexts::tr("%1; %n places stay open.", "", asked->skin.open).arg(patches)
            : withFullStop(patches);
    return open + u' ' + SkinStateTexts::tr("Click to see the sections alone again.") +
           whyOpen(*asked);
}

SkinPicture::SkinPicture(Workbench &bench, QObject *parent) : QObject(parent), m_bench(bench)
{
    const Scheduler &scheduler = bench.session().scheduler();
    connect(&scheduler, &Scheduler::published, this, [this](std::string_view stage) {
        if (stage == kSkin.name)
            Q_EMIT changed();
    });
    connect(&scheduler, &Scheduler::asked, this, &SkinPicture::changed);
}

std::optional<SceneTemplate> SkinPicture::shown() const
{
    const Scheduler &scheduler = m_bench.session().scheduler();
    const auto asked = scheduler.result(kSkin);
    if (!scheduler.questions().skin || !asked || !asked->shown || m_bench.tried())
        return {};
    return sceneSkin(asked->shown);
}

} // namespace fff::ui
