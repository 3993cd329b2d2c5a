// Area, centroid and second moments of what contours enclose, exactly for the Béziers.
#pragma once

#include "core/geometry/contour.h"

namespace fff {

/// Integrals over the region: ∫1, ∫x, ∫y, ∫x², ∫xy, ∫y² about the frame's origin (mm², mm³, mm⁴).
struct Moments
{
    double area = 0.0;
    Vec2 first = Vec2::Zero();
    double xx = 0.0, xy = 0.0, yy = 0.0;

    Vec2 centroid() const { return first / area; }
    Moments &operator+=(const Moments &other);
};

/// Of the region that the contour encloses, negative when clockwise, so that contour and holes are
/// simply summed. Green's theorem with a Gauss rule that is exact for these polynomials.
Moments moments(const Contour &contour);

} // namespace fff
