// From lines of a drawing to what they enclose.
#pragma once

#include "core/geometry/contour.h"
#include "core/geometry/curve_path.h"

#include <vector>

namespace fff {

/// Something that can be cut out in one piece.
struct Outline
{
    Contour outer;              // counter-clockwise
    std::vector<Contour> holes; // clockwise
    bool isInHole = false;      // of another one
};

/// Lines made one where their ends are within `gap` mm of each other and no third line ends there:
/// programs for drawing plans write every edge by itself. Closed ones stay.
std::vector<CurvePath> joined(std::vector<CurvePath> lines, double gap);

/// What closed lines enclose: those in no other one are outer contours, those in one are holes,
/// those in holes outer ones again, and so on. A line that crosses itself is the largest region
/// that it winds round; open ones, repeated ones, those without area and those that cross
/// themselves too often (largestTangle) are left out. In the order
/// of their outer contours' areas, largest first. O(n log n) for n lines and points, as a rule
/// (ring_nesting.h). Errors  NotWorkedOut, as resolveCrossings().
Result<std::vector<Outline>> outlinesOf(const std::vector<CurvePath> &lines);

/// The most work (tangle.h) that taking apart any closed line is; outlinesOf() does it up to
/// kMostCrossingWork.
double largestTangle(const std::vector<CurvePath> &lines);

/// Ends of lines that are drawn to meet are this near, mm: what three decimals leave of inches.
inline constexpr double kDrawnGap = 0.05;

} // namespace fff
