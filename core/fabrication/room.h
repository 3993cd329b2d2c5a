// Where a box fits inside a part. Internal to fabrication.
#pragma once

#include "core/geometry/polygon.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace fff {

/// The inside of a region, less the boxes taken so far.
class Room
{
public:
    explicit Room(Region region);

    /// Takes a box: nothing else goes there.
    void take(const Box2 &box);

    /// Whether the box of this half size about the point lies inside, touching at most. Looks at
    /// what lies near it only.
    bool fits(const Vec2 &center, const Vec2 &half) const;
    /// The factor by which such a box can grow before it meets the boundary or a taken box; below 1
    /// it does not fit, 0 or less when the point is not inside. O(number of edges).
    double scaleAt(const Vec2 &center, const Vec2 &half) const;
    /// The point where that factor is largest, within 5 % or a tenth of the box: the pole of
    /// inaccessibility for boxes of that shape. By halving squares, most promising first (as V.
    /// Agafonkin's polylabel, 2016, does for circles); a square looks only at the edges that can be
    /// the nearest somewhere in it.
    /// enough   a factor with which the search ends at once
    Vec2 roomiest(const Vec2 &half, double enough = std::numeric_limits<double>::infinity()) const;

private:
    struct Edge
    {
        Vec2 from, to;
    };
    /// Cells of a grid that a box reaches into: columns and rows, ends included.
    struct Cells
    {
        int left, right, bottom, top;
    };

    Cells cellsOf(const Box2 &box) const;
    std::size_t cellAt(int column, int row) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(m_columns) +
               static_cast<std::size_t>(column);
    }
    void sortIntoCells();
    bool isInside(const Vec2 &point) const;

    Region m_region;
    std::vector<Edge> m_edges;
    std::vector<Box2> m_taken;
    Box2 m_bounds;

    // A grid over the bounds with about as many cells as there are edges.
    double m_cell = 1.0; // mm
    int m_columns = 1, m_rows = 1;
    // Edges of cell i: m_inCell[m_cellStart[i]] … up to those of cell i + 1; of rows alike.
    std::vector<std::uint32_t> m_cellStart, m_inCell, m_rowStart, m_inRow;
    std::vector<std::vector<std::uint32_t>> m_takenInCell;
};

} // namespace fff
