// The circle and the ellipse that points lie about.
#pragma once

#include "core/geometry/vector.h"

#include <optional>
#include <vector>

namespace fff {

/// An ellipse, and how far the line is from it.
struct RoundFit
{
    Vec2 centre = Vec2::Zero();
    double major = 0.0, minor = 0.0; // half axes, mm, major ≥ minor
    double turn = 0.0;               // of the major one, radians
    double mean = 0.0, most = 0.0;   // mm from it: root mean square, and the furthest

    double size() const { return std::sqrt(major * minor); }
};

/// loop: a closed line, n ≥ 5, the first point not repeated; each counts for the line it stands
/// for. None where no ellipse is near to it. Distances are those of first order (P. Sampson 1982),
/// good to a few per cent of themselves as long as they are small.
/// Source  R. Halir, J. Flusser 1998, Numerically stable direct least squares fitting of ellipses.
std::optional<RoundFit> fitEllipse(const std::vector<Vec2> &loop);
/// Source  V. Pratt 1987, Direct least-squares fitting of algebraic surfaces, with the weights of
///         I. Kåsa 1976: the whole circle is there, so that its bias is none.
std::optional<RoundFit> fitCircle(const std::vector<Vec2> &loop);

} // namespace fff
