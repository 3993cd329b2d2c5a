// Pure edits of the control points of a shape: of its contour and of its holes alike.
//
// What an edit makes is whole, or it is refused and the shape before stays: no boundary crosses
// itself, and every hole lies inside the contour and apart from the other holes. A hole that is
// pulled over the contour's edge is refused rather than made a notch: a person who drags a point of
// a hole wants another hole, and a notch could not be dragged back. Boundaries may touch where they
// touched before (files that have such holes stay editable).
//
// Errors of all  SelfCrossing  a boundary would cross itself
//                BoundariesMeet  a hole would meet the contour or another hole, or leave it
//                EmptyContour  nothing would be left
//                BadValue, NonFinite  a point beyond what a document may hold
// Indices in addresses are valid ones, or it is UnknownReference.
#pragma once

#include "core/geometry/contour_points.h"
#include "core/model/shape.h"

#include <compare>
#include <functional>
#include <span>
#include <vector>

namespace fff {

/// An anchor of a shape: which boundary (0 the contour, 1 … its holes) and which of its anchors.
struct PointAddress
{
    int boundary = 0;
    int index = 0;

    auto operator<=>(const PointAddress &) const = default;
};

int boundaryCount(const Shape &shape);
const Contour &boundary(const Shape &shape, int index);
bool isPoint(const Shape &shape, const PointAddress &address);
Vec2 position(const Shape &shape, const PointAddress &point);

/// The anchors at these very places (to the bit): an edit may turn a boundary round or cut it at
/// the ground, and its points then have other addresses. Those that are gone are left out.
std::vector<PointAddress> pointsAt(const Shape &shape, std::span<const Vec2> places);

Result<ShapePointer> movedPoints(const Shape &shape, std::span<const PointAddress> points,
                                 const Vec2 &by, bool breaks = false);
/// Edits anchors one after the other, each by itself.
Result<ShapePointer>
withEach(const Shape &shape, std::span<const PointAddress> points,
         const std::function<Result<Contour>(const Contour &, int index)> &edit);
/// To the bit.
Result<ShapePointer> movedPoint(const Shape &shape, const PointAddress &point, const Vec2 &to);
Result<ShapePointer> movedHandle(const Shape &shape, const PointAddress &point, HandleSide side,
                                 const Vec2 &to, bool breaks);
/// `at`: of that boundary, as nearestPlace gives it.
Result<ShapePointer> movedSegment(const Shape &shape, int boundary, const CurvePoint &at,
                                  const Vec2 &by, bool breaks);
Result<ShapePointer> insertedPoint(const Shape &shape, int boundary, const CurvePoint &at);
/// A hole with less than kFewestSegments left goes; of the contour that is refused: TooFewPoints.
Result<ShapePointer> withoutPoints(const Shape &shape, std::span<const PointAddress> points);
Result<ShapePointer> withKind(const Shape &shape, std::span<const PointAddress> points,
                              PointKind kind);
/// Another contour in place of a boundary.
Result<ShapePointer> withBoundary(const Shape &shape, int boundary, Contour contour);
Result<ShapePointer> withoutHoles(const Shape &shape);

} // namespace fff
