#include "core/interaction/gizmo_drag.h"

#include "core/base/units.h"
#include "core/interaction/pick.h"
#include "core/interaction/snapping.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fff {

namespace {

/// |cosine| between a plane's normal and the line of sight below which points on it run away.
constexpr double kSteepPlane = 0.2;
/// Angles are drawn to multiples of the first when they are this near, and to places where an axis
/// of what is turned lies along one of the world's; else they are whole degrees.
const double kAngleStep = radians(15.0), kAngleReach = radians(2.5), kLeastAngle = radians(1.0);
/// Factors are rounded to this.
constexpr double kFactorStep = 0.05;
constexpr double kLeastFactor = 0.01, kMostFactor = 100.0;
/// px from the gizmo's middle within which no direction can be told.
constexpr double kNoDirection = 4.0;
/// The least squared sine between an axis and a line of sight that is worked with.
constexpr double kLeastSine2 = 1e-4;
/// Shorter than this an arm of the gizmo scales nothing, mm.
constexpr double kNoArm = 1e-9;

double rounded(double value, double step)
{
    return std::round(value / step) * step;
}

/// Into −π … π.
double wrapped(double angle)
{
    return std::remainder(angle, 2.0 * std::numbers::pi);
}

} // namespace

Similarity Transform::times(int count) const
{
    const double n = count;
    return Similarity::moved(n * way) *
           Similarity::turned(Eigen::AngleAxisd(n * angle, axis).toRotationMatrix(), pivot) *
           Similarity::scaled(std::pow(factor, n), pivot);
}

bool Transform::isNothing() const
{
    return way.isZero(0.0) && angle == 0.0 && factor == 1.0 && stretch == Vec2::Ones();
}

GizmoDrag::GizmoDrag(Gizmo gizmo, GizmoPart part, const Vec2 &press, const GestureContext &context,
                     const std::optional<Alignment> &snaps)
    : m_gizmo(std::move(gizmo)), m_part(part), m_press(press), m_snaps(snaps.has_value()),
      m_plane(m_gizmo.frame)
{
    m_transform.pivot = m_gizmo.frame.origin;
    const Vec3 eye = context.camera.towardsEye(m_transform.pivot, context.viewport);
    if (m_gizmo.isInSpace || std::abs(eye.dot(m_plane.normal())) < kSteepPlane)
        m_plane = {m_plane.origin, context.camera.right(), context.camera.up()};
    if (snaps && part == GizmoPart::MoveFree)
        m_lines = {Alignment::Line(*snaps, m_plane.x), Alignment::Line(*snaps, m_plane.y)};
    else if (snaps && !isTurn(part) && !isScale(part))
        m_lines = {Alignment::Line(*snaps, m_gizmo.axis(axisOf(part)))};
    if (isTurn(part)) {
        m_transform.axis = m_gizmo.axis(axisOf(part));
        m_lastAngle = angleAt(press, context).value_or(0.0);
    }
}

/// Where on the axis through the pivot the place is, mm from it: the nearest to its line of sight.
double GizmoDrag::along(const Vec3 &axis, const Vec2 &position, const GestureContext &context) const
{
    const Ray ray = context.camera.rayThrough(position, context.viewport);
    const Vec3 way = ray.direction.normalized();
    const Vec3 from = ray.origin - m_transform.pivot;
    const double cosine = axis.dot(way);
    const double sine2 = std::max(1.0 - cosine * cosine, kLeastSine2);
    return (from.dot(axis) - cosine * from.dot(way)) / sine2;
}

/// Round the axis, from wherever; nothing too near to the pivot.
std::optional<double> GizmoDrag::angleAt(const Vec2 &position, const GestureContext &context) const
{
    const Camera &camera = context.camera;
    const Vec3 &pivot = m_transform.pivot;
    const Vec3 axis = m_transform.axis, eye = camera.towardsEye(pivot, context.viewport);
    if (std::abs(eye.dot(axis)) < kSteepPlane) {
        // Seen on its edge the ring is rolled by what its near side is dragged.
        const Vec3 tangent = axis.cross(eye).normalized();
        const Vec2 way(camera.right().dot(tangent), -camera.up().dot(tangent));
        return way.dot(position - m_press) / kGizmoRing;
    }
    const Vec2 centre = camera.toScreen(pivot, context.viewport);
    const Vec3 side = axis.unitOrthogonal();
    const auto local =
        pointOnPlane(camera, context.viewport, {pivot, side, axis.cross(side)}, position);
    if (!local || (position - centre).norm() < kNoDirection)
        return std::nullopt;
    return std::atan2(local->y(), local->x());
}

/// To a place where points are level, or by the grid's step.
double GizmoDrag::snappedAlong(std::size_t line, double way, const Vec3 &before, double scale)
{
    if (!m_snaps)
        return way;
    if (const auto caught = m_lines[line].nearest(way, kSnapReach * scale, before)) {
        m_guides.emplace_back(caught->own, caught->other);
        return caught->way;
    }
    return rounded(way, gridStep(scale));
}

