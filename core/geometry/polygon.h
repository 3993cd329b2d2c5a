// Polygons: closed chains of straight edges, the first point not repeated.
#pragma once

#include "core/geometry/vector.h"

#include <vector>

namespace fff {

using Polygon = std::vector<Vec2>;

/// A connected piece of the plane: outer counter-clockwise, holes clockwise.
struct Region
{
    Polygon outer;
    std::vector<Polygon> holes;
};

/// Positive for counter-clockwise. mm².
double signedArea(const Polygon &polygon);
/// Area of the outer polygon without its holes. mm².
double area(const Region &region);
Box2 bounds(const Polygon &polygon);

enum class Side { Outside, Boundary, Inside };

/// Exact (CGAL's orientation predicate decides each crossing). Winding does not matter (even-odd).
Side locate(const Vec2 &point, const Polygon &polygon);
/// Inside the outer polygon and outside of every hole; on any of them is Boundary.
Side locate(const Vec2 &point, const Region &region);
/// mm from the point to the nearest of the region, 0 inside. O(vertices).
double distanceTo(const Vec2 &point, const Region &region);

} // namespace fff
