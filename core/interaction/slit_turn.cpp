#include "core/interaction/slit_turn.h"

#include <algorithm>
#include <limits>

namespace fff {

namespace {

/// Largest part of the viewport's width that the view moves in a turn's time to make room.
constexpr double kRoomPerTurn = 0.5;
/// px that count as no way left.
constexpr double kArrived = 1e-3;

Stroke::Options slitOptions(const GestureContext &context)
{
    Stroke::Options options;
    options.turnTime = context.settings.turnTime;
    return options;
}

} // namespace

SlitTurn::SlitTurn(const PointerEvent &press, const Hit &hit, const GestureContext &context)
    : m_ref(context.model.ref(static_cast<std::size_t>(hit.section))),
      m_section(context.model.section(static_cast<std::size_t>(hit.section))),
      m_stroke(slitOptions(context)),
      m_guides(context.model, m_section, hit.local, context.camera.orientation),
      m_before(context.camera), m_cursor(press.position), m_now(press.time)
{
    m_stroke.beginInSection(m_section->shape, {press.time, hit.local});
}

void SlitTurn::move(const PointerEvent &event, GestureContext &context)
{
    advance(event.time, context);
    m_cursor = event.position;
    if (m_state == State::Slit) {
        const std::optional<Vec2> point =
            pointOnPlane(context.camera, context.viewport, m_section->frame, event.position);
        if (point)
            m_stroke.move({event.time, *point});
        m_guide = m_guides.lead(m_stroke, context.settings.snaps && !event.modifiers.control);
        if (m_stroke.state() == Stroke::State::Turn)
            beginTurn(context);
        else if (isTooShort())
            m_state = State::Over;
    }
    advance(event.time, context);
}

void SlitTurn::beginTurn(GestureContext &context)
{
    const double turnTime = context.settings.turnTime;
    m_turn.emplace(context.camera, m_section->frame, m_stroke.slitFrom(), m_stroke.slitTo(),
                   context.settings.turnAngle, context.viewport);
    m_target = ContourTarget::newSection(m_turn->canvas(),
                                         Parent{m_ref, m_stroke.slitFrom(), m_stroke.slitTo()});
    m_target.right = m_turn->right();
    m_room.canvas = m_target.canvas;
    m_room.slitLength = m_stroke.slitLength();
    m_room.deadZone = std::numeric_limits<double>::infinity(); // clicks may be anywhere
    m_room.speed = turnTime > 0.0 ? kRoomPerTurn * context.viewport.x() / turnTime
                                  : std::numeric_limits<double>::infinity();
    m_state = State::Turn;
    if (m_turn->isTurning())
        return;
    context.camera = m_turn->view();
    m_stroke.endTurn();
    m_state = State::Room;
}

void SlitTurn::advance(double time, GestureContext &context)
{
    if (m_state == State::Turn) {
        const double end = m_stroke.turnEnd();
        m_stroke.advance(time);
        context.camera = m_turn->at(m_stroke.turnProgress(time), m_cursor, context.viewport);
        m_now = std::min(time, end);
        if (m_stroke.state() == Stroke::State::DeadZone)
            m_state = State::Room;
    }
    if (m_state == State::Room) {
        context.camera = m_room.after(time - m_now, context.camera, m_cursor, context.viewport);
        if (m_room.way(context.camera, context.viewport).isZero(kArrived))
            m_state = State::Over;
    }
    m_now = std::max(m_now, time);
}

void SlitTurn::finish(GestureContext &context)
{
    if (m_state == State::Turn)
        advance(m_stroke.turnEnd(), context);
    if (m_state == State::Room) {
        m_room.speed = std::numeric_limits<double>::infinity();
        context.camera = m_room.after(1.0, context.camera, m_cursor, context.viewport);
        m_state = State::Over;
    }
}

void SlitTurn::show(const GestureContext &context, Signs &signs) const
{
    signs.add(sign::Slit{m_section->frame.toWorld(m_stroke.slitFrom()),
                         m_section->frame.toWorld(m_stroke.slitTo()), isTurned(), m_section->name});
    if (m_guide && (m_state == State::Slit || m_state == State::Turn))
        m_guides.show(*m_guide, context.camera, context.viewport, signs);
}

} // namespace fff
