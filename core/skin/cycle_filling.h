// The part of a skin over one cycle of curves.
#pragma once

#include "core/skin/skin_curve.h"

#include <vector>

namespace fff {

/// More sides than this say nothing of what is between them.
inline constexpr std::size_t kMostSides = 8;

/// Triangles over 2 … kMostSides curves that follow each other counter-clockwise, seen from
/// outside, each with a point in its middle. Two span arcs, four a Coons patch; any other number is
/// parted into as many patches as it has corners, by curves from the middles of its sides to a
/// centre, which lies where arcs from there meet: on the sphere, where the sides are circles of
/// one.
void fillCycle(GrowingMesh &mesh, const std::vector<SkinCurve> &sides);

} // namespace fff
