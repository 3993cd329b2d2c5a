#include "core/model/mapped_shape.h"

#include "core/geometry/mapped_contour.h"

namespace fff {

Result<Curves> mapped(const Shape &shape, const Eigen::Matrix2d &matrix, const Vec2 &about)
{
    Curves curves;
    Result<Contour> contour = mapped(shape.contour(), matrix, about);
    if (!contour)
        return tl::unexpected(contour.error());
    curves.contour = *std::move(contour);
    for (const Contour &hole : shape.holes()) {
        Result<Contour> next = mapped(hole, matrix, about);
        if (!next)
            return tl::unexpected(next.error());
        curves.holes.push_back(*std::move(next));
    }
    return curves;
}

Result<ShapePointer> mapped(const ShapePointer &shape, const Eigen::Matrix2d &matrix,
                            const Vec2 &about)
{
    if (matrix == Eigen::Matrix2d::Identity())
        return shape;
    Result<Curves> curves = mapped(*shape, matrix, about);
    if (!curves)
        return tl::unexpected(curves.error());
    return Shape::make(std::move(curves->contour), std::move(curves->holes));
}

} // namespace fff
