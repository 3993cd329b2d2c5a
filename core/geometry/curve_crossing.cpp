#include "core/geometry/curve_crossing.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fff {

namespace {

// More than bisection needs to use up a double.
constexpr int kMaxSteps = 80;

Vec2 chordDirection(const CurveRange &range)
{
    return (range.curve.p3 - range.curve.p0).normalized();
}

/// Parameter of the point's foot on the chord between the range's ends.
double alongChord(const CurveRange &range, const Vec2 &point)
{
    const Vec2 from = range.curve.at(range.from);
    const Vec2 chord = range.curve.at(range.to) - from;
    const double lengthSquared = chord.squaredNorm();
    const double share = lengthSquared > 0.0 ? chord.dot(point - from) / lengthSquared : 0.5;
    return range.from + std::clamp(share, 0.0, 1.0) * (range.to - range.from);
}

/// a is any curve, b a straight one.
std::optional<CurveCrossing> crossStraight(const CurveRange &a, const CurveRange &b)
{
    const Vec2 direction = chordDirection(b);
    if (direction.isZero())
        return std::nullopt;
    const auto onA = crossLine(a, b.curve.p0, perpendicular(direction), kClipSlack);
    if (!onA)
        return std::nullopt;
    const Vec2 point = a.curve.at(*onA);
    const auto onB = crossLine(b, point, direction, kClipSlack);
    // A straight piece may be left beyond its end: the curve bulges over the corner of a cut. The
    // line is what counts, the caller sees to the order along it.
    return CurveCrossing{*onA, onB ? *onB : alongChord(b, point), point};
}

std::optional<CurveCrossing> crossCurves(const CurveRange &a, const CurveRange &b, const Vec2 &near)
{
    double s = alongChord(a, near), t = alongChord(b, near);
    for (int i = 0; i < kMaxSteps; ++i) {
        const Vec2 gap = b.curve.at(t) - a.curve.at(s);
        if (gap.norm() <= kCrossingError)
            return CurveCrossing{s, t, a.curve.at(s)};
        const Vec2 da = a.curve.derivative(s), db = b.curve.derivative(t);
        const double sine = cross(da, db);
        if (std::abs(sine) <= kParallelSine * da.norm() * db.norm())
            return std::nullopt;
        s = std::clamp(s + cross(gap, db) / sine, a.from, a.to);
        t = std::clamp(t + cross(gap, da) / sine, b.from, b.to);
    }
    return std::nullopt;
}

} // namespace

std::vector<double> levelParameters(const CubicBezier &curve, const Vec2 &normal)
{
    // h' / 3 = a (1 − t)² + 2 b t (1 − t) + c t²
    const double a = normal.dot(curve.p1 - curve.p0), b = normal.dot(curve.p2 - curve.p1),
                 c = normal.dot(curve.p3 - curve.p2);
    const double square = a - 2.0 * b + c, linear = 2.0 * (b - a);
    std::vector<double> result;
    const auto add = [&](double t) {
        if (t > 0.0 && t < 1.0)
            result.push_back(t);
    };
    const double discriminant = linear * linear - 4.0 * square * a;
    if (discriminant < 0.0)
        return result;
    // The form that loses no digits; divisions by zero give what add() leaves out.
    const double q = -0.5 * (linear + std::copysign(std::sqrt(discriminant), linear));
    add(q / square);
    add(a / q);
    std::sort(result.begin(), result.end());
    return result;
}

std::optional<double> crossLine(const CurveRange &range, const Vec2 &point, const Vec2 &normal,
                                double slack)
{
    const auto height = [&](double t) { return normal.dot(range.curve.at(t) - point); };
    double low = range.from, high = range.to;
    const double lowHeight = height(low), highHeight = height(high);
    if (lowHeight == 0.0)
        return low;
    if (highHeight == 0.0)
        return high;
    if ((lowHeight > 0.0) == (highHeight > 0.0)) {
        const bool lowIsNearer = std::abs(lowHeight) <= std::abs(highHeight);
        if (std::min(std::abs(lowHeight), std::abs(highHeight)) > slack * normal.norm())
            return std::nullopt;
        return lowIsNearer ? low : high;
    }
    // What a height is rounded by: nearer than that no parameter is better than another. Most lines
    // cross most lines, and there the first guess is as near.
    const double rounding = std::numeric_limits<double>::epsilon() *
                            std::max(std::abs(lowHeight), std::abs(highHeight));
    double t = low + (high - low) * lowHeight / (lowHeight - highHeight);
    for (int i = 0; i < kMaxSteps; ++i) {
        const double h = height(t);
        if (std::abs(h) <= rounding)
            return t;
        if ((h > 0.0) == (lowHeight > 0.0))
            low = t;
        else
            high = t;
        double next = t - h / normal.dot(range.curve.derivative(t));
        if (!(next > low && next < high))
            next = 0.5 * (low + high);
        if (next == t || next == low || next == high)
            return next;
        t = next;
    }
    return t;
}

std::optional<CurveCrossing> crossNear(const CurveRange &a, const CurveRange &b, const Vec2 &near)
{
    const bool aIsStraight = a.curve.isStraight(kClipGrid);
    const bool bIsStraight = b.curve.isStraight(kClipGrid);
    if (aIsStraight && bIsStraight &&
        std::abs(cross(chordDirection(a), chordDirection(b))) <= kParallelSine)
        return std::nullopt;
    if (bIsStraight)
        return crossStraight(a, b);
    if (!aIsStraight)
        return crossCurves(a, b, near);
    auto swapped = crossStraight(b, a);
    if (swapped)
        std::swap(swapped->a, swapped->b);
    return swapped;
}

} // namespace fff
