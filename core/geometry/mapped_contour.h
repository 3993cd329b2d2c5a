// A contour elsewhere in its plane, turned, scaled, mirrored or stretched.
#pragma once

#include "core/geometry/contour.h"

namespace fff {

/// Each control point p as about + matrix (p − about), which maps the curves alike. Errors  as
/// Contour::fromPoints().
Result<Contour> mapped(const Contour &contour, const Eigen::Matrix2d &matrix, const Vec2 &about);

} // namespace fff
