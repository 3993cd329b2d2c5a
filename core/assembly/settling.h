// Where something rigid comes to rest on the ground: on the points that are lowest, or, where its
// centre of mass is not over these, leaning until more of them touch.
#pragma once

#include "core/geometry/vector.h"

#include <optional>
#include <vector>

namespace fff {

/// A plane that things stand on: up · p = height. Mostly Y = 0; of what leans it is the plane that
/// leans, in the world in which the model was drawn.
struct Ground
{
    Vec3 up = Vec3::UnitY(); // unit
    double height = 0.0;     // mm

    double above(const Vec3 &p) const { return up.dot(p) - height; }
    /// Two axes along it, of X and Z turned as little as can be.
    Vec3 acrossX() const;
    Vec3 acrossZ() const;
};

struct Rest
{
    Ground ground;              // none of the points is below it
    double lean = 0.0;          // radians, of it against the vertical
    std::vector<Vec3> contacts; // on it, and those on which it only rocks
};

/// Farther than this nothing is said to lean, it falls (10°, radians).
inline constexpr double kFarthestLean = 0.17453292519943295;

/// What comes down when it rocks by less than this over an edge is a foot (half a degree, radians).
inline constexpr double kRocking = 0.008726646259971648;

/// It rolls, as slowly as can be, about the nearest edge of what touches, until its centre of mass
/// is over that: its height sinks with each step. Points touch that are within kGroundContact of
/// the lowest. Those on which it comes to stand when it rocks by less than kRocking over an edge
/// of the others are counted as contacts too: a table with one short leg does not fall.
/// points  of which the hull is its own, mm, world; at least all that are no higher above the
///         lowest than what leans by kFarthestLean would bring down
/// Result  none: it leans by more than kFarthestLean before it rests. Without points none either.
/// O(points · steps); each step needs a new point.
std::optional<Rest> settle(const std::vector<Vec3> &points, const Vec3 &centreOfMass);

} // namespace fff
