// Directions across which much of a surface lies flat, as on what is made of boards or of blocks.
#pragma once

#include "core/geometry/vector.h"

#include <vector>

namespace fff {

struct MainFace
{
    Vec3 normal = Vec3::UnitX(); // unit; of faces that look either way
    double share = 0.0;          // of the surface that lies across it, 0 … 1
};

/// Those of kLeastMainFace or more, largest first, none nearer to another one than they are flat.
/// normals  of points spread evenly over the surface, unit; 0 where there is none. O(n²)
std::vector<MainFace> mainFaces(const std::vector<Vec3> &normals);

/// Of the surface: a side of a prism with eight sides is one, a strip of something round is none.
inline constexpr double kLeastMainFace = 0.08;

} // namespace fff
