// How far a point is from curves, for tests: slow and sure.
#pragma once

#include "core/geometry/contour.h"

#include <algorithm>

namespace fff::test {

/// Nearest by sampling, then by golden-section steps beside the best sample.
inline double distanceTo(const Vec2 &point, const CubicBezier &curve)
{
    constexpr int kSamples = 64;
    const auto off = [&](double t) { return (curve.at(t) - point).norm(); };
    int best = 0;
    for (int i = 1; i <= kSamples; ++i) {
        if (off(static_cast<double>(i) / kSamples) < off(static_cast<double>(best) / kSamples))
            best = i;
    }
    double low = std::max(0.0, (best - 1.0) / kSamples),
           high = std::min(1.0, (best + 1.0) / kSamples);
    for (int i = 0; i < 100; ++i) {
        const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
        (off(a) < off(b) ? high : low) = off(a) < off(b) ? b : a;
    }
    return std::min({off(0.0), off(1.0), off(0.5 * (low + high))});
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
