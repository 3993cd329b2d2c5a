// How what a hand made is off what was meant, measured on chords alone: nothing of it is known to
// who fits strokes.
#pragma once

#include "core/geometry/vector.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace fff::test {

/// Closed, first point not repeated, mm.
using Ring = std::vector<Vec2>;

/// With a place every `step` mm at least.
inline Ring densely(const Ring &ring, double step)
{
    Ring result;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 from = ring[i], way = ring[(i + 1) % ring.size()] - from;
        const int count = std::max(1, static_cast<int>(std::ceil(way.norm() / step)));
        for (int k = 0; k < count; ++k)
            result.push_back(from + way * (double(k) / count));
    }
    return result;
}

inline double distanceTo(const Ring &ring, const Vec2 &p)
{
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 from = ring[i], way = ring[(i + 1) % ring.size()] - from;
        const double square = way.squaredNorm();
        const double u = square > 0.0 ? std::clamp(way.dot(p - from) / square, 0.0, 1.0) : 0.0;
        best = std::min(best, (p - from - u * way).norm());
    }
    return best;
}

struct Deviation
{
    double most = 0.0, mean = 0.0; // mm; either way
};

inline Deviation deviation(const Ring &made, const Ring &meant)
{
    Deviation result;
    double sum = 0.0, count = 0.0;
    const auto compare = [&](const Ring &from, const Ring &to) {
        for (const Vec2 &p : densely(from, 0.5)) {
            const double off = distanceTo(to, p);
            result.most = std::max(result.most, off);
            sum += off;
            count += 1.0;
        }
    };
    compare(made, meant);
    compare(meant, made);
    result.mean = sum / count;
    return result;
}

/// Places where it turns by more than `angle` (radians) within `reach` mm of way, all one way.
inline int sharpCorners(const Ring &ring, double angle, double reach)
{
    const std::size_t n = ring.size();
    std::vector<double> turns(n);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 in = ring[i] - ring[(i + n - 1) % n], out = ring[(i + 1) % n] - ring[i];
        turns[i] = std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
    }
    // From the longest edge on, so that no corner lies across the ring's beginning.
    std::size_t first = 0;
    double longest = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        const double length = (ring[i] - ring[(i + n - 1) % n]).norm();
        if (length > longest) {
            longest = length;
            first = i;
        }
    }
    int count = 0;
    for (std::size_t k = 0; k < n;) {
        double turn = 0.0, way = 0.0;
        bool isCorner = false;
        std::size_t next = k;
        while (next < n && way <= reach) {
            const std::size_t i = (first + next) % n;
            if (turn * turns[i] < 0.0)
                break;
            turn += turns[i];
            // What follows so near is the same corner.
            if (!isCorner && std::abs(turn) > angle) {
                isCorner = true;
                way = 0.0;
            }
            way += (ring[(i + 1) % n] - ring[i]).norm();
            ++next;
        }
        count += isCorner ? 1 : 0;
        k = isCorner ? next : k + 1;
    }
    return count;
}

} // namespace fff::test
