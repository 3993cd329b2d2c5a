// A piece as the search sees it: its grown outline at each of its turns. Internal to nesting.
#pragma once

#include "core/nesting/posed.h"
#include "core/nesting/problem.h"

namespace fff::nest {

struct Shape
{
    Region outline;            // grown, and moved: its box lies about the origin
    Vec2 moved = Vec2::Zero(); // by that
    std::vector<Pole> poles;
    std::vector<Posed> turns; // that are allowed, or with which to begin
    bool turnsFreely = false;
    double area = 0.0;     // of the piece itself
    double diameter = 0.0; // of the outline's box as drawn
    double least = 0.0;    // lesser side of that box, or a tenth of it where that is more
    double weight = 0.0;   // of what it overlaps: fourth root of the area of its hull

    /// Only what construction needs is worked out at first: discs when they are asked for.
    void addPoles();
};

/// outline  grown
/// turns    at least one
Shape shapeOf(Region outline, const std::vector<Vec2> &turns, bool turnsFreely, double area);

/// Turns to begin with of what turns freely: as drawn, with the smallest box and the lowest one,
/// and quarter turns of these; `more` turns besides.
std::vector<Vec2> goodTurns(const Polygon &outline, const std::vector<Vec2> &more);

} // namespace fff::nest
