#include "core/geometry/mapped_contour.h"

namespace fff {

Result<Contour> mapped(const Contour &contour, const Eigen::Matrix2d &matrix, const Vec2 &about)
{
    std::vector<Vec2> points;
    points.reserve(contour.points().size());
    for (const Vec2 &p : contour.points())
        points.push_back(about + matrix * (p - about));
    return Contour::fromPoints(std::move(points));
}

} // namespace fff
