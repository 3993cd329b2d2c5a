#include "core/interaction/turning_drag.h"

namespace fff {

bool TurningDrag::handle(const PointerEvent &event, GestureContext &context, GestureReply &reply)
{
    if (event.isPress()) {
        m_press = event;
        return false;
    }
    if (event.type == PointerEvent::Type::Release) {
        const bool isClick = m_press && !m_orbit;
        m_press.reset();
        m_orbit.reset();
        return isClick;
    }
    if (event.type != PointerEvent::Type::Move)
        return false;
    if (m_press && (event.position - m_press->position).norm() > context.settings.dragThreshold) {
        const Box3 box = context.model.bounds();
        m_orbit.emplace(*m_press, box.isEmpty() ? context.camera.target : Vec3(box.center()));
        m_press.reset();
        reply.left = context.camera;
    }
    if (m_orbit)
        m_orbit->handle(event, context);
    return false;
}

GestureReply TurningDrag::interrupt(GestureContext &context)
{
    GestureReply reply;
    if (m_orbit)
        reply.returnTo = m_orbit->cancel(context).returnTo;
    m_press.reset();
    m_orbit.reset();
    return reply;
}

} // namespace fff
