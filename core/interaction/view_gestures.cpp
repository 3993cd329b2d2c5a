#include "core/interaction/view_gestures.h"

#include <cmath>

namespace fff {

namespace {

/// Nearer by this factor for each pixel of a zooming drag.
constexpr double kZoomPerPixel = 1.005;

GestureReply replyTo(const PointerEvent &event)
{
    GestureReply reply;
    if (event.type == PointerEvent::Type::Release)
        reply.state = GestureReply::State::Over;
    return reply;
}

GestureReply cancelled(const std::optional<Camera> &before)
{
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    reply.returnTo = before;
    return reply;
}

} // namespace

GestureReply OrbitGesture::handle(const PointerEvent &event, GestureContext &context)
{
    if (!m_before)
        m_before = context.camera;
    context.camera = orbited(context.camera, event.position - m_last, m_pivot, context.viewport);
    m_last = event.position;
    return replyTo(event);
}

GestureReply OrbitGesture::cancel(GestureContext &)
{
    return cancelled(m_before);
}

GestureReply PanGesture::handle(const PointerEvent &event, GestureContext &context)
{
    if (!m_before)
        m_before = context.camera;
    // Always from where it began: nothing adds up over a long drag.
    context.camera = panned(*m_before, m_press, event.position, context.viewport);
    return replyTo(event);
}

GestureReply PanGesture::cancel(GestureContext &)
{
    return cancelled(m_before);
}

GestureReply ZoomGesture::handle(const PointerEvent &event, GestureContext &context)
{
    if (!m_before)
        m_before = context.camera;
    const double factor = std::pow(kZoomPerPixel, m_press.y() - event.position.y());
    context.camera = zoomed(*m_before, factor, m_press, context.viewport);
    return replyTo(event);
}

GestureReply ZoomGesture::cancel(GestureContext &)
{
    return cancelled(m_before);
}

} // namespace fff
