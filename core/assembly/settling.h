// Where something rigid comes to rest on the ground: on the points that are lowest, or, where its
// centre of mass is not over these, leaning until more of them touch.
#pragma once

#include "core/assembly/slab.h"
#include "core/assembly/toppling.h"

#include <optional>
#include <vector>

namespace fff {

/// Where something lies, on three points or more, and what becomes of it when it is pushed.
struct Rest : Toppling
{
    double lean = 0.0; // radians, of its ground against the vertical
};

/// Of a slab the points that can come to touch as what it belongs to leans and rocks (settle):
/// corners of its hull that have nothing steeply below them. World, mm. O(n log n + n · points).
std::vector<Vec3> undermost(const Slab &slab);

/// It rolls, as slowly as can be, about the nearest edge of what touches, until its centre of mass
/// is over that: its height sinks with each step. Points touch that are within kGroundContact of
/// the lowest. What becomes of it there: toppling.h.
/// points  of which the hull is its own, mm, world; at least all that are no higher above the
///         lowest than what leans by twice kFarthestLean would bring down
/// Result  none: it leans by more than kFarthestLean before it rests. Without points none either.
/// O(points · steps + points · log points); each step needs another set of points that touch.
std::optional<Rest> settle(const std::vector<Vec3> &points, const Vec3 &centreOfMass);

} // namespace fff
