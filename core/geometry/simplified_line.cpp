#include "core/geometry/simplified_line.h"

#include <cmath>

namespace fff {

std::vector<std::size_t> simplified(const std::vector<Vec2> &points, double error)
{
    std::vector<std::size_t> vertices{0};
    std::size_t anchor = 0;
    while (anchor + 1 < points.size()) {
        Vec2 left = Vec2::Zero(), right = Vec2::Zero(); // borders of the cone, once there is one
        bool hasCone = false;
        double furthest = 0.0;
        std::size_t best = anchor + 1, furthestAt = anchor + 1;
        std::size_t i = anchor + 1;
        for (; i < points.size(); ++i) {
            const Vec2 way = points[i] - points[anchor];
            const double distance = way.norm();
            if (distance > furthest) {
                furthest = distance;
                furthestAt = i;
            } else if (distance < furthest - 2.0 * error) {
                best = furthestAt; // it goes back
                break;
            }
            if (hasCone && (cross(right, way) < 0.0 || cross(way, left) < 0.0))
                break;
            best = i;
            if (distance <= error)
                continue;
            const double sine = error / distance, cosine = std::sqrt(1.0 - sine * sine);
            const Vec2 across = perpendicular(way);
            const Vec2 l = cosine * way + sine * across, r = cosine * way - sine * across;
            if (!hasCone || cross(l, left) > 0.0)
                left = l;
            if (!hasCone || cross(right, r) > 0.0)
                right = r;
            hasCone = true;
        }
        if (i == points.size()) {
            const bool isBack = (points.back() - points[anchor]).norm() < furthest - error;
            best = isBack ? furthestAt : points.size() - 1;
        }
        anchor = best;
        vertices.push_back(anchor);
    }
    return vertices;
}

} // namespace fff
