// Contours of the samples, in frame coordinates, mm.
#pragma once

#include "core/geometry/contour.h"

#include <vector>

namespace fff::samples {

struct Corner
{
    Vec2 at;
    bool isSharp = false;
};

/// Through these points; smooth but at the sharp ones (a chord a third of the way to the
/// neighbours, after Catmull and Rom).
Contour through(const std::vector<Corner> &corners);

/// Through these points, as one would lay a spline: handles are a third of their own chord long and
/// turn more towards the nearer neighbour, so that points may be unevenly far apart.
Contour flowing(const std::vector<Corner> &corners);
/// Its right half, from the first point to the last one, and the mirror image; points at x = 0 are
/// their own.
Contour flowingBothSides(const std::vector<Corner> &right);

/// A corner of straight edges, rounded.
struct RoundCorner
{
    Vec2 at;
    double radius = 0.0; // 0: sharp
};
Contour rounded(const std::vector<RoundCorner> &corners);
/// Its right half, from the first corner to the last one, and the mirror image.
Contour roundedBothSides(std::vector<RoundCorner> right);
/// Upright, on the ground, round above.
Contour strip(double from, double to, double height, double radius);

Contour ellipse(const Vec2 &middle, double rx, double ry);
Contour circle(const Vec2 &middle, double radius);
Contour roundedRectangle(const Vec2 &middle, double width, double height, double radius);

} // namespace fff::samples
