#include "ui/bench/bearing_picture.h"

#include "core/analysis/asked_bearing.h"
#include "core/interaction/pick.h"
#include "core/session/scheduler.h"
#include "ui/bench/workbench.h"
#include "ui/settings/settings.h"

#include <QCoreApplication>

#include <cmath>

namespace fff::ui {

namespace {

struct BearingStateTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::BearingPicture)
};

QString obstacleText(BearingMap::Obstacle obstacle)
{
    switch (obstacle) {
    case BearingMap::Obstacle::NotThere:
        return BearingStateTexts::tr("The section is not there");
    case BearingMap::Obstacle::Falls:
        return BearingStateTexts::tr("It does not stand as it is");
    case BearingMap::Obstacle::Breaks:
        return BearingStateTexts::tr("It breaks as it is");
    case BearingMap::Obstacle::NotRated:
        return BearingStateTexts::tr("Strength unknown");
    case BearingMap::Obstacle::None:
        break;
    }
    return {};
}

/// Of the section that is asked about now; null where that is not known yet.
std::shared_ptr<const BearingMap> bearingNow(const Scheduler &scheduler)
{
    const auto asked = scheduler.result(kBearing);
    const bool isOfThis =
        asked && asked->map && scheduler.questions().bearing == asked->map->section;
    return isOfThis ? asked->map : nullptr;
}

} // namespace

QString bearingState(const Scheduler &scheduler)
{
    if (!scheduler.questions().bearing)
        return {};
    if (scheduler.isRunning(kBearing.name)) {
        const double share = scheduler.progress(kBearing.name);
        return share >= 0.0
                   ? BearingStateTexts::tr("working… %1\u202f%").arg(std::lround(100.0 * share))
                   : BearingStateTexts::tr("working…");
    }
    if (const auto &why = scheduler.failureOf(kBearing.name))
        return why->code == ErrorCode::Cancelled ? BearingStateTexts::tr("stopped")
                                                 : BearingStateTexts::tr("could not be worked out");
    const auto map = bearingNow(scheduler);
    return map ? obstacleText(map->obstacle) : BearingStateTexts::tr("working…");
}

BearingPicture::BearingPicture(Workbench &bench, QObject *parent) : QObject(parent), m_bench(bench)
{
    const Scheduler &scheduler = bench.session().scheduler();
    connect(&scheduler, &Scheduler::published, this, [this](std::string_view stage) {
        if (stage == kBearing.name && isAsked())
            Q_EMIT changed();
    });
    connect(&scheduler, &Scheduler::asked, this, &BearingPicture::changed);
    for (const auto signal : {&Scheduler::aged, &Scheduler::progressed})
        connect(&scheduler, signal, this, [this] {
            if (isAsked())
                Q_EMIT changed();
        });
}

bool BearingPicture::isAsked() const
{
    return m_bench.session().scheduler().questions().bearing.has_value();
}

const BearingMarks *BearingPicture::marks()
{
    if (!isAsked() || m_bench.tried())
        return nullptr;
    const Scheduler &scheduler = m_bench.session().scheduler();
    auto map = bearingNow(scheduler);
    if (map != m_marks.map) {
        m_marks.asked.reset();
        m_marks.field = map && !map->points.empty() ? bearingField(*map) : nullptr;
    }
    m_marks.saysRigid = settings().bendsSections();
    m_marks.map = std::move(map);
    m_marks.said = bearingState(scheduler);
    m_marks.isOlder = m_marks.map && m_marks.map->analysis != m_bench.session().analysisPointer();
    return &m_marks;
}

void BearingPicture::hover(const QPointF &point, const Vec2 &viewport)
{
    const Interaction &interaction = m_bench.interaction();
    if (!isAsked() || !m_marks.map || m_marks.isOlder || interaction.hasGesture())
        return leave();
    const Model &model = m_marks.map->analysis->model;
    const Camera &camera = interaction.camera();
    const std::vector<Hit> hits =
        pick(model, camera.rayThrough(Vec2(point.x(), point.y()), viewport), interaction.view());
    if (hits.empty() || hits.front().section != model.indexOf(m_marks.map->section))
        return leave();
    m_marks.asked = bearingAt(*m_marks.map, hits.front().local);
    m_marks.place = hits.front().point;
    Q_EMIT changed();
}

void BearingPicture::leave()
{
    if (!m_marks.asked)
        return;
    m_marks.asked.reset();
    Q_EMIT changed();
}

} // namespace fff::ui
