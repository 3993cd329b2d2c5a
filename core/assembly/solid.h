// A part as a solid that moves: whether it runs into another one, and when.
#pragma once

#include "core/geometry/box_runs.h"
#include "core/geometry/frame.h"
#include "core/geometry/triangulation.h"

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace fff {

/// Where something lies along an axis, mm.
struct Extent
{
    double min = std::numeric_limits<double>::infinity();
    double max = -std::numeric_limits<double>::infinity();
};

/// A part of a section as cut, half of its thickness to both sides of the frame's plane: a prism
/// for each of its triangles. Overlaps and the union of the prisms are all that counts, so that how
/// it was cut into triangles does not matter.
struct Solid
{
    Frame frame;
    Vec3 normal = Vec3::UnitZ();
    double half = 0.0;                          // of the thickness, mm
    std::vector<std::array<Vec3, 3>> triangles; // in the frame's plane, world
    BoxRuns runs;                               // of these, in the frame
    std::vector<Vec3> hull;                     // of these, world
    Box3 box;                                   // world
    /// The same in triangles between its corners alone, by which depths are measured; null: these
    /// are.
    std::shared_ptr<const Solid> whole;

    /// axis: unit, through the world's origin. O(hull).
    Extent along(const Vec3 &axis) const;
};

using SolidPointer = std::shared_ptr<const Solid>;

/// thickness: mm.
Solid makeSolid(const Triangulation &triangulation, const Frame &frame, double thickness);

/// The same solid, in other triangles of its region.
Solid cutUp(std::shared_ptr<const Solid> whole, const Triangulation &cells);

Solid movedBy(Solid solid, const Vec3 &by);

/// A stretch of a way along a straight line, mm from where it begins.
struct Travel
{
    double from = 0.0, to = 0.0;
};

/// How deep two solids are in each other, mm, and where (encounter.h).
struct Interpenetration
{
    double depth = 0.0;
    Vec3 at = Vec3::Zero();
};

} // namespace fff
