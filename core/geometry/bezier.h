// One cubic Bézier segment in the plane. Parameters run from 0 to 1.
#pragma once

#include "core/geometry/vector.h"

#include <array>

namespace fff {

struct CubicBezier
{
    Vec2 p0, p1, p2, p3;

    /// A straight piece: handles at a third and two thirds.
    static CubicBezier line(const Vec2 &from, const Vec2 &to);

    Vec2 at(double t) const;
    Vec2 derivative(double t) const;
    Vec2 secondDerivative(double t) const;
    CubicBezier reversed() const { return {p3, p2, p1, p0}; }
    /// The piece between two parameters, by de Casteljau; t0 > t1 gives it reversed.
    CubicBezier piece(double t0, double t1) const;
    /// Largest distance of the handles from the chord is at most `tolerance` and they lie along it.
    bool isStraight(double tolerance) const;
    /// Number of equal parameter steps whose chords stay within `tolerance` of the curve
    /// (Wang's bound on the second differences). At least 1, at most kMaxChords.
    int chordCount(double tolerance) const;

    static constexpr int kMaxChords = 4096;
};

} // namespace fff
