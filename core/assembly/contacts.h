// Where bodies touch: points at which one keeps the other from moving.
#pragma once

#include "core/assembly/body.h"
#include "core/base/tolerances.h"

#include <vector>

namespace fff {

/// A point of one body before a wall or a face of another one.
struct Contact
{
    Vec3 at = Vec3::Zero();      // world, mm
    Vec3 normal = Vec3::UnitY(); // unit, out of the other body
    double gap = 0.0;            // mm that are free; less than 0: so deep it is in the other one
};

/// Where points of the edges of `body` are no more than `reach` mm before a wall or a face of
/// `other`, or so deep in it: of each stretch along which an edge keeps to one wall, or to one
/// face, its first and its last point. A point beyond the end of a wall, or of a face, is before
/// none. What the edges of `other` touch is asked the other way round; together they are all that
/// counts, as where two faces meet corners of one or the other, or edges that cross, are outermost.
///
/// A point that is before a wall by no more than `rim` mm, measured from the faces, passes it, and
/// so does one that is before a face by no more than that, measured from the outline.
///
/// Points are kContactStep apart, so that a stretch is by so much too short: that lets move more,
/// never less. O(edges of `body` near the other one · edges of that one near to each point).
std::vector<Contact> contactsOf(const Body &body, const Body &other, double reach,
                                double rim = kTouchingDepth);

inline constexpr double kContactStep = 0.1; // mm

} // namespace fff
