// What lies over the model in the view, and the words among it that can be clicked.
#include "ui/bench/viewport.h"

#include "core/interaction/load_tool.h"
#include "core/model/origin.h"
#include "ui/base/theme.h"
#include "ui/bench/marked_scene.h"
#include "ui/bench/workbench.h"
#include "ui/settings/settings.h"
#include "ui/view/measure_marks.h"
#include "ui/view/overlay_painter.h"
#include "ui/view/steps_scene.h"

#include <QPainter>

#include <utility>

namespace fff::ui {

void Viewport::paintMarks()
{
    const QSize pixels = size() * devicePixelRatioF();
    if (m_marks.size() != pixels)
        m_marks = QImage(pixels, QImage::Format_ARGB32_Premultiplied);
    m_marks.setDevicePixelRatio(devicePixelRatioF());
    m_marks.fill(Qt::transparent);
    const Interaction &interaction = m_bench.interaction();
    const Overlay &overlay = interaction.overlay();
    const Model &model = m_bench.session().model();
    const Hovered &over = interaction.hovered();
    OverlayScene scene{overlay,
                       over,
                       interaction.camera(),
                       Vec2(width(), height()),
                       m_scene.sections.empty() && m_scene.templates.empty() &&
                           m_scene.flats.empty(),
                       !interaction.hasGesture() && !overlay.find<PenMarks>()};
    scene.view = interaction.view();
    scene.view.hasGround = scene.view.hasGround && !m_areStepsBelow;
    scene.unit = settings().unit();
    // What the hand has is all that is looked at then.
    const bool isBusy = interaction.isHandBusy();
    // Nothing stays behind where the model was: it goes until the model is back.
    scene.timesMoved = m_steps ? 0.0 : m_strained.timesMoved();
    const bool isMoved = scene.timesMoved > 0.0;
    if (!isBusy && !isMoved) {
        scene.problemMarks = interaction.marks();
        scene.marks = placeMarks(scene.problemMarks, interaction.camera(), scene.viewport,
                                 scene.view, interaction.covered());
    }
    scene.litMark = litMark(m_bench);
    m_offer = {};
    scene.offer = &m_offer;
    scene.isOfferLit = m_isOnOffer;
    if (!isBusy && !m_steps && !isMoved) {
        scene.ghosts = m_bench.ghosts();
        scene.areGhostsOld = m_bench.tried() != nullptr;
        scene.problems = m_bench.problemLook();
    }
    scene.steps = m_steps ? &m_steps->marks : nullptr;
    if (scene.view.clip) // of the handle's place; every vertex is looked at for it
        scene.bounds = m_bench.session().committed().bounds();
    scene.hoveredName = nameUnderCursor(m_bench);
    if (!isMoved)
        scene.selected = selectedSigns(m_bench);
    if (const auto *points = scene.selected.find<sign::Points>())
        scene.edited = editedSection(model, points->section);
    if (const Operation *operation = model.document.find(interaction.selectedOperation()))
        scene.operation = operationKind(operation->kind);
    if (!m_steps && !isMoved) {
        scene.dimensions = dimensionSigns(model, over.dimension);
        for (const Sign &sign : loadSigns(model, scene.view, over.load, interaction.selectedLoad()))
            scene.dimensions.add(sign);
        for (const Sign &sign : m_bench.tracedSigns())
            scene.dimensions.add(sign);
        // The tool's own are what hangs there already.
        if (isBusy)
            dropWordsOfOthers(scene.dimensions,
                              dynamic_cast<const LoadTool *>(interaction.tool()) != nullptr);
    }
    scene.covered = m_covered;
    if (!m_steps) {
        scene.stress = m_strained.stress();
        scene.bearing = m_strained.bearing();
    }
    if (m_busyTurn.isActive())
        scene.busy = m_busyTurns;
    QPainter painter(&m_marks);
    painter.setFont(font());
    paintOverlay(painter, scene, theme().viewStyle(), locale());
    if (!m_showsFocus)
        return;
    const QRectF inside = QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0);
    painter.setBrush(Qt::NoBrush);
    for (const QPen &pen : {QPen(theme().panel, 4.0), QPen(theme().accent, 2.0)}) {
        painter.setPen(pen);
        painter.drawRect(inside);
    }
}

bool Viewport::isOnOffer(const QPointF &place) const
{
    const Interaction &interaction = m_bench.interaction();
    return !interaction.hasGesture() && interaction.hasOffer() && m_offer.contains(place);
}

/// The cursor and the words say that they can be clicked.
void Viewport::setOnOffer(bool isOn)
{
    if (std::exchange(m_isOnOffer, isOn) == isOn)
        return;
    refresh();
    update();
}

} // namespace fff::ui
