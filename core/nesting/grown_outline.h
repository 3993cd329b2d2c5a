// Outlines with the room that they need around them. Internal to nesting.
#pragma once

#include "core/geometry/polygon.h"

namespace fff::nest {

/// A region that holds all within `distance` of the outline, with few corners: it may be larger by
/// up to twice `slack`. Corners are mitred, the longest ones cut off. What has no area is its box,
/// grown.
/// distance  mm, more than a few steps of kClipGrid
Region grownOutline(const Region &outline, double distance, double slack);

/// What is left of a container's outline within `distance` of its edge: a box, less what of it is
/// not inside. A distance below 0 grows the container.
struct Inside
{
    Box2 box; // empty: nothing is left
    std::vector<Region> obstacles;
};
Inside insideOf(const Region &container, double distance);

} // namespace fff::nest
