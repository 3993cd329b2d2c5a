// Finds the source edges that the edges of a boolean's result lie on. Internal to geometry.
#pragma once

#include "core/geometry/curve_recovery.h"

#include <array>
#include <optional>
#include <span>

namespace fff {

/// An edge of a source ring, run through forwards (+1) or backwards (-1).
struct SourceEdge
{
    int ring = -1;
    int edge = 0;
    int direction = 1;

    bool isKnown() const { return ring >= 0; }
};

/// Looks points of a result up among the sources.
class SourceIndex
{
public:
    explicit SourceIndex(const std::vector<SourceRing> &sources);

    struct Corner
    {
        GridPoint point;
        int ring = 0, index = 0;
    };
    /// The vertices of sources at this grid point, by ring.
    std::span<const Corner> cornersAt(const GridPoint &point) const;
    /// The source edge between two of its own ends, preferring the first ring.
    SourceEdge edgeBetween(const GridPoint &from, const GridPoint &to) const;

private:
    const std::vector<SourceRing> &m_sources;
    std::vector<Corner> m_corners; // sorted by point, then ring
};

/// For every edge of every ring (by its start) the source edge it lies on, unknown where there is
/// none. O((sources + rings) log): edges between known corners are looked up, the ends of the
/// others swept along x.
std::vector<std::vector<SourceEdge>> findSourceEdges(const std::vector<SourceRing> &sources,
                                                     const SourceIndex &index,
                                                     const std::vector<GridRing> &rings);

} // namespace fff
