// Convex hulls in space.
#pragma once

#include "core/geometry/vector.h"

#include <array>
#include <vector>

namespace fff {

/// Of a convex hull in space, all of triangles.
struct HullFaces
{
    struct Face
    {
        std::array<int, 3> corners; // indices of points, counter-clockwise as seen from outside
        std::array<int, 3> across;  // faces, over the edges from each corner to the next one
    };
    std::vector<Vec3> points; // its corners only
    std::vector<Face> faces;
};

/// Exact predicates. Nothing when all points are on a plane. O(n log n).
HullFaces hullFaces(const std::vector<Vec3> &points);

} // namespace fff
