// Boundaries that are pushed out over a stretch of their way.
#pragma once

#include "core/geometry/contour.h"

namespace fff {

/// Where on a boundary, and how: pushed by all of `way` over `flat` mm along the boundary to both
/// sides of `middle`, and by less and less over another `blend` mm, until it is as it was.
struct Bulge
{
    CurvePoint middle;
    Vec2 way = Vec2::Zero(); // mm, frame coordinates
    double flat = 0.0;       // 0 or more
    double blend = 1.0;      // above 0
};

/// p(s) + b(s) · way, where b is 1 in the middle and goes to 0 as 3 u² − 2 u³: its slope is 0 at
/// both ends, so that what is smooth stays smooth, and corners stay corners. What lies beyond stays
/// bit for bit; lines stay lines in the middle and become cubics beside it, without error. A curve
/// beside it becomes cubics with its ends and tangents, one in each half of the blend. May cross
/// itself afterwards. Errors  BadValue where the bulge is longer than the boundary; as
/// Contour::fromSegments().
Result<Contour> bulged(const Contour &contour, const Bulge &bulge);

} // namespace fff
