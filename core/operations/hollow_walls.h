// Sections of which only walls are left: along their contours, and where others cross them.
#pragma once

#include "core/geometry/contour.h"
#include "core/geometry/frame.h"

#include <vector>

namespace fff {

/// What is left in a contour within a wall of this width, mm, clockwise: nothing where there is no
/// room.
std::vector<Contour> roomIn(const Contour &contour, double wall);

struct HollowOptions
{
    double wall = 12.0;     // mm
    double smallest = 0.0;  // mm²; a smaller hole is none
    double thickness = 0.0; // of the sheets of those that cross, mm
    /// Planes of sections that cross this one: along each of these lines a wall stays.
    std::vector<Frame> crossing = {};
};

/// The holes to take out of a section with this contour, clockwise.
/// holes  that it has; not around them: their walls would hang in the air
std::vector<Contour> hollowOf(const Frame &frame, const Contour &contour,
                              const std::vector<Contour> &holes, const HollowOptions &options);

} // namespace fff
