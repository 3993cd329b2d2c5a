// Where a load that is spread acts on what it lies on.
#pragma once

#include "core/geometry/polygon.h"
#include "core/model/load.h"

#include <vector>

namespace fff {

struct LoadPoint
{
    Vec2 at = Vec2::Zero(); // frame coordinates, mm
    double share = 1.0;     // of the load; all together are 1
};

/// position  of the load, frame coordinates, mm
/// region    of the body that it acts on
///
/// A patch presses on what the region has of its disc, under a stiff base: the pressure changes
/// evenly from one side to the other, so that all of it together acts at `position`, and is nowhere
/// less than zero. An edge is the stretch of the boundary about the place nearest to it, pressed
/// evenly. Where nothing of that is there, and of other loads, it is `position` alone.
std::vector<LoadPoint> loadPoints(const Load &load, const Vec2 &position, const Region &region);

} // namespace fff
