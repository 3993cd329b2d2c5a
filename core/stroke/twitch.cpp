#include "core/stroke/twitch.h"

#include "core/geometry/polygon.h"

#include <cmath>

namespace fff {

namespace {

/// Of a loop, in its extents: the gap at most, the way at least; and the area, in their square.
constexpr double kWidestGap = 0.5, kShortestWay = 2.0, kLeastArea = 0.2;

} // namespace

bool isTwitch(const std::vector<Vec2> &samples)
{
    const Box2 box = bounds(samples);
    if (box.isEmpty())
        return true;
    const double extent = box.size().maxCoeff();
    if (!(extent > 0.0) || extent >= kTwitch)
        return extent < kTwitch;
    double way = 0.0;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i)
        way += (samples[i + 1] - samples[i]).norm();
    return (samples.back() - samples.front()).norm() > kWidestGap * extent ||
           way < kShortestWay * extent ||
           std::abs(signedArea(samples)) < kLeastArea * extent * extent;
}

} // namespace fff
