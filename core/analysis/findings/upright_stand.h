// Drawn sections that stand upright: their line on the ground, and what of it they touch.
#pragma once

#include "core/model/model.h"

#include <optional>

namespace fff {

struct UprightStand
{
    int section = 0;
    Vec2 along = Vec2::Zero();   // (x, z), unit: the section's line on the ground
    double from = 0.0, to = 0.0; // mm along that line, from its origin: where it touches
    Vec2 origin = Vec2::Zero();  // (x, z)

    bool isOnGround() const { return from <= to; }
    Vec2 at(double s) const { return origin + s * along; }
    /// mm along the line, below or above a point of the section's plane.
    double placeOf(const Vec3 &point) const
    {
        return along.dot(Vec2(point.x(), point.z()) - origin);
    }
};

/// Nothing of a section that leans, or that an operation made.
std::optional<UprightStand> uprightStandOf(const Model &model, int section);

/// On the plane of a section that stands upright: from along its line and upwards, mm, to frame
/// coordinates.
Vec2 onPlane(const Section &section, const UprightStand &stand, double s, double height);

} // namespace fff
