// On which side of a line a point lies, exactly: for answers that steer topology.
#pragma once

#include "core/geometry/vector.h"

#include <algorithm>
#include <cmath>

namespace fff {

/// The same, always worked out exactly; slower.
double exactSideOfLine(const Vec2 &a, const Vec2 &b, const Vec2 &c);

/// Positive when c lies to the left of the way from a to b, negative to the right, 0 on the line.
/// Only the sign is exact.
/// Source  J. R. Shewchuk 1997, Adaptive precision floating-point arithmetic: the first filter.
inline double sideOfLine(const Vec2 &a, const Vec2 &b, const Vec2 &c)
{
    constexpr double kError = 3.4e-16;
    const double left = (b.x() - a.x()) * (c.y() - a.y());
    const double right = (b.y() - a.y()) * (c.x() - a.x());
    const double difference = left - right;
    if (std::abs(difference) > kError * (std::abs(left) + std::abs(right)))
        return difference;
    return exactSideOfLine(a, b, c);
}

/// What a ray from a point along +x and an edge have in common. Crossings are counted so that a ray
/// through a corner crosses one of two edges that go on upwards or downwards there, none or both of
/// two that turn back.
enum class RayMeeting { None, Crosses, Begins };

/// Begins: the point is on the edge from a to b. Exact.
inline RayMeeting rayMeeting(const Vec2 &point, const Vec2 &a, const Vec2 &b)
{
    if (point == a)
        return RayMeeting::Begins;
    if ((a.y() <= point.y()) == (b.y() <= point.y())) {
        // Only an edge at the very height of the point can still contain it.
        const bool isOn = a.y() == point.y() && b.y() == point.y() &&
                          std::min(a.x(), b.x()) <= point.x() &&
                          point.x() <= std::max(a.x(), b.x());
        return isOn ? RayMeeting::Begins : RayMeeting::None;
    }
    const double side = sideOfLine(a, b, point);
    if (side == 0)
        return RayMeeting::Begins;
    return (b.y() > a.y()) == (side > 0) ? RayMeeting::Crosses : RayMeeting::None;
}

} // namespace fff
