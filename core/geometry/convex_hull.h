// Convex hulls.
#pragma once

#include "core/geometry/polygon.h"

#include <vector>

namespace fff {

/// Counter-clockwise corners of the convex hull, none of them on an edge (exact predicates); one
/// point or the two ends when all points are on one another or on a line. Empty for no points.
/// O(n log n).
Polygon convexHull(const std::vector<Vec2> &points);

/// Indices of some points, ascending, of which the hull is that of all to kClipGrid: few of many
/// that lie in rows and lumps. O(n).
std::vector<std::size_t> outermost(const std::vector<Vec2> &points);

/// convexHull() to kClipGrid, of many points in a fraction of its time.
Polygon roughHull(const std::vector<Vec2> &points);

/// Distance from a point to the nearest edge of a convex polygon as convexHull gives it, mm:
/// positive inside, negative outside, 0 exactly on the boundary (the sign is exact; a hull of two
/// points or one has no inside). Infinitely far outside of an empty one.
/// nearest  the point of the boundary that is nearest, if asked for
double signedDistance(const Polygon &hull, const Vec2 &point, Vec2 *nearest = nullptr);

} // namespace fff
