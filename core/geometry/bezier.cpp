#include "core/geometry/bezier.h"

#include <algorithm>
#include <cmath>

namespace fff {

CubicBezier CubicBezier::line(const Vec2 &from, const Vec2 &to)
{
    return {from, from + (to - from) / 3.0, to - (to - from) / 3.0, to};
}

Vec2 CubicBezier::at(double t) const
{
    // At its ends a piece meets its neighbours to the last bit.
    if (t == 0.0)
        return p0;
    if (t == 1.0)
        return p3;
    const double s = 1.0 - t;
    return s * s * s * p0 + 3.0 * s * s * t * p1 + 3.0 * s * t * t * p2 + t * t * t * p3;
}

Vec2 CubicBezier::derivative(double t) const
{
    const double s = 1.0 - t;
    return 3.0 * (s * s * (p1 - p0) + 2.0 * s * t * (p2 - p1) + t * t * (p3 - p2));
}

Vec2 CubicBezier::secondDerivative(double t) const
{
    return 6.0 * ((1.0 - t) * (p2 - 2.0 * p1 + p0) + t * (p3 - 2.0 * p2 + p1));
}

CubicBezier CubicBezier::piece(double t0, double t1) const
{
    if (t0 > t1)
        return piece(t1, t0).reversed();
    // The control points of a piece are the blossom (polar form) at (t0,t0,t0), (t0,t0,t1), ...
    const auto blossom = [this](double a, double b, double c) -> Vec2 {
        const Vec2 q0 = p0 + a * (p1 - p0), q1 = p1 + a * (p2 - p1), q2 = p2 + a * (p3 - p2);
        const Vec2 r0 = q0 + b * (q1 - q0), r1 = q1 + b * (q2 - q1);
        return r0 + c * (r1 - r0);
    };
    CubicBezier result{at(t0), blossom(t0, t0, t1), blossom(t0, t1, t1), at(t1)};
    if (t0 == 0.0 && t1 == 1.0)
        return *this;
    return result;
}

bool CubicBezier::isStraight(double tolerance) const
{
    // By squares: most segments are told without a root.
    const Vec2 chord = p3 - p0;
    const double squared = chord.squaredNorm(), least = tolerance * tolerance;
    if (squared <= least)
        return (p1 - p0).squaredNorm() <= least && (p2 - p0).squaredNorm() <= least;
    const auto isNear = [&](const Vec2 &p) {
        const double along = chord.dot(p - p0), across = cross(chord, p - p0);
        if (across * across > least * squared)
            return false;
        if (along >= 0.0 && along <= squared)
            return true;
        const double slack = tolerance * std::sqrt(squared);
        return along >= -slack && along <= squared + slack;
    };
    return isNear(p1) && isNear(p2);
}

int CubicBezier::chordCount(double tolerance) const
{
    const double bend =
        std::sqrt(std::max((p2 - 2.0 * p1 + p0).squaredNorm(), (p3 - 2.0 * p2 + p1).squaredNorm()));
    // |B''| <= 6 bend, a chord over a step h is off by at most h² |B''| / 8.
    const double steps =
        std::min(std::sqrt(0.75 * bend / tolerance), static_cast<double>(kMaxChords));
    const int whole = static_cast<int>(steps);
    return std::max(whole < steps ? whole + 1 : whole, 1);
}

} // namespace fff
