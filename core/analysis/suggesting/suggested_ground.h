// How suggested sections meet the ground: cut flat a little, and filled up where they have to
// stand.
#pragma once

#include "core/geometry/frame.h"
#include "core/geometry/polygon.h"

#include <vector>

namespace fff {

/// What is round stands on a point. It is cut off at `level`, and where it still comes no lower
/// than `filled` above that, but near enough to the point under its centre of mass, its sections
/// are filled up down to it: a foot under the belly of a fish, instead of a fish without a belly.
struct SuggestedGround
{
    double level = 0.0;         // Y, world, mm; below is nothing
    double filled = 0.0;        // mm above that; 0: no feet
    Vec2 middle = Vec2::Zero(); // (x, z), mm, of where feet are
    double around = 0.0;        // mm, as far as they are from there

    double top() const { return level + filled; }
};

/// Stretches of a section on the ground, where it stands on feet. Frame coordinates.
struct SuggestedFoot
{
    Vec2 from = Vec2::Zero(), to = Vec2::Zero(); // on the level
    Vec2 up = Vec2::UnitY();                     // to the top of what is filled

    Polygon outline() const { return {from, to, to + up, from + up}; } // counter-clockwise
};

/// Of an upright section, none of one that lies. Their outlines' upper edges are in the region.
std::vector<SuggestedFoot> feetOn(const SuggestedGround &ground, const Frame &frame,
                                  const Region &region);

/// The line of points of a section at so much Y, as (point, unit direction along it), frame
/// coordinates; all such lines of a frame have their points above each other. The section must not
/// lie.
struct LevelLine
{
    Vec2 point = Vec2::Zero(), direction = Vec2::UnitX();
};
LevelLine levelLine(const Frame &frame, double height);
/// What lies flatter has no feet to speak of: sine of the angle to the ground.
inline constexpr double kUprightSine = 0.2;

} // namespace fff
