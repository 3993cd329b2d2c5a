// Whether a layout may be given out, looked at by other means than it was found by.
#pragma once

#include "core/nesting/problem.h"

#include <optional>

namespace fff::nest {

/// What is wrong with a solution.
struct Fault
{
    enum class Kind { Overlap, TooNear, OutsideOfSheet, WrongTurn, WrongCount };

    Kind kind = Kind::Overlap;
    int first = 0;   // index of the place
    int second = -1; // of the other one; none: the sheet's edge, or what is taken of it
};

/// The first fault, or none. True outlines where they lie, snapped to the grid of kClipGrid: there
/// all is exact, whether edges cross and what is in what. Distances are those of the chords, with
/// Problem::chord on both sides, to kClipSlack. Outlines that touch are a fault: nestPieces() keeps
/// them apart by more than rounding. At the container's edge, without a margin, they may touch it.
/// O(n log n) for edges of which few are near each other.
std::optional<Fault> faultOf(const Problem &problem, const Solution &solution);

} // namespace fff::nest
