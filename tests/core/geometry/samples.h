// What a hand leaves behind: points along a way, close together. For tests of fits and strokes.
#pragma once

#include "core/geometry/vector.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace fff::test {

using Samples = std::vector<Vec2>;

/// Of a way that `at` runs along from 0 to 1, both ends among them: `count` + 1.
inline Samples curve(const std::function<Vec2(double)> &at, int count = 200)
{
    Samples samples;
    for (int i = 0; i <= count; ++i)
        samples.push_back(at(double(i) / count));
    return samples;
}

/// From corner to corner, evenly about `step` apart, all corners among them.
inline Samples lines(const Samples &corners, double step)
{
    Samples samples;
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        const Vec2 way = corners[i + 1] - corners[i];
        const int pieces = std::max(1, static_cast<int>(std::lround(way.norm() / step)));
        for (int k = 0; k < pieces; ++k)
            samples.push_back(corners[i] + way * (double(k) / pieces));
    }
    samples.push_back(corners.back());
    return samples;
}

} // namespace fff::test
