// The solid of one piece of a section, as the questions about solids need it.
#pragma once

#include "core/geometry/frame.h"
#include "core/geometry/polygon.h"

namespace fff {

/// A region in the mid-plane of a frame, half of `thickness` (mm) to both sides of it, walls square
/// to it. Region and frame outlive it.
struct Slab
{
    const Region &region;
    const Frame &frame;
    double thickness = 3.0;
};

/// World, mm.
Box3 boundsOf(const Slab &slab);

/// 0 for boxes that meet. mm.
double distanceBetween(const Box3 &a, const Box3 &b);

/// Two points, one on each of two slabs.
struct Nearest
{
    double distance = std::numeric_limits<double>::infinity(); // mm; 0 when they share a point
    Vec3 onA = Vec3::Zero(), onB = Vec3::Zero();
};

/// The nearest points of two slabs, looked for only as far as `limit` mm: further apart than that,
/// the distance comes back infinite. Exact but for rounding; O(edges of a · edges of b) in the
/// worst case, most of them told apart by their boxes.
/// Source  C. Ericson 2005, Real-Time Collision Detection, 5.1.9 (two segments).
Nearest nearestPoints(const Slab &a, const Slab &b,
                      double limit = std::numeric_limits<double>::infinity());

} // namespace fff
