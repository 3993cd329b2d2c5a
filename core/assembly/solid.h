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

/// Where `a`, moved along `direction` (unit), is deeper than `depth` (mm) in `b`: the first stretch
/// of the way from 0 on, as far as the prism that it was found in tells. Nothing when it comes free
/// of b. With depth < 0 it is enough to come as near as that.
///
/// Depth is measured between prisms: the least that one of them would have to move to come free of
/// the other. A contact, and two faces that slide on each other, are none.
/// Source  separating axes of convex polytopes, each with the stretch of the way in which it does
///         not separate (C. Ericson 2005, Real-Time Collision Detection, 5.5.8).
///
/// These and more about the same two are in encounter.h.
std::optional<Travel> collisionAlong(const Solid &a, const Solid &b, const Vec3 &direction,
                                     double depth);

/// How deep two solids are in each other as they are (mm, see above), and where; nothing when they
/// only touch, to `depth`. Of a solid that is cut up measured where it is whole.
struct Interpenetration
{
    double depth = 0.0;
    Vec3 at = Vec3::Zero();
};
std::optional<Interpenetration> interpenetration(const Solid &a, const Solid &b, double depth);

} // namespace fff
