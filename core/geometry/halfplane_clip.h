// What of a contour with its holes lies on one side of a line. Curves stay curves: they are cut
// where they cross the line, by de Casteljau's construction.
#pragma once

#include "core/geometry/contour.h"

#include <vector>

namespace fff {

/// All points p with inward · (p − point) ≥ 0.
struct Halfplane
{
    Vec2 point = Vec2::Zero();   // on its line, mm
    Vec2 inward = Vec2::UnitY(); // unit, at a right angle to the line

    /// Distance from the line, positive inside. mm.
    double height(const Vec2 &p) const { return inward.dot(p - point); }
    /// Along the line, the inside to the left. Unit.
    Vec2 along() const { return {inward.y(), -inward.x()}; }
};

/// A connected piece: outer counter-clockwise, holes clockwise.
struct ClippedPiece
{
    Contour outer;
    std::vector<Contour> holes;
};

/// What is left of the contour without its holes in the halfplane, as connected pieces, largest
/// first; pieces below kMinArea are left out.
///
/// contour   any winding; must not cross itself (resolveCrossings mends that), may touch itself
/// holes     any winding; in the contour, not crossing it nor each other
/// Result    Where nothing lies beyond the line by more than kOnLine, the contour and all holes as
///           they are, bit for bit, winding and all. Else all winding is as ClippedPiece says, new
///           edges are straight, their ends lie on the line to kOnLine, and nothing reaches further
///           beyond it. Empty when nothing is left.
/// Edges that lie in the line bound a piece only where the inside is on their inner side.
/// Errors    as subtract(), which is asked where boundaries touch in the line.
/// O(n log n) of the segments; without a cut one pass over the control points.
Result<std::vector<ClippedPiece>> clip(const Contour &contour, const std::vector<Contour> &holes,
                                       const Halfplane &halfplane);

/// Whether clip() would leave it as it is.
bool isInside(const Contour &contour, const Halfplane &halfplane);

} // namespace fff
