// How long a contour is along its curve, and where one is after so much of it.
#pragma once

#include "core/geometry/contour.h"

#include <vector>

namespace fff {

/// Arc length along a closed contour, counted from the start of its first segment in its direction,
/// mm. Exact to about 1e-9 of the length for curves without cusps: Gauss and Legendre's rule on
/// pieces of each segment, halved until they agree.
class ArcLength
{
public:
    explicit ArcLength(Contour contour);

    const Contour &contour() const { return m_contour; }
    double total() const { return m_starts.back(); }
    /// Length from the start to there.
    double of(const CurvePoint &place) const;
    /// Where one is after `length`, which is taken modulo the total.
    CurvePoint at(double length) const;
    /// Where one is after so much from there, backwards where it is negative. To the last bit it
    /// follows from what lies in between alone.
    CurvePoint after(const CurvePoint &from, double length) const;

private:
    Contour m_contour;
    std::vector<double> m_lengths; // of each segment
    std::vector<double> m_starts; // of each segment, then the total
};

/// Position on a contour, and the unit direction in which it runs there; at a corner, and where a
/// handle has no length, that of the curve just behind the place.
Vec2 positionAt(const Contour &contour, const CurvePoint &place);
Vec2 directionAt(const Contour &contour, const CurvePoint &place);

} // namespace fff
