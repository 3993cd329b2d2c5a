// A line across which something is mirrored.
#pragma once

#include "core/geometry/vector.h"

namespace fff {

struct MirrorAxis
{
    Vec2 point = Vec2::Zero();
    Vec2 direction = Vec2::UnitX(); // unit

    /// Distance from the line, positive to the left of the direction.
    double height(const Vec2 &p) const { return cross(direction, p - point); }
    /// p mirrored across it.
    Vec2 mirrored(const Vec2 &p) const { return p - 2.0 * height(p) * perpendicular(direction); }

    bool operator==(const MirrorAxis &other) const
    {
        return point == other.point && direction == other.direction;
    }
};

} // namespace fff
