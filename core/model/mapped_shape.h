// A shape elsewhere in its plane: turned, scaled, mirrored or stretched, its holes with it.
#pragma once

#include "core/model/shape.h"

namespace fff {

struct Curves
{
    Contour contour;
    std::vector<Contour> holes;
};

/// The contour and holes, each point p as about + matrix (p − about). Errors  as mapped() of one.
Result<Curves> mapped(const Shape &shape, const Eigen::Matrix2d &matrix, const Vec2 &about);

/// The same as a shape; the very object for the identity. Errors also: EmptyContour where next to
/// nothing is left.
Result<ShapePointer> mapped(const ShapePointer &shape, const Eigen::Matrix2d &matrix,
                            const Vec2 &about);

} // namespace fff
