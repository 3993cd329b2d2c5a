#include "core/interaction/canvas_turn.h"

#include "core/base/easing.h"
#include "core/base/tolerances.h"
#include "core/interaction/facing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fff {

namespace {

/// The slit's middle shall be seen within this part of the viewport, in both directions.
constexpr double kRoomFrom = 0.3, kRoomTo = 0.7;
/// As far as this part of the dead zone's radius the view may move the slit away from the cursor,
/// so that a hand that trembles does not begin the contour.
constexpr double kCursorPart = 0.6;
/// Halvings that find how far the view can move: down to the last bit, so that frames add up.
constexpr int kBisections = 50;

double clampedShift(double position, double size)
{
    return std::clamp(position, kRoomFrom * size, kRoomTo * size) - position;
}

double distanceToSegment(const Vec2 &p, double length)
{
    return (p - Vec2(std::clamp(p.x(), 0.0, length), 0.0)).norm();
}

} // namespace

CanvasTurn::CanvasTurn(const Camera &now, const Frame &ground, const Vec2 &from, const Vec2 &to,
                       double angle, const Vec2 &viewport)
    : m_slitEnd(ground.toWorld(to))
{
    const Vec3 x = ground.directionToWorld((to - from).normalized()).normalized();
    const Vec3 y = ground.normal().normalized();
    const Vec3 eye = now.towardsEye(m_slitEnd, viewport);
    m_isTurning = !isFaced(x.cross(y), eye);
    Eigen::Quaterniond orientation =
        m_isTurning ? facingOrientation(now.orientation, x.cross(y)) : now.orientation;
    const Vec3 backward = m_isTurning ? orientation * Vec3::UnitZ() : eye;
    m_canvas = {ground.toWorld(from), x, x.cross(y).dot(backward) > 0.0 ? y : Vec3(-y)};
    m_from = m_to = retargeted(now, m_slitEnd, viewport);
    if (!m_isTurning)
        return;

    const double tilt = std::numbers::pi / 2.0 - angle;
    if (tilt > kSameDirection) {
        // About the slit, towards the side of the section that is looked at now.
        const auto tilted = [&](double by) { return Eigen::AngleAxisd(by, x) * orientation; };
        const Eigen::Quaterniond one(tilted(tilt)), other(tilted(-tilt));
        const bool isOneNearer =
            now.orientation.angularDistance(one) <= now.orientation.angularDistance(other);
        const Eigen::Quaterniond &nearer = isOneNearer ? one : other;
        const auto looksUp = [](const Eigen::Quaterniond &view) {
            return (view * Vec3::UnitZ()).y() < -kSameDirection;
        };
        const Eigen::Quaterniond &farther = isOneNearer ? other : one;
        // Not up from below, if it can be helped.
        orientation = looksUp(nearer) && !looksUp(farther) ? farther : nearer;
    }
    m_to = now;
    m_to.orientation = orientation;
    m_to.target = m_slitEnd;
}

Camera CanvasTurn::at(double progress, const Vec2 &cursor, const Vec2 &viewport) const
{
    return pinned(interpolated(m_from, m_to, progress), m_slitEnd, cursor, viewport);
}

Camera QuickTurn::at(double now, const Vec2 &viewport) const
{
    const double part = time > 0.0 ? easeInOutCubic((now - start) / time) : 1.0;
    return turn.at(progress + part * (1.0 - progress), from + part * (pin - from), viewport);
}

Vec2 RoomPan::way(const Camera &camera, const Vec2 &viewport) const
{
    const Vec2 middle = camera.toScreen(canvas.toWorld({0.5 * slitLength, 0.0}), viewport);
    return {clampedShift(middle.x(), viewport.x()), clampedShift(middle.y(), viewport.y())};
}

Camera RoomPan::after(double elapsed, Camera camera, const Vec2 &cursor, const Vec2 &viewport) const
{
    const Vec2 wanted = way(camera, viewport);
    const double length = wanted.norm();
    if (!(length > 0.0) || !(elapsed > 0.0))
        return camera;
    const double part = std::min(1.0, speed * elapsed / length);
    const auto moved = [&](double u) {
        return panned(camera, Vec2::Zero(), Vec2(u * wanted), viewport);
    };
    const auto keepsCursor = [&](double u) {
        const Camera there = moved(u);
        const Ray ray = there.rayThrough(cursor, viewport);
        const double distance = -canvas.height(ray.origin) / canvas.normal().dot(ray.direction);
        const Vec2 at = canvas.toLocal(ray.origin + distance * ray.direction);
        return distanceToSegment(at, slitLength) <= kCursorPart * deadZone;
    };
    if (keepsCursor(part))
        return moved(part);
    double inside = 0.0, outside = part;
    for (int i = 0; i < kBisections; ++i) {
        const double middle = 0.5 * (inside + outside);
        (keepsCursor(middle) ? inside : outside) = middle;
    }
    return moved(inside);
}

} // namespace fff
