// Contours whose nearly straight lines are straight, and whose nearly right angles are right.
#pragma once

#include "core/geometry/contour.h"

#include <optional>
#include <vector>

namespace fff {

struct Straightened
{
    Contour contour;
    bool hasRightAngles = false; // of those that it changed
};

/// See meant_shape.h. None where nothing changes.
std::optional<Straightened> straightened(const Contour &drawn, double tolerance);

/// By how much it turns where each of its segments starts, radians, 0 where it is smooth.
std::vector<double> turnsAtJoints(const Contour &contour);

} // namespace fff
