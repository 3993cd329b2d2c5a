// A shape cut along the lines of a grid. Internal to operations.
#pragma once

#include "core/model/shape.h"

#include <vector>

namespace fff {

/// Lines at x = corner + i · size.x and y = corner + j · size.y.
struct CellGrid
{
    Vec2 corner = Vec2::Zero();
    Vec2 size = Vec2::Constant(200.0); // mm, > 0
    int columns = 1, rows = 1;

    double line(int axis, int index) const { return corner[axis] + index * size[axis]; }
};

struct GridCell
{
    int column = 0, row = 0, part = 0; // of the largest piece; part: of several in one cell
    Contour outer;
    std::vector<Contour> holes;
};

/// Where two cells touch: on a line of the grid, between two of its coordinates.
struct Seam
{
    int axis = 0;             // 0: the line is upright (x is constant), 1: level
    int index = 0;            // of the line
    int row = 0;              // along the line: of the cells
    int below = 0, above = 0; // cells on its sides, indices
    double from = 0.0, to = 0.0;

    double length() const { return to - from; }
};

struct GridCells
{
    std::vector<GridCell> cells; // by column, row and part
    std::vector<Seam> seams;     // by axis, line, row and place
};

/// sliver: share of a whole cell's area below which a piece goes to a neighbour. The cells' areas
/// sum up to the shape's. Errors  as clip() and windingRegions().
Result<GridCells> cutIntoCells(const Shape &shape, const CellGrid &grid, double sliver);

} // namespace fff
