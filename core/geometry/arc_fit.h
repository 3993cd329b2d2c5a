// Arcs in place of curves: what machines and DXF understand.
#pragma once

#include "core/geometry/arc_path.h"
#include "core/geometry/bezier.h"

#include <span>

namespace fff {

/// Largest distance of the arcs that are cut from the curves that they stand for, mm. A tool may
/// enter a part by 0.005, of which kerf and the grid of a file take some.
inline constexpr double kArcError = 0.003;

/// Appends edges and arcs that run along the curve from its start to its end, both of which they
/// keep to the last bit: one arc where one is enough, else two that meet in a common tangent and
/// have the curve's at its ends, else those of its halves.
///
/// tolerance  mm, above 0. Every point of the curve is within it of its arc, and every point of the
///            arcs within it of the curve. That is proven for each arc, not sampled: the squared
///            distance from its centre, and how fast the curve turns about that, are polynomials
///            that lie between their Bernstein coefficients.
/// A step is never without length: a curve whose ends are the same and that stays within the
/// tolerance of them gives none.
///
/// Source  K. M. Bolton 1975, Biarc curves, Computer-Aided Design 7(2); the bounds are ours.
void appendArcs(const CubicBezier &curve, double tolerance, std::vector<ArcStep> &steps);

/// Of a chain of curves; without steps of less than 1e-5 mm, which are rounding to whoever reads
/// them. isClosed  it ends where it starts
ArcPath arcsAlong(std::span<const CubicBezier> curves, bool isClosed, double tolerance = kArcError);

} // namespace fff
