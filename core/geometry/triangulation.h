// Triangles of a region, for drawing and for solids.
#pragma once

#include "core/base/result.h"
#include "core/geometry/polygon.h"

#include <array>
#include <vector>

namespace fff {

struct Triangulation
{
    std::vector<Vec2> points; // n; the region's vertices, and any crossings of its edges
    std::vector<std::array<int, 3>> triangles; // counter-clockwise
};

/// Constrained Delaunay triangulation of the region (even-odd where edges cross). Touching corners,
/// collinear and repeated points are fine. Empty for a region without area. Errors  NotWorkedOut
/// when CGAL fails. O(n log n).
Result<Triangulation> triangulate(const Region &region);

} // namespace fff
