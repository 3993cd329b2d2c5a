// Where two curves cross, given that their chords do. Internal to geometry.
#pragma once

#include "core/geometry/bezier.h"

#include <optional>
#include <vector>

namespace fff {

/// A curve between two of its parameters, from < to.
struct CurveRange
{
    CubicBezier curve;
    double from = 0.0, to = 1.0;
};

struct CurveCrossing
{
    double a = 0.0, b = 0.0; // parameters, in their ranges
    Vec2 point = Vec2::Zero();
};

/// Parameters 0 < t < 1 at which the curve runs at a right angle to the normal (not zero), in
/// order: between them its height over a line with that normal only rises or only falls.
std::vector<double> levelParameters(const CubicBezier &curve, const Vec2 &normal);

/// The parameter in the range at which the curve crosses the line through `point` with this normal
/// (not zero). When both ends lie on one side: the nearer end if within `slack` mm, else nothing.
std::optional<double> crossLine(const CurveRange &range, const Vec2 &point, const Vec2 &normal,
                                double slack);

/// The common point of both, to about 1e-12 of their size. `near` is that of the chords (mm). A
/// curve against a line: by bracketed Newton steps on the distance, as the ends of the range lie on
/// either side of the line; two curves: by Newton's method in both parameters. Nothing when they
/// run parallel there or the steps lead out of the ranges.
std::optional<CurveCrossing> crossNear(const CurveRange &a, const CurveRange &b, const Vec2 &near);

} // namespace fff
