// Triangles of plain regions by one sweep: what nearly every section of nearly every model needs,
// a tenth of the cost of a Delaunay triangulation. Internal to geometry.
#pragma once

#include "core/geometry/triangulation.h"

#include <optional>

namespace fff {

/// The region cut into triangles whose corners are exactly its vertices, in their order (outer,
/// then the holes).
///
/// region   outer counter-clockwise, holes clockwise; no ring touches itself or another one
/// Nothing where it is not that plain: a vertex that lies on an edge or on another vertex, a ring
/// of less than 3 vertices. Sides are decided exactly, and what is returned has the number of
/// triangles that such a region has, so that none is missing. Source  S. Hertel, K. Mehlhorn 1983,
/// Fast triangulation of the plane with respect to simple
///         polygons: behind the sweep everything is cut but for chains that are bent inwards.
/// O(n log n + n · stretches of the sweep line inside the region).
std::optional<Triangulation> sweepTriangles(const Region &region);

} // namespace fff
