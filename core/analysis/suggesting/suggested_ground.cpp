#include "core/analysis/suggesting/suggested_ground.h"

#include "core/assembly/intervals.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// mm: by so much a foot stays within the section at its top, so that no corner of it is on the
/// contour.
constexpr double kInset = 0.2;
/// mm: narrower ones carry nothing.
constexpr double kLeastFoot = 1.0;

} // namespace

LevelLine levelLine(const Frame &frame, double height)
{
    const Vec2 up = frame.directionToLocal(Vec3::UnitY());
    return {up / up.squaredNorm() * (height - frame.origin.y()), -perpendicular(up).normalized()};
}

std::vector<SuggestedFoot> feetOn(const SuggestedGround &ground, const Frame &frame,
                                  const Region &region)
{
    const Vec2 up = frame.directionToLocal(Vec3::UnitY());
    if (!(ground.filled > 0.0) || up.norm() < kUprightSine)
        return {};
    const LevelLine low = levelLine(frame, ground.level), high = levelLine(frame, ground.top());
    // Within the circle around the middle.
    const Vec3 start = frame.toWorld(low.point), way = frame.directionToWorld(low.direction);
    const Vec2 along = Vec2(way.x(), way.z()).normalized();
    const Vec2 there = ground.middle - Vec2(start.x(), start.z());
    const double nearest = along.dot(there), off = cross(along, there);
    const double room = ground.around * ground.around - off * off;
    if (!(room > 0.0))
        return {};
    const double reach = std::sqrt(room);
    std::vector<SuggestedFoot> feet;
    for (const Interval &interval : intervalsOn({high.point, high.direction}, region)) {
        const double from = std::max(interval.from.at + kInset, nearest - reach);
        const double to = std::min(interval.to.at - kInset, nearest + reach);
        if (to - from < kLeastFoot)
            continue;
        feet.push_back({low.point + from * low.direction, low.point + to * low.direction,
                        high.point - low.point});
    }
    return feet;
}

} // namespace fff
