// Where a path drawn on a section leaves it.
#pragma once

#include "core/model/shape.h"

#include <optional>

namespace fff {

/// The inside of a shape, prepared for following a path in it. Holes are outside.
class Interior
{
public:
    explicit Interior(ShapePointer shape);

    bool contains(const Vec2 &point) const;

    /// The first point at which the straight way from `from` (inside or on the boundary) to `to`
    /// leaves the shape, or nothing when it stays inside. On the curve itself to 1e-9 mm, also when
    /// the way jumps over a hole and ends inside again; `from` when that lies on the boundary and
    /// the way goes out. Frame coordinates, mm.
    std::optional<Vec2> leavingPoint(const Vec2 &from, const Vec2 &to) const;

private:
    ShapePointer m_shape;
    std::vector<Polyline> m_boundaries; // to kCutChord, the contour first; one a contour
};

} // namespace fff
