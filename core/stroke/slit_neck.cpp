#include "core/stroke/slit_neck.h"

#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fff {

namespace {

/// What fills this part of the slit was drawn over it.
constexpr double kSlitFilled = 0.25;
/// Of the contour's size, what stands beside the sheet at either side; in thicknesses of that, the
/// least and the most of it.
constexpr double kWallShare = 0.15, kLeastWall = 1.0, kMostWall = 2.0;

/// Stretches of the slit's line that lie in the polygon, ascending.
std::vector<std::pair<double, double>> stretchesOnLine(const Polygon &polygon)
{
    std::vector<double> crossings;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        if ((a.y() > 0.0) != (b.y() > 0.0))
            crossings.push_back(a.x() + (b.x() - a.x()) * (a.y() / (a.y() - b.y())));
    }
    std::sort(crossings.begin(), crossings.end());
    std::vector<std::pair<double, double>> stretches;
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
        stretches.emplace_back(crossings[i], crossings[i + 1]);
    return stretches;
}

Vec2 nearestOn(const Polygon &polygon, const Vec2 &to)
{
    Vec2 best = polygon.front();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 &a = polygon[i];
        const Vec2 way = polygon[(i + 1) % polygon.size()] - a;
        const double squared = way.squaredNorm();
        const double share =
            squared > 0.0 ? std::clamp((to - a).dot(way) / squared, 0.0, 1.0) : 0.0;
        const Vec2 place = a + share * way;
        if ((place - to).squaredNorm() < (best - to).squaredNorm())
            best = place;
    }
    return best;
}

/// The rectangle about the segment, so wide to both sides.
Contour strip(const Vec2 &from, const Vec2 &to, double half)
{
    const Vec2 way = (to - from).normalized();
    const Vec2 side = half * Vec2(-way.y(), way.x());
    return Contour::ofPolygon({from - side, to - side, to + side, from + side});
}

/// Where the neck ends in the contour: on the slit's line where that runs into it, else on the
/// shortest way to it.
std::optional<Vec2> goalIn(const Polygon &polygon,
                           const std::vector<std::pair<double, double>> &stretches,
                           const SlitToReach &slit, double depth)
{
    const Vec2 end(slit.length, 0.0);
    for (const auto &[from, to] : stretches)
        if (from - slit.length <= slit.farthest)
            return Vec2(std::max(from, slit.length) + std::min(depth, to - from), 0.0);
    const Vec2 nearest = nearestOn(polygon, end);
    const Vec2 way = nearest - end;
    if (way.norm() > slit.farthest || way.norm() <= kMinOverlap)
        return std::nullopt;
    return Vec2(nearest + depth * way.normalized());
}

bool isFilled(const std::vector<std::pair<double, double>> &stretches, double length)
{
    return std::any_of(stretches.begin(), stretches.end(), [length](const auto &stretch) {
        return stretch.first < (1.0 - kSlitFilled) * length;
    });
}

} // namespace

std::optional<Contour> withNeck(const Contour &contour, const SlitToReach &slit)
{
    const Polygon polygon = contour.polygon(kDrawChord);
    if (polygon.size() < 3 || !(slit.length > kMinOverlap))
        return std::nullopt;
    const std::vector<std::pair<double, double>> stretches = stretchesOnLine(polygon);
    if (isFilled(stretches, slit.length))
        return std::nullopt;
    const double extent = bounds(polygon).size().maxCoeff();
    const double half =
        0.5 * slit.thickness +
        std::clamp(kWallShare * extent, kLeastWall * slit.thickness, kMostWall * slit.thickness);
    const std::optional<Vec2> goal = goalIn(polygon, stretches, slit, half);
    if (!goal)
        return std::nullopt;
    const double depth =
        std::min({2.0 * slit.length, extent, slit.length + slit.behind + slit.thickness});
    const Vec2 end(slit.length, 0.0), top(slit.length - depth, 0.0);
    std::vector<Contour> parts{contour.signedArea() > 0.0 ? contour : contour.reversed()};
    if (goal->y() == 0.0) {
        parts.push_back(strip(top, *goal, half));
    } else { // round the corner at the slit's end
        parts.push_back(strip(top, end + Vec2(half, 0.0), half));
        parts.push_back(strip(end, *goal, half));
    }
    Result<std::vector<CurvedRegion>> regions =
        windingRegions(parts, WindingRule::NonZero, kCutChord);
    if (!regions || regions->size() != 1)
        return std::nullopt;
    return std::move(regions->front().outer);
}

} // namespace fff
