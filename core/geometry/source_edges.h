// Finds the source edges that the edges of a boolean's result lie on. Internal to geometry.
#pragma once

#include "core/geometry/curve_recovery.h"

#include <array>
#include <cstdint>
#include <optional>

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
    /// Calls `visit` with each vertex of the sources at this grid point, by ring, then index, until
    /// it says true. Whether it did.
    template <class Visit>
    bool anyCornerAt(const GridPoint &point, Visit visit) const
    {
        for (std::uint32_t i = m_first[hashOf(point) & (m_first.size() - 1)]; i != 0;
             i = m_next[i - 1]) {
            if (m_corners[i - 1].point == point && visit(m_corners[i - 1]))
                return true;
        }
        return false;
    }
    bool hasCornerAt(const GridPoint &point) const
    {
        return anyCornerAt(point, [](const Corner &) { return true; });
    }
    /// The source edge between two of its own ends, preferring the first ring.
    SourceEdge edgeBetween(const GridPoint &from, const GridPoint &to) const;
    /// The same where the edge before is known: mostly its neighbour, found without a search.
    SourceEdge edgeAfter(const SourceEdge &before, const GridPoint &from,
                         const GridPoint &to) const;

private:
    const std::vector<SourceRing> &m_sources;
    std::vector<Corner> m_corners; // by ring, then index
    // Of each hash value the first corner + 1, of each corner the next one + 1; 0 ends the chain.
    std::vector<std::uint32_t> m_first, m_next;
    std::vector<std::vector<char>> m_hasDouble; // of each ring's vertices: another is there, too
};

/// For every edge of every ring (by its start) the source edge it lies on, unknown where there is
/// none. O((sources + rings) log): edges between known corners are looked up, the ends of the
/// others swept along x.
std::vector<std::vector<SourceEdge>> findSourceEdges(const std::vector<SourceRing> &sources,
                                                     const SourceIndex &index,
                                                     const std::vector<GridRing> &rings);

} // namespace fff
