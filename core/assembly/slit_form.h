// How a slit differs from a plain rectangle: relief for a round tool at its end, chamfers at its
// mouth, bumps that press on its guest.
#pragma once

#include "core/geometry/contour.h"
#include "core/model/stock.h"

#include <array>
#include <vector>

namespace fff {

/// The arcs of a slit's end are drawn with the tool's radius and this, so that its path, half of
/// the kerf inside of them, still has a radius. mm.
inline constexpr double kToolAllowance = 0.1;

/// The chamfer of one wall. From the slit's bottom along it, and from the wall outwards, mm.
struct LeadIn
{
    double from = 0.0;      // along: where it leaves the wall
    Vec2 to = Vec2::Zero(); // (along, outwards): just beyond the contour, where it ends
    double top = 0.0;       // along: beyond all of the contour that it cuts
    bool operator==(const LeadIn &other) const
    {
        return from == other.from && to == other.to && top == other.top;
    }
};

/// What is cut beside a slit's rectangle, and what stays of it. All of it lies within 2 · radius of
/// the rectangle's inner corners, or at its mouth, but for the bumps.
struct SlitForm
{
    SlitEnd end = SlitEnd::Square; // both ends of a mortise
    double radius = 0.0;           // mm, of the arcs
    std::array<LeadIn, 2> leadIns; // of the walls to the left and to the right, as one looks out of
                                   // the slit; top 0: none
    double bumps = 0.0;            // mm, height of one on each wall, in the middle of what holds
    double held = 0.0;             // mm from the bottom, as far as the guest reaches

    bool operator==(const SlitForm &) const = default;
};

/// Whether slits of a stock are anything but rectangles.
bool hasForm(const Stock &stock);
/// What a stock's slits of that width (mm) are, without lead-ins and what the guest holds. Bumps
/// leave at least half of the width.
SlitForm formOf(const Stock &stock, double width);

/// Where a slit's rectangle lies: along x from its bottom (0) to its mouth, half of its width to
/// both sides.
struct SlitBox
{
    double length = 0.0, half = 0.0; // mm
    bool isOpen = true;              // else both ends are bottoms
};

/// What is cut, as contours that may overlap each other, counter-clockwise, in coordinates of the
/// box. One, unless the slit is too short for its relief: then the arcs are discs of their own and
/// bumps are left out.
///
/// An arc's radius is no more than fits across the slit: of a round end half of its width, of the
/// others 1.17 times that. A bump is ten times as long as it is high; it takes no more than four
/// fifths of the straight wall, else it is flatter.
/// Source  dogbone and T-bone: the arc goes through the corner, so that a disc of the tool's radius
///         inside of it touches the corner.
std::vector<Contour> slitCuts(const SlitForm &form, const SlitBox &box);

/// How much of its walls holds nothing, along the one that has less: at the end and at the mouth,
/// mm.
double looseWall(const SlitForm &form, const SlitBox &box);

/// How far the end goes beyond the square bottom, mm; half: of the slit's width, mm.
double reachBeyond(const SlitForm &form, double half);

} // namespace fff
