// The part of a skin over one cycle of curves.
#pragma once

#include "core/skin/skin_curve.h"

#include <vector>

namespace fff {

/// More sides than this say nothing of what is between them,
inline constexpr std::size_t kMostSides = 8;
/// but where they run once round a place that is seen whole from outside (isSeenWhole): there, so
/// many.
inline constexpr std::size_t kMostSidesSeenWhole = 32;

/// Whether curves that follow each other run once, counter-clockwise, round their middle as seen
/// along the mean of their normals, and the surface looks that way along all of them.
bool isSeenWhole(const std::vector<SkinCurve> &sides);

/// Triangles over 2 … kMostSidesSeenWhole curves that follow each other counter-clockwise, seen
/// from outside, each with a point in its middle. Two span arcs, four a Coons patch; any other
/// number is parted into as many patches as it has corners, by curves from the middles of its sides
/// to a centre, which lies where arcs from there meet: on the sphere, where the sides are circles
/// of one.
void fillCycle(GrowingMesh &mesh, const std::vector<SkinCurve> &sides);

} // namespace fff
