// How far a point is from a straight segment.
#pragma once

#include "core/geometry/vector.h"

#include <algorithm>

namespace fff {

/// To the nearest point from a to b; they may be one.
inline double distanceToSegment(const Vec2 &p, const Vec2 &a, const Vec2 &b)
{
    const Vec2 way = b - a;
    const double squared = way.squaredNorm();
    const double share = squared > 0.0 ? std::clamp(way.dot(p - a) / squared, 0.0, 1.0) : 0.0;
    return (a + share * way - p).norm();
}

} // namespace fff
