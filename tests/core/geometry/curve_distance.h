// How far a point is from curves, for tests: slow and sure.
#pragma once

#include "core/geometry/contour.h"

#include <algorithm>
#include <cmath>

namespace fff::test {

/// Nearest by sampling, then by thirds beside the best sample. In plain numbers, since unoptimised
/// builds run it some million times.
inline double distanceTo(const Vec2 &point, const CubicBezier &curve)
{
    constexpr int kSamples = 32;
    constexpr int kThirds = 70;
    const double x0 = curve.p0.x() - point.x(), y0 = curve.p0.y() - point.y();
    const double x1 = curve.p1.x() - point.x(), y1 = curve.p1.y() - point.y();
    const double x2 = curve.p2.x() - point.x(), y2 = curve.p2.y() - point.y();
    const double x3 = curve.p3.x() - point.x(), y3 = curve.p3.y() - point.y();
    const auto off = [&](double t) {
        const double s = 1.0 - t;
        const double a = s * s * s, b = 3.0 * s * s * t, c = 3.0 * s * t * t, d = t * t * t;
        return std::hypot(a * x0 + b * x1 + c * x2 + d * x3, a * y0 + b * y1 + c * y2 + d * y3);
    };
    int best = 0;
    double nearest = off(0.0);
    for (int i = 1; i <= kSamples; ++i) {
        const double distance = off(static_cast<double>(i) / kSamples);
        if (distance < nearest) {
            nearest = distance;
            best = i;
        }
    }
    double low = std::max(0.0, (best - 1.0) / kSamples);
    double high = std::min(1.0, (best + 1.0) / kSamples);
    for (int i = 0; i < kThirds; ++i) {
        const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
        if (off(a) < off(b))
            high = b;
        else
            low = a;
    }
    return std::min(nearest, off(0.5 * (low + high)));
}

inline double distanceTo(const Vec2 &point, const Contour &contour)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < contour.segmentCount(); ++i) {
        const CubicBezier curve = contour.segment(i);
        Box2 box;
        for (const Vec2 &p : {curve.p0, curve.p1, curve.p2, curve.p3})
            box.extend(p);
        const Vec2 beside = (point - box.center()).cwiseAbs() - 0.5 * box.size();
        if (beside.maxCoeff() < nearest)
            nearest = std::min(nearest, distanceTo(point, curve));
    }
    return nearest;
}

inline double distanceTo(const Vec2 &point, const Polygon &polygon)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const Vec2 edge = polygon[i] - polygon[j];
        const double share =
            std::clamp(edge.dot(point - polygon[j]) / edge.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (polygon[j] + share * edge - point).norm());
    }
    return nearest;
}

inline double perimeter(const Polygon &polygon)
{
    double sum = 0.0;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++)
        sum += (polygon[i] - polygon[j]).norm();
    return sum;
}

} // namespace fff::test
