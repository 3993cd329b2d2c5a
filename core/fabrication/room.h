// Where a box fits inside a part. Internal to fabrication.
#pragma once

#include "core/geometry/box_runs.h"
#include "core/geometry/polygon.h"

#include <limits>
#include <optional>
#include <vector>

namespace fff {

/// The inside of a region, less the boxes taken so far.
class Room
{
public:
    explicit Room(const Region &region);

    /// Takes a box: nothing else goes there.
    void take(const Box2 &box);
    /// How many have been taken, and to give back all but the first so many.
    std::size_t takenCount() const { return m_taken.size(); }
    void giveBack(std::size_t count);

    /// Whether the box of this half size about the point lies inside, touching at most. Looks at
    /// what lies near it only.
    bool fits(const Vec2 &center, const Vec2 &half) const;
    /// The factor by which such a box can grow before it meets the boundary or a taken box; below 1
    /// it does not fit, 0 or less when the point is not inside.
    double scaleAt(const Vec2 &center, const Vec2 &half) const;
    /// The middle of a place for such a box, if one of a few rows has any: the middle row, then
    /// those at quarters and so on, and of each the widest gap.
    std::optional<Vec2> findInRows(const Vec2 &half) const;
    /// The point where that factor is largest, within 5 % or a tenth of the box: the pole of
    /// inaccessibility for boxes of that shape. By halving squares, most promising first (as V.
    /// Agafonkin's polylabel, 2016, does for circles).
    /// enough   a factor with which the search ends at once
    Vec2 roomiest(const Vec2 &half, double enough = std::numeric_limits<double>::infinity()) const;

private:
    struct Edge
    {
        Vec2 from, to;
    };

    struct Gap
    {
        double from, to;

        double width() const { return to - from; }
    };

    bool isInside(const Vec2 &point) const;
    std::vector<Gap> gapsInRow(double y, const Vec2 &half) const;
    double clearScale(const Vec2 &center, const Vec2 &toScale, double least,
                      std::size_t &nearest) const;

    std::vector<Edge> m_edges; // of all rings, which follow each other
    std::vector<std::size_t> m_ringStarts;
    BoxRuns m_edgeBoxes;
    std::vector<Box2> m_taken;
    BoxRuns m_takenBoxes;
    Box2 m_bounds;
};

} // namespace fff
