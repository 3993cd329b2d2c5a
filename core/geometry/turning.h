// How a convex polygon can be turned so that its box is small or fits into another one. Turns are
// unit vectors (cos, sin): turned(p) is p turned counter-clockwise by that angle.
#pragma once

#include "core/geometry/contour.h"

#include <optional>

namespace fff {

/// Exact for the quarter turns (1, 0) and (0, 1).
inline Vec2 turned(const Vec2 &p, const Vec2 &turn)
{
    return {turn.x() * p.x() - turn.y() * p.y(), turn.y() * p.x() + turn.x() * p.y()};
}

/// Box of the turned polygon.
Box2 turnedBounds(const Polygon &polygon, const Vec2 &turn);
/// Of the turned curve, not of its control points.
Box2 turnedBounds(const Contour &contour, const Vec2 &turn);

struct Turns
{
    Vec2 smallest = Vec2::UnitX(); // of all turns the one whose box has the least area
    Vec2 lowest = Vec2::UnitX();   // of all turns the one whose box is lowest
};

/// The best turns of a polygon; boxes lie on their longer sides. Both have an edge of its hull
/// along an axis; none for what has no area. Source  H. Freeman, R. Shapira 1975, Determining the
/// minimum-area encasing rectangle; G.
///         Toussaint 1983, Solving geometric problems with the rotating calipers. O(n log n).
Turns findTurns(const Polygon &hull);

/// A turn of such a polygon whose box fits the room, if there is any.
///
/// Between the angles at which an edge lies along an axis, width and height of the box are those of
/// two fixed vectors, so each is c · cos(angle − phase): where both are small enough follows from
/// two arc cosines. Of all ranges of angles the middle of the widest, so that rounding does not
/// matter; a box that is larger than the room by less than kClipGrid fits it. O(n log n).
std::optional<Vec2> findFittingTurn(const Polygon &hull, const Vec2 &room);

} // namespace fff
