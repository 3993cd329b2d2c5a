#include "core/interaction/clip_gesture.h"

#include <algorithm>

namespace fff {

namespace {

/// Sine of the angle between normal and line of sight below which the normal is too short on the
/// screen to drag along: the plane is pulled up and down instead.
constexpr double kShortNormal = 0.3;

} // namespace

Vec3 clipHandle(const ClipPlane &plane, const Box3 &bounds)
{
    if (bounds.isEmpty())
        return plane.point;
    const Vec3 middle = bounds.center();
    return middle - plane.height(middle) * plane.normal;
}

ClipGesture::ClipGesture(const PointerEvent &press, const GestureContext &context)
    : m_press(press.position), m_before(*context.view.clip)
{
    const Box3 bounds = context.model.bounds();
    const Vec3 handle = clipHandle(m_before, bounds);
    const Camera &camera = context.camera;
    const double scale = camera.scaleAt(handle, context.viewport);
    const Vec3 eye = camera.towardsEye(handle, context.viewport);
    if (eye.cross(m_before.normal).norm() > kShortNormal)
        m_perMillimetre =
            Vec2(camera.right().dot(m_before.normal), -camera.up().dot(m_before.normal)) / scale;
    else // down the screen is towards oneself
        m_perMillimetre = Vec2(0.0, eye.dot(m_before.normal) > 0.0 ? 1.0 : -1.0) / scale;

    m_least = m_most = 0.0;
    for (int corner = 0; corner < 8 && !bounds.isEmpty(); ++corner) {
        const Vec3 p(corner & 1 ? bounds.min.x() : bounds.max.x(),
                     corner & 2 ? bounds.min.y() : bounds.max.y(),
                     corner & 4 ? bounds.min.z() : bounds.max.z());
        m_least = std::min(m_least, m_before.height(p));
        m_most = std::max(m_most, m_before.height(p));
    }
}

GestureReply ClipGesture::handle(const PointerEvent &event, GestureContext &context)
{
    const double way =
        (event.position - m_press).dot(m_perMillimetre) / m_perMillimetre.squaredNorm();
    ClipPlane plane = m_before;
    plane.point += std::clamp(way, m_least, m_most) * plane.normal;
    context.view.clip = plane;
    context.hovered.isCutHandle = true;
    GestureReply reply;
    if (event.type == PointerEvent::Type::Release)
        reply.state = GestureReply::State::Over;
    return reply;
}

GestureReply ClipGesture::cancel(GestureContext &context)
{
    context.view.clip = m_before;
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    return reply;
}

} // namespace fff
