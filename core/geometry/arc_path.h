// A line of straight edges and circular arcs, as machines and drawings take it.
#pragma once

#include "core/geometry/vector.h"

#include <vector>

namespace fff {

/// From where the step before ended. bulge  tangent of a quarter of the angle that the arc turns
/// by, positive counter-clockwise (DXF's group 42); 0: straight
struct ArcStep
{
    Vec2 end = Vec2::Zero();
    double bulge = 0.0;
};

/// What a step is a part of: none of a straight one.
struct Arc
{
    Vec2 center = Vec2::Zero();
    double radius = 0.0;
    double from = 0.0;  // angle of its start, radians
    double sweep = 0.0; // counter-clockwise

    Vec2 at(double share) const; // 0 … 1
};
/// Of a step with a bulge, whose ends differ.
Arc arcOf(const Vec2 &start, const ArcStep &step);

struct ArcPath
{
    Vec2 start = Vec2::Zero();
    std::vector<ArcStep> steps;
    bool isClosed = false; // ends where it starts, and goes round

    Vec2 end() const { return steps.empty() ? start : steps.back().end; }
    /// mm. Exact but for rounding.
    double length() const;
    /// Exact: where an arc reaches beyond its ends, it counts.
    Box2 bounds() const;
    ArcPath reversed() const;
};

/// Length of a step from there, mm.
double lengthOf(const Vec2 &start, const ArcStep &step);

} // namespace fff
