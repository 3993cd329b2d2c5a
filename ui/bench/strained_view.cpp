#include "ui/bench/strained_view.h"

#include "core/session/scheduler.h"
#include "ui/bench/held.h"
#include "ui/bench/workbench.h"
#include "ui/view/strained_scene.h"

namespace fff::ui {

StrainedView::StrainedView(Workbench &bench, QObject *parent)
    : QObject(parent), m_bench(bench), m_stress(bench), m_bearing(bench)
{
    connect(&m_stress, &StressPicture::changed, this, &StrainedView::changed);
    connect(&m_bearing, &BearingPicture::changed, this, &StrainedView::changed);
    connect(&bench, &Workbench::movementChanged, this, &StrainedView::moved);
}

const Scene &StrainedView::shown(Scene &scene, RenderOptions &options)
{
    const StressMarks *stress = m_stress.marks();
    showStress(scene, m_bench.shownModel(), stress ? stress->bent.get() : nullptr);
    options.leastStress = stress ? stress->least : options.leastStress;
    options.stressAlpha = stress && stress->isOlder ? kOlderStress : 1.0;
    const auto movement = movementShown();
    if (!movement)
        showBearing(scene, options);
    return movement ? m_moved.at(scene, m_bench.shownModel(), *movement,
                                 m_bench.movement() * movement->mostTimes())
                    : scene;
}

/// In place of all stresses.
void StrainedView::showBearing(Scene &scene, RenderOptions &options)
{
    const BearingMarks *bearing = m_bearing.marks();
    const Model &model = m_bench.shownModel();
    if (!bearing || scene.sections.size() != model.sectionCount())
        return;
    for (SceneSection &section : scene.sections)
        section.fields.clear();
    const int index = bearing->map ? model.indexOf(bearing->map->section) : -1;
    if (!bearing->field || index < 0)
        return;
    scene.sections[static_cast<std::size_t>(index)].fields = {bearing->field};
    options.leastStress = 0.0;
    options.stressAlpha = bearingAlpha(*bearing);
}

std::optional<Movement> StrainedView::movementShown() const
{
    if (m_bench.movement() == 0.0 || m_bench.tried())
        return {};
    return movementNow(m_bench.session().scheduler());
}

double StrainedView::timesMoved() const
{
    const auto movement = movementShown();
    return movement ? m_bench.movement() * movement->mostTimes() : 0.0;
}

void StrainedView::hover(const QPointF &point, const Vec2 &viewport)
{
    if (movementShown())
        return leave();
    m_stress.hover(point, viewport);
    m_bearing.hover(point, viewport);
}

void StrainedView::leave()
{
    m_stress.leave();
    m_bearing.leave();
}

void StrainedView::press(const QPointF &point)
{
    m_stress.press(point);
    m_bearing.leave();
}

} // namespace fff::ui
