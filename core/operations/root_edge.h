// The place of a root's boundary at which a section leaves it. Internal to operations.
#pragma once

#include "core/geometry/contour.h"
#include "core/operations/source_crossing.h"

namespace fff {

struct RootEdge
{
    int ring = 0; // 0: the contour, 1 …: its holes
    CurvePoint at;
    Vec2 point = Vec2::Zero(), tangent = Vec2::UnitX(); // there, in the root's coordinates
    Vec2 outwards = Vec2::UnitY();                      // along the axis, away from the root, unit
};

/// Of a boundary of the root.
const Contour &boundaryOf(const Section &root, int ring);

/// Whether it is the upper end, along the axis, of the root's interval: that at which the section
/// reaches further out.
bool leavesHigh(const SourceCrossing &source);

RootEdge edgeOf(const Section &root, const SourceCrossing &source, bool isHigh);

} // namespace fff
