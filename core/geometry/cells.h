// A region cut up into small ones, so that what happens at one place of it is the work of that
// place alone.
#pragma once

#include "core/geometry/polygon.h"
#include "core/geometry/triangulation.h"

namespace fff {

/// Regions of few vertices that make up this one, which it is cut into along lines in x and y; near
/// ones after each other. Where the lines lie follows from the bounds, so that a change of the
/// boundary elsewhere leaves a cell as it is, bit for bit.
///
/// region   as sweepTriangles() wants it; of another one come back a few large cells, or itself
/// Result   their corners are the region's vertices, and points in which lines cross its edges.
///          Together they have its area; nothing where they do not, to rounding.
/// O(n log n).
std::vector<Region> cellsOf(const Region &region);

/// Their triangles, in the cells' order; those of the whole region when it has no cells.
/// Errors  as triangulate().
Result<Triangulation> triangulateCells(const Region &region);

} // namespace fff
