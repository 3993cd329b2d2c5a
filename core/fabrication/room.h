// Where a box fits inside a part. Internal to fabrication.
#pragma once

#include "core/geometry/polygon.h"

#include <vector>

namespace fff {

/// The inside of a region, less the boxes taken so far.
class Room
{
public:
    explicit Room(Region region);

    /// Takes a box: nothing else goes there.
    void take(const Box2 &box);

    /// The factor by which a box of this half size about the point can grow before it meets the
    /// boundary or a taken box; below 1 it does not fit, 0 or less when the point is not inside.
    /// O(number of edges).
    double scaleAt(const Vec2 &center, const Vec2 &half) const;
    /// The point where that factor is largest, within 2 % or a twentieth of the box: the pole of
    /// inaccessibility for boxes of that shape. By halving squares, most promising first (as V.
    /// Agafonkin's polylabel, 2016, does for circles).
    Vec2 roomiest(const Vec2 &half) const;

private:
    struct Edge
    {
        Vec2 from, to;
    };

    Region m_region;
    std::vector<Edge> m_edges;
    std::vector<Box2> m_taken;
};

} // namespace fff
