#include "core/interaction/steps_tool.h"

namespace fff {

GestureReply StepsTool::handle(const PointerEvent &event, GestureContext &context)
{
    GestureReply reply;
    switch (event.type) {
    case PointerEvent::Type::Press:
    case PointerEvent::Type::DoubleClick:
        m_press = event;
        return reply;
    case PointerEvent::Type::Release:
        m_press.reset();
        m_orbit.reset();
        return reply;
    case PointerEvent::Type::Move:
        break;
    default:
        return reply;
    }
    if (m_press && (event.position - m_press->position).norm() > context.settings.dragThreshold) {
        const Box3 box = context.model.bounds();
        m_orbit.emplace(*m_press, box.isEmpty() ? context.camera.target : Vec3(box.center()));
        m_press.reset();
        reply.left = context.camera;
    }
    if (m_orbit)
        m_orbit->handle(event, context);
    return reply;
}

GestureReply StepsTool::cancel(GestureContext &context)
{
    if (m_orbit)
        return interrupt(context);
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    return reply;
}

/// The view goes back to where it was before the drag.
GestureReply StepsTool::interrupt(GestureContext &context)
{
    GestureReply reply;
    if (m_orbit)
        reply.returnTo = m_orbit->cancel(context).returnTo;
    m_press.reset();
    m_orbit.reset();
    return reply;
}

GestureReply StepsTool::modelChanged(GestureContext &context)
{
    interrupt(context);
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    reply.note = Hint{Hint::Kind::StepsClosed, {}, false};
    return reply;
}

Hint StepsTool::hint() const
{
    return {m_orbit ? Hint::Kind::Orbiting : Hint::Kind::ShowSteps, {}, false};
}

} // namespace fff
