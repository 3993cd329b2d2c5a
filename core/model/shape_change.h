// Where the boundary of a shape is other than that of another one.
#pragma once

#include "core/model/shape.h"

#include <vector>

namespace fff {

/// Of the chords of both. What begins and ends with the same vertices differs in between only, as
/// where a control point was moved.
class ShapeChange
{
public:
    ShapeChange(const Shape &now, const Shape &before);

    /// Of all edges that only one of them has; all of both where they have not as many holes.
    const Box2 &box() const { return m_box; }
    /// Whether all these edges lie more than `half` (mm) beside the line, all on one side of it.
    bool isBeside(const Vec2 &point, const Vec2 &direction, double half) const;
    /// The number that an edge of both has now; ring: 0 the contour, 1 … the holes.
    int edgeNow(int ring, int edgeBefore) const;

private:
    struct OfRing
    {
        int tail = 0;  // from here on the edges before are in both
        int shift = 0; // by so much their numbers are higher now
    };
    void compare(const Polygon &now, const Polygon &before);

    std::vector<OfRing> m_rings;
    Box2 m_box;
};

} // namespace fff
