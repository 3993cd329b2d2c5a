// Where a line in a section's plane runs inside of the section.
#pragma once

#include "core/assembly/joint.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace fff {

class Shape;

/// A directed line in a section's plane: `point` is where the axis counts from, `direction` a unit
/// vector.
struct PlaneLine
{
    Vec2 point = Vec2::Zero();
    Vec2 direction = Vec2::UnitX();

    double along(const Vec2 &p) const { return direction.dot(p - point); }
    double across(const Vec2 &p) const { return cross(direction, p - point); } // positive: left
    Vec2 at(double s) const { return point + s * direction; }
};

/// The line in which two planes meet, counted from its point nearest to the middle of both origins;
/// direction = normal(a) × normal(b). Nothing for planes that meet at less than kMinJointAngle.
std::optional<Axis> intersectionAxis(const Frame &a, const Frame &b);

/// The axis seen in a frame that contains it.
PlaneLine lineInFrame(const Axis &axis, const Frame &frame);

/// The stretches of the line strictly inside the region, in their order along it. On which side of
/// the line a vertex lies is decided exactly; a vertex on the line counts once for each side and
/// only what both agree on is inside, so an edge that runs along the line is not. O(vertices).
std::vector<Interval> intervalsOn(const PlaneLine &line, const Region &region);
/// The same of a shape's region, in the time of the edges near the line.
std::vector<Interval> intervalsOn(const PlaneLine &line, const Shape &shape);

/// An edge of a ring.
struct LineEdge
{
    Vec2 from = Vec2::Zero(), to = Vec2::Zero();
};
/// What finding intervals takes besides, kept from one line to the next.
struct IntervalMemory
{
    std::vector<AxisEnd> crossings;
    std::vector<Interval> intervals;
};
/// The same of a region of which no other edges come near the line, without the numbers of rings
/// and edges. Nothing where an end of one of them lies on the line. Lasts until the memory is used
/// again.
std::optional<std::span<const Interval>>
intervalsOn(const PlaneLine &line, std::span<const LineEdge> edges, IntervalMemory &memory);

/// How far along the line, towards `sign` (±1), the boundary reaches that closes the strip |across|
/// ≤ halfWidth at `end`: the largest sign·along on the boundary from `end` to where it leaves the
/// strip (or turns back behind `floor`). What a slit of that width must be long for to open all
/// across.
double mouthReach(const PlaneLine &line, const Region &region, const AxisEnd &end, double halfWidth,
                  double floor, int sign);

/// Where the walls of such a slit leave the section, and where a chamfer of each ends.
struct WallEnd
{
    bool isThere = false; // the boundary leaves the strip on this side, not behind `floor`
    double at = 0.0;      // sign · along, where it does
    /// Where it then is as far from there as `chamfer` (mm), or crosses the line that leaves the
    /// wall at 45° so much before: sign · along, and from the wall outwards.
    Vec2 chamferEnd = Vec2::Zero();
    double reach = 0.0; // the largest sign · along from `end` to there
};

/// Of the walls to the left and to the right of the line; arguments as above. A wall that the
/// boundary leaves twice is the first one's.
std::array<WallEnd, 2> wallEnds(const PlaneLine &line, const Region &region, const AxisEnd &end,
                                double halfWidth, double floor, int sign, double chamfer);

} // namespace fff
