// The first places: each shape as far to the left as it goes. Internal to nesting.
#pragma once

#include "core/nesting/board.h"
#include "core/nesting/meter.h"

#include <vector>

namespace fff::nest {

struct Filling
{
    std::size_t turns = 100; // that are tried at most, the last ones of a shape
    int rows = 24;           // heights that are tried, of each turn
    int settling = 3;        // times that it slides down and to the left where it came to lie
};

/// How far right each row of each turn is known to have no place for a shape, as that comes to lie
/// there: for all of one outline, while the sheet only gets fuller.
struct RowStarts
{
    std::vector<double> at; // by turn and row; empty at first
};

/// The place on the sheet where the shape's right end comes least far, of some rows and all of its
/// turns; holes of others and rooms between them are places as well. None: it has no room.
std::optional<Pose> leftmost(const Board &board, const Shape &shape, std::size_t sheet,
                             const Filling &filling, RowStarts &starts, Meter &meter);

/// Slides everything on the sheet to the left, the leftmost first, as far as it goes.
void slideLeft(Board &board, std::size_t sheet, Meter &meter);

} // namespace fff::nest
