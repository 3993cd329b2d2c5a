#include "core/stroke/slit_neck.h"

#include "core/assembly/intervals.h"
#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/geometry/segment_distance.h"

#include <algorithm>
#include <vector>

namespace fff {

namespace {

/// What fills this part of the slit was drawn over it.
constexpr double kSlitFilled = 0.25;
/// Of the contour's size, what stands beside the sheet at either side; in thicknesses of that, the
/// least and the most of it.
constexpr double kWallShare = 0.15, kLeastWall = 1.0, kMostWall = 2.0;

/// Of the slit's line, inside the contour, in their order.
using Stretches = std::vector<Interval>;

Vec2 nearestOn(const Polygon &polygon, const Vec2 &to)
{
    Vec2 best = polygon.front();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 place = nearestOfSegment(to, polygon[i], polygon[(i + 1) % polygon.size()]);
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
std::optional<Vec2> goalIn(const Polygon &polygon, const Stretches &stretches,
                           const SlitToReach &slit, double depth)
{
    const Vec2 end(slit.length, 0.0);
    for (const Interval &stretch : stretches)
        if (stretch.from.at - slit.length <= slit.farthest)
            return Vec2(std::max(stretch.from.at, slit.length) + std::min(depth, stretch.length()),
                        0.0);
    const Vec2 nearest = nearestOn(polygon, end);
    const Vec2 way = nearest - end;
    if (way.norm() > slit.farthest || way.norm() <= kMinOverlap)
        return std::nullopt;
    return Vec2(nearest + depth * way.normalized());
}

bool isFilled(const Stretches &stretches, double length)
{
    return std::any_of(stretches.begin(), stretches.end(), [length](const Interval &stretch) {
        return stretch.from.at < (1.0 - kSlitFilled) * length;
    });
}

/// Nothing of it is in the section that the slit is in.
bool isApart(const Stretches &stretches, const SlitToReach &slit)
{
    return std::none_of(stretches.begin(), stretches.end(), [&slit](const Interval &stretch) {
        return std::max(stretch.from.at, -slit.behind) + kMinOverlap <
               std::min(stretch.to.at, slit.length);
    });
}

std::optional<Contour> withNeckTo(const Vec2 &goal, const Contour &contour, double extent,
                                  double half, const SlitToReach &slit)
{
    const double depth =
        std::min({2.0 * slit.length, extent, slit.length + slit.behind + slit.thickness});
    const Vec2 end(slit.length, 0.0), top(slit.length - depth, 0.0);
    std::vector<Contour> parts{contour.signedArea() > 0.0 ? contour : contour.reversed()};
    if (goal.y() == 0.0) {
        parts.push_back(strip(top, goal, half));
    } else { // round the corner at the slit's end
        parts.push_back(strip(top, end + Vec2(half, 0.0), half));
        parts.push_back(strip(end, goal, half));
    }
    Result<std::vector<CurvedRegion>> regions =
        windingRegions(parts, WindingRule::NonZero, kCutChord);
    if (!regions || regions->size() != 1)
        return std::nullopt;
    return std::move(regions->front().outer);
}

} // namespace

SlitReach reached(const Contour &contour, const SlitToReach &slit)
{
    const Region region{contour.polygon(kDrawChord), {}};
    const Polygon &polygon = region.outer;
    if (polygon.size() < 3 || !(slit.length > kMinOverlap))
        return {};
    const Stretches stretches = intervalsOn(PlaneLine(), region);
    if (isFilled(stretches, slit.length))
        return {std::nullopt, isApart(stretches, slit)};
    const double extent = bounds(polygon).size().maxCoeff();
    const double half =
        0.5 * slit.thickness +
        std::clamp(kWallShare * extent, kLeastWall * slit.thickness, kMostWall * slit.thickness);
    SlitReach reach;
    if (const std::optional<Vec2> goal = goalIn(polygon, stretches, slit, half))
        reach.withNeck = withNeckTo(*goal, contour, extent, half, slit);
    reach.isApart = !reach.withNeck && isApart(stretches, slit);
    return reach;
}

std::optional<Contour> withNeck(const Contour &contour, const SlitToReach &slit)
{
    return reached(contour, slit).withNeck;
}

} // namespace fff
