// In which order a machine follows the lines of a sheet, and what that takes.
#pragma once

#include "core/fabrication/machine.h"
#include "core/geometry/bezier.h"

#include <vector>

namespace fff {

/// A line as the tool follows it; sheet coordinates, mm.
struct ToolLine
{
    Purpose purpose = Purpose::OuterCut;
    std::size_t part = 0;            // index in the sheet's
    std::vector<CubicBezier> curves; // each from where the one before ended, none without length
    bool isClosed = false;           // its last end is its first start, to the last bit
    int joint = 0;                   // whose number it is of; 0: of none

    const Vec2 &start() const { return curves.front().p0; }
    const Vec2 &end() const { return curves.back().p3; }
};

/// All lines of the sheet as they lie in its parts: of each its numbers, what is drawn on it, its
/// holes, its outside. Straight ones have their handles at the thirds.
std::vector<ToolLine> toolLines(const CuttingSheet &sheet);

/// The same as they are best followed:
///
///   engraved before scored before cut, so that nothing moves that is still to be burnt
///   what lies within a cut before that cut: holes of a part before its outside, and a part that
///   lies in another one's hole before that hole
///   else the nearest next, from where the tool is; lines that are open from either end
///   none twice: of several lines with the same points, whichever way round, the first
///   cuts by the sheet's finish (cut_finish.h): with tabs and leads they are several open lines
///
/// from  where the tool is at first. Deterministic. As a rule O(n log n).
std::vector<ToolLine> inCuttingOrder(const CuttingSheet &sheet, const Vec2 &from = Vec2::Zero());

/// Indices of parts with a cut that has no room for the lead that the finish asks for, ascending.
std::vector<std::size_t> partsWithoutLead(const CuttingSheet &sheet);

/// How far the tool goes, mm.
struct ToolWay
{
    double engraved = 0.0, scored = 0.0, cut = 0.0, travel = 0.0;

    double seconds = 0.0; // by the machine's speeds; starting and stopping takes longer
    ToolWay &operator+=(const ToolWay &other);
};
/// In the order in which the lines stand. from  as above
ToolWay wayAlong(const std::vector<ToolLine> &lines, const Machine &machine,
                 const Vec2 &from = Vec2::Zero());
/// Along the curves, mm; off by far less than 1 µm for each of them.
double lengthOf(const ToolLine &line);

} // namespace fff
