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

/// Something that lies on three points or more, and what becomes of it when it is pushed. Pushed
/// over an edge of what touches it rolls until another point touches: on that it stands, too, as
/// long as it is turned by no more than kFarthestLean then.
struct Rest
{
    Ground ground;              // none of the points is below it
    double lean = 0.0;          // radians, of it against the vertical
    std::vector<Vec3> contacts; // all points on which it stands, at once or one after the other
    double tipAngle = 0.0;      // radians: on a table that is tilted by less it does not fall
    double margin = 0.0;      // mm along the ground from its centre of mass to the edge over which
                              // it falls, as it leans by then
    Vec3 edge = Vec3::Zero(); // the point of that edge to which that is measured
    double rocking = 0.0;     // radians: so far from `ground` it comes before it falls, when it is
                              // tilted by less than kSteadyTilt
};

/// Farther than this nothing is said to lean, it falls (10°, radians).
inline constexpr double kFarthestLean = 0.17453292519943295;

/// Tilted by less than this, something that stands ought not to fall: 10°, as for household
/// equipment (IEC 62368-1, stability). Radians.
inline constexpr double kSteadyTilt = 0.17453292519943295;

/// It rolls, as slowly as can be, about the nearest edge of what touches, until its centre of mass
/// is over that: its height sinks with each step. Points touch that are within kGroundContact of
/// the lowest. From there every edge is tried, and every one of what it comes to lie on: it falls
/// over those after which nothing touches in time, and of the ways to one of them that counts which
/// takes least tilting.
/// points  of which the hull is its own, mm, world; at least all that are no higher above the
///         lowest than what leans by twice kFarthestLean would bring down
/// Result  none: it leans by more than kFarthestLean before it rests. Without points none either.
/// O(points · steps); each step needs another set of points that touch, and there are no more than
/// kMostRests.
std::optional<Rest> settle(const std::vector<Vec3> &points, const Vec3 &centreOfMass);

/// What has more, such as a ball, is taken to fall from the next one.
inline constexpr std::size_t kMostRests = 200;

} // namespace fff
