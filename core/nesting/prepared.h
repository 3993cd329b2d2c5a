// A problem as the search sees it: shapes with their room around them, sheets less their margins.
// Internal to nesting.
#pragma once

#include "core/nesting/exploration.h"

namespace fff::nest {

struct Prepared
{
    std::vector<Shape> shapes; // one a piece

    struct Sheet
    {
        Box2 box;
        std::vector<Shape> obstacles;
        int count = 1; // as SheetKind
        bool isFree = false;
    };
    std::vector<Sheet> sheets; // by kind; one for a strip
    bool isStrip = false;
};

/// Lengths by which shapes are larger than pieces with their spacing, so that rounding cannot make
/// them overlap: mm.
inline constexpr double kSlackForRounding = 1e-5;

/// Everything becomes shorter along x, the lower side first. Sheets fill from below, the left side
/// first: they are seen in a mirror for that, x and y swapped.
Prepared prepare(const Problem &problem);

/// How a piece lies, seen by its problem.
Place placeOf(const Prepared &prepared, int piece, int sheet, const Pose &pose);
/// The other way; what may not be turned so is turned as nearly as it may be.
Pose poseOf(const Prepared &prepared, const Place &place);

} // namespace fff::nest
