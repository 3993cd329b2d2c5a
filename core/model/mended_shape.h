// Whatever was drawn or read, what comes out is a contour that does not cross itself with holes
// that lie in it and not on each other. Every reader and every drawn hole goes through here.
#pragma once

#include "core/model/shape.h"

#include <string>
#include <vector>

namespace fff {

/// A contour or hole and where it stands in a file, if it is from one: the place of warnings.
struct PlacedContour
{
    Contour contour;
    std::string where;
};

/// What needs no mending comes back bit for bit, but for the winding that Shape::make gives.
///
/// name      the section's, for the warnings; may be empty
/// Errors    EmptyContour, or as resolveCrossings() and subtract(), without a place
/// Warnings  SelfCrossingContour: the largest region of that contour or hole was kept (non-zero
///           winding). DegenerateHole, HoleOutside: that hole was left out; the latter also when it
///           would take the contour apart. MergedHoles: this hole and others overlap and are one
///           now. NotchedContour: a hole that crosses the contour was cut out of it.
Result<ShapePointer> makeMendedShape(const PlacedContour &contour,
                                     const std::vector<PlacedContour> &holes,
                                     const std::string &name, std::vector<Warning> &warnings);

} // namespace fff
