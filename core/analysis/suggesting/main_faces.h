// Directions across which much of a surface lies flat, as on what is made of boards or of blocks.
#pragma once

#include "core/geometry/vector.h"

#include <vector>

namespace fff {

struct MainFace
{
    Vec3 normal = Vec3::UnitX(); // unit; of faces that look either way
    double share = 0.0;          // of the surface that lies across it, 0 … 1
    /// Where there are faces, one after the other.
    struct Place
    {
        double offset = 0.0;    // of normal · p, mm
        bool looksAlong = true; // the normal points out of the material, else into it
    };
    std::vector<Place> places = {};
};

/// Those of kLeastMainFace or more, largest first, none nearer to another one than they are flat.
/// points   spread evenly over the surface, mm
/// normals  of the surface there, outwards, unit; 0 where there is none
/// near     mm: places nearer to each other are one
/// O(n²)
std::vector<MainFace> mainFaces(const std::vector<Vec3> &points, const std::vector<Vec3> &normals,
                                double near);

/// Of the surface: a side of a prism with eight sides is one, a strip of something round is none.
inline constexpr double kLeastMainFace = 0.08;

} // namespace fff
