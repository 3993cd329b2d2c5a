// By how much curves turn where one goes on in the next: radians, 0 where it is smooth.
#pragma once

#include "core/geometry/contour.h"
#include "core/geometry/fit.h"

#include <cmath>
#include <vector>

namespace fff::test {

inline double turnBetween(const CubicBezier &a, const CubicBezier &b)
{
    const Vec2 in = endDirection(a), out = startDirection(b);
    return std::abs(std::atan2(cross(in, out), in.dot(out)));
}

/// At each point of a closed contour, in order.
inline std::vector<double> turnsOf(const Contour &contour)
{
    const int count = contour.segmentCount();
    std::vector<double> turns;
    for (int i = 0; i < count; ++i)
        turns.push_back(turnBetween(contour.segment((i + count - 1) % count), contour.segment(i)));
    return turns;
}

} // namespace fff::test
