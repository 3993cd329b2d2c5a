// True-shape nesting: pieces of any outline close together on a strip or on sheets.
#pragma once

#include "core/nesting/problem.h"

namespace fff::nest {

/// Pieces one after the other where there is room, largest first; then, as long as there is work,
/// less and less room: the strip becomes shorter, or the sheets fewer and the last one less used,
/// and shapes that overlap then are taken apart. Holes and bays of pieces are room, too. What is
/// given out has been looked at by faultOf(): where a search has no sound layout, the first one
/// stands.
///
/// Problem   see there; of outlines that cross themselves what they wind round counts
/// Options   `work` for each of two searches, which run side by side
/// longWork  stopped: what is best so far is given out. The clock, if any, is its caller's.
/// before    places of all pieces, on sheets of these kinds, where they lay when they, or their
///           distances, were a little different: what overlaps by now is taken apart, with little
///           work, and what comes of it is begun with unless it is worse than the first layout.
///           Not of many pieces. Without places: nothing is known.
///
/// The same problem, seed and work give the same solution, bit for bit, unless it was stopped.
/// Source  J. Gardeyn, G. Vanden Berghe, T. Wauters 2025, arXiv 2509.13329.
Solution nestPieces(const Problem &problem, const Options &options, const LongWork &longWork = {},
                    const Solution &before = {});

} // namespace fff::nest
