// Contours that repeat round a point.
#pragma once

#include "core/geometry/contour.h"

namespace fff {

enum class ToothShape { Round, Square, Trapezium };

/// All: radii in mm, above 0; phase in radians, counter-clockwise, where a tooth's middle, or a
/// tip, is; counter-clockwise. count: at least 2 (a star and a gear: 3).

/// Four arcs of cubics, off a true circle by 0.03 % of the radius.
Contour circleContour(const Vec2 &centre, double radius);
Contour starContour(const Vec2 &centre, double outer, double inner, int count, double phase);
/// Teeth from `inner` (the root of the gaps) to `outer` (their tops), as wide as the gaps: with
/// radial flanks, with tops of half their feet's width, or as a smooth wave. Tops and gaps of the
/// first two are arcs.
Contour gearContour(const Vec2 &centre, double outer, double inner, int count, double phase,
                    ToothShape tooth);
/// Circles between both radii, side by side where there is room, touching nothing: no wider than
/// 0.8 of their share of the ring.
std::vector<Contour> ringOfCircles(const Vec2 &centre, double outer, double inner, int count,
                                   double phase);

} // namespace fff