Vec3 GizmoDrag::freeWay(const Vec2 &position, const GestureContext &context) const
{
    const auto to = pointOnPlane(context.camera, context.viewport, m_plane, position);
    const auto from = pointOnPlane(context.camera, context.viewport, m_plane, m_press);
    return to && from ? m_plane.directionToWorld(*to - *from) : Vec3(Vec3::Zero());
}

void GizmoDrag::move(const Vec2 &position, bool holds, const GestureContext &context)
{
    const double scale = context.camera.scaleAt(m_transform.pivot, context.viewport);
    if (m_part != GizmoPart::MoveFree) {
        const Vec3 axis = m_gizmo.axis(axisOf(m_part));
        const double way = along(axis, position, context) - along(axis, m_press, context);
        m_transform.way = snappedAlong(0, way, Vec3::Zero(), scale) * axis;
        return;
    }
    const Vec3 way = freeWay(position, context);
    double x = way.dot(m_plane.x), y = way.dot(m_plane.y);
    if (holds)
        (std::abs(x) < std::abs(y) ? x : y) = 0.0;
    const double asked = y;
    if (!holds || x != 0.0)
        x = snappedAlong(0, x, y * m_plane.y, scale);
    const std::size_t count = m_guides.size();
    if (!holds || y != 0.0)
        y = snappedAlong(1, y, x * m_plane.x, scale);
    for (std::size_t i = 0; i < count; ++i) // to where its point comes to lie in the end
        m_guides[i].first += (y - asked) * m_plane.y;
    m_transform.way = x * m_plane.x + y * m_plane.y;
}

void GizmoDrag::turn(const Vec2 &position, const GestureContext &context)
{
    const std::optional<double> angle = angleAt(position, context);
    if (!angle)
        return;
    m_turned += wrapped(*angle - m_lastAngle);
    m_lastAngle = *angle;
    double turned = m_turned;
    if (m_snaps) {
        turned = rounded(m_turned, kLeastAngle);
        double best = kAngleReach;
        const auto offer = [&](double place) {
            if (std::abs(place - m_turned) <= best) {
                best = std::abs(place - m_turned);
                turned = place;
            }
        };
        offer(rounded(m_turned, kAngleStep));
        // Its other axes along those of the world, as they lie in the plane of the turn.
        const Vec3 axis = m_transform.axis;
        for (int own : {0, 1, 2})
            for (int of : {0, 1, 2}) {
                const Vec3 from = m_gizmo.axis(own), to = Vec3::Unit(of);
                const Vec3 u = from - from.dot(axis) * axis, v = to - to.dot(axis) * axis;
                if (u.norm() < 0.5 || v.norm() < 0.5)
                    continue;
                const double between = std::atan2(axis.dot(u.cross(v)), u.dot(v));
                const double quarter = 0.5 * std::numbers::pi;
                offer(between + quarter * std::round((m_turned - between) / quarter));
            }
    }
    m_transform.angle = turned;
}

void GizmoDrag::scale(const Vec2 &position, const GestureContext &context)
{
    double factor = 1.0;
    if (m_part == GizmoPart::ScaleAll) {
        const Vec2 centre = context.camera.toScreen(m_transform.pivot, context.viewport);
        const Vec2 from = m_press - centre;
        if (from.norm() < kNoDirection)
            return;
        factor = (position - centre).dot(from) / from.squaredNorm();
    } else {
        const Vec3 axis = m_gizmo.axis(axisOf(m_part));
        const double from = along(axis, m_press, context);
        if (std::abs(from) < kNoArm)
            return;
        factor = along(axis, position, context) / from;
    }
    if (m_snaps)
        factor = std::max(rounded(factor, kFactorStep), kFactorStep);
    factor = std::clamp(factor, kLeastFactor, kMostFactor);
    m_transform.stretch = Vec2::Ones();
    if (m_part == GizmoPart::ScaleAll && m_gizmo.isInSpace)
        m_transform.factor = factor;
    else if (m_part == GizmoPart::ScaleAll)
        m_transform.stretch = Vec2::Constant(factor);
    else
        m_transform.stretch[axisOf(m_part)] = factor;
}

void GizmoDrag::moveTo(const Vec2 &position, bool holds, const GestureContext &context)
{
    m_guides.clear();
    if (isTurn(m_part))
        turn(position, context);
    else if (isScale(m_part))
        scale(position, context);
    else
        move(position, holds, context);
}

double GizmoDrag::value() const
{
    if (isTurn(m_part))
        return m_transform.angle;
    if (m_part == GizmoPart::ScaleY)
        return m_transform.stretch.y();
    if (isScale(m_part))
        return m_gizmo.isInSpace ? m_transform.factor : m_transform.stretch.x();
    if (m_part == GizmoPart::MoveFree)
        return m_transform.way.norm();
    return m_transform.way.dot(m_gizmo.axis(axisOf(m_part)));
}

} // namespace fff
