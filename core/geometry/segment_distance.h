// How far a point is from a straight segment.
#pragma once

#include "core/geometry/vector.h"

#include <algorithm>

namespace fff {

/// The point from a to b that is nearest; they may be one.
inline Vec2 nearestOfSegment(const Vec2 &p, const Vec2 &a, const Vec2 &b)
{
    const Vec2 way = b - a;
    const double squared = way.squaredNorm();
    const double share = squared > 0.0 ? std::clamp(way.dot(p - a) / squared, 0.0, 1.0) : 0.0;
    return a + share * way;
}

inline double distanceToSegment(const Vec2 &p, const Vec2 &a, const Vec2 &b)
{
    return (nearestOfSegment(p, a, b) - p).norm();
}

/// distanceToSegment() <= reach; of what is beside the segment most is told without a root.
inline bool isNearSegment(const Vec2 &p, const Vec2 &a, const Vec2 &b, double reach)
{
    const double away = cross(b - a, p - a);
    return !(away * away > reach * reach * (b - a).squaredNorm()) &&
           distanceToSegment(p, a, b) <= reach;
}

} // namespace fff
