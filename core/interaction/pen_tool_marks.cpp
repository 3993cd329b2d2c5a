// What the pen shows and says of itself.
#include "core/interaction/contour_words.h"
#include "core/interaction/cue.h"
#include "core/interaction/draw_tool.h"
#include "core/interaction/pen_tool.h"
#include "core/interaction/pen_words.h"
#include "core/interaction/stroke_words.h"

namespace fff {

void PenTool::mark(GestureContext &context, bool hasCursor)
{
    faceFirstCanvas(context);
    Signs &signs = context.overlay.held;
    m_over.reset();
    if (m_slit) {
        if (m_press && m_press->isDrag)
            m_slit->show(context, signs);
        if (m_slit->state() == SlitTurn::State::Turn)
            signs.add(
                cueAt(hints::kTurningNow, m_event.position, context.camera, context.viewport));
        return;
    }
    if (!m_canvas) {
        if (context.hovered.section >= 0 && context.hovered.slitStart)
            m_over = context.model.section(static_cast<std::size_t>(context.hovered.section))->name;
        return;
    }
    if (hasCursor && !m_press && !(m_hoverCamera == context.camera))
        hover(context); // the view moved under it
    const Canvas &canvas = *m_canvas;
    const ContourTarget &target = canvas.choice.target;
    if (target.parent) {
        const double length = (target.parent->slitTo - target.parent->slitFrom).norm();
        const int index = context.model.indexOf(target.parent->section);
        signs.add(sign::Slit{target.canvas.origin, target.canvas.toWorld({length, 0.0}), true,
                             index >= 0
                                 ? context.model.section(static_cast<std::size_t>(index))->name
                                 : std::string()});
    }
    if (canvas.targets.meetsGround() && !canvas.isFirst)
        signs.add(sign::Ground{canvas.targets.grid().toWorld({0.0, *canvas.targets.ground()}),
                               canvas.targets.grid().x});
    if (canvas.choice.distance && m_path.isEmpty())
        signs.add(planeMark(target.canvas, context));
    canvas.guides.show(nullptr, false, signs);
    signs.add(sign::Rulers{canvas.targets.grid()});
    PenMarks &marks = signs.put(PenMarks());
    marks.purpose = target.purpose;
    marks.canvas = target.canvas;
    marks.points = m_path.points();
    marks.hasArea = isClosable();
    if (m_drawn && *m_drawn && (*m_drawn)->isCutAtGround)
        marks.cut = m_closed.contour;
    const bool isPressed = m_press && !m_press->isOver;
    const Place &place = isPressed ? m_press->place : m_place;
    if ((hasCursor || isPressed) && place.kind != Place::Kind::Free) {
        marks.litPoint = static_cast<int>(place.index);
        if (place.kind == Place::Kind::Handle)
            marks.litEnd = place.end;
        marks.isClosing = isClosing();
    }
    const bool isMoving = isPressed && m_press->isDrag && place.kind == Place::Kind::Point;
    if (m_typed)
        marks.snap = Snap{Snap::Kind::None, *m_typed, {}, false};
    else if (m_snap && (isMoving || (hasCursor && !isPressed)))
        marks.snap = m_snap;
    if (!marks.snap)
        return;
    if (!isMoving)
        marks.next = marks.snap->point;
    marks.place = canvas.targets.toGrid(marks.snap->point);
    marks.grid = canvas.targets.grid();
    if (marks.snap->kind != Snap::Kind::None)
        marks.gridStep = gridStep(scaleAt(marks.snap->point, context));
    const std::optional<Vec2> before =
        isMoving ? pointBefore(place.index) : pointBefore(std::nullopt);
    if (before)
        marks.way = *marks.place - canvas.targets.toGrid(*before);
}

bool PenTool::isClosing() const
{
    const bool isPressed = m_press && !m_press->isOver;
    const Place &place = isPressed ? m_press->place : m_place;
    return place.kind == Place::Kind::Point && place.index == 0 && isClosable() &&
           !(isPressed && m_press->isDrag);
}

Hint PenTool::hint() const
{
    if (m_slit)
        return m_slit->isTurned() ? Hint(hints::kTurning)
                                  : Hint(hints::kLeaveSection, {Named{m_slit->sectionName()}});
    if (!m_canvas)
        return m_over ? Hint(hints::kPenOnSection, {Named{*m_over}})
                      : Hint(hints::kPenWithoutCanvas);
    if (m_typed)
        return hints::kPenNumbers;
    if (m_canvas->isOnEdge)
        return hints::kCanvasOnEdge;
    const bool isPressed = m_press && !m_press->isOver;
    const Place &place = isPressed ? m_press->place : m_place;
    if (isPressed && (place.kind == Place::Kind::Free || place.kind == Place::Kind::Handle))
        return hints::kPenBending;
    if (isClosing())
        return hints::kPenClosing;
    if (place.kind == Place::Kind::Point)
        return hints::kPenOnPoint;
    if (place.kind == Place::Kind::Handle)
        return hints::kPenOnHandle;
    if (m_path.isEmpty())
        return hints::kPenFirstPoint;
    if (m_drawn && !*m_drawn)
        return m_drawn->error();
    if (m_closed.wasCrossing)
        return hints::kPenCrosses;
    return m_snap && m_snap->kind != Snap::Kind::None ? hints::kPenSnapped : hints::kPenPoint;
}

Cursor PenTool::cursor() const
{
    if (m_slit)
        return m_slit->state() == SlitTurn::State::Slit ? Cursor::PencilWithSlit
                                                        : Cursor::PencilWithClock;
    if (!m_canvas)
        return m_over ? Cursor::PencilWithSlit : Cursor::Arrow;
    if (m_canvas->isOnEdge)
        return Cursor::Arrow;
    if (isClosing())
        return Cursor::PenCloses;
    const bool isPressed = m_press && !m_press->isOver;
    const Place &place = isPressed ? m_press->place : m_place;
    return place.kind == Place::Kind::Free || (isPressed && !m_press->isDrag) ? Cursor::Pen
                                                                              : Cursor::MoveCross;
}

} // namespace fff
