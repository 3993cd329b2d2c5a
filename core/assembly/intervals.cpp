#include "core/assembly/intervals.h"

#include "core/base/tolerances.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>

namespace fff {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// The line's second point for the predicate: far enough that its rounding does not tilt the line
// over the size of a section, near enough that it adds no digits.
constexpr double kBaseLength = 1024.0; // mm

const Polygon &ringOf(const Region &region, int ring)
{
    return ring == 0 ? region.outer : region.holes[static_cast<std::size_t>(ring - 1)];
}

/// Sides (−1, 0, +1) of all vertices of a ring, exactly.
std::vector<signed char> sidesOf(const PlaneLine &line, const Polygon &ring, bool &hasZero)
{
    const Vec2 far = line.at(kBaseLength);
    const Kernel::Point_2 a(line.point.x(), line.point.y()), b(far.x(), far.y());
    std::vector<signed char> sides;
    sides.reserve(ring.size());
    for (const Vec2 &p : ring) {
        const int side = CGAL::orientation(a, b, Kernel::Point_2(p.x(), p.y()));
        hasZero |= side == 0;
        sides.push_back(static_cast<signed char>(side));
    }
    return sides;
}

/// Crossings of one ring when vertices on the line count as on the side `zero`.
void addCrossings(const PlaneLine &line, const Polygon &ring, int ringIndex,
                  const std::vector<signed char> &sides, int zero, std::vector<AxisEnd> &crossings)
{
    const auto isLeft = [&](std::size_t i) { return (sides[i] == 0 ? zero : sides[i]) > 0; };
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::size_t j = (i + 1) % ring.size();
        if (isLeft(i) == isLeft(j))
            continue;
        const double di = std::abs(line.across(ring[i])), dj = std::abs(line.across(ring[j]));
        const double u = di + dj > 0.0 ? di / (di + dj) : 0.0;
        const double at = (1.0 - u) * line.along(ring[i]) + u * line.along(ring[j]);
        crossings.push_back({at, ringIndex, static_cast<int>(i)});
    }
}

std::vector<Interval> paired(std::vector<AxisEnd> crossings)
{
    std::sort(crossings.begin(), crossings.end(),
              [](const AxisEnd &a, const AxisEnd &b) { return a.at < b.at; });
    std::vector<Interval> intervals;
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
        // A gap below the grid of the booleans is none: a corner that just touches the line.
        if (!intervals.empty() && crossings[i].at - intervals.back().to.at <= kClipGrid)
            intervals.back().to = crossings[i + 1];
        else
            intervals.push_back({crossings[i], crossings[i + 1]});
    }
    std::erase_if(intervals, [](const Interval &i) { return i.length() <= kClipGrid; });
    return intervals;
}

/// What lies in both lists.
std::vector<Interval> intersected(const std::vector<Interval> &a, const std::vector<Interval> &b)
{
    std::vector<Interval> result;
    for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
        const AxisEnd &from = a[i].from.at >= b[j].from.at ? a[i].from : b[j].from;
        const AxisEnd &to = a[i].to.at <= b[j].to.at ? a[i].to : b[j].to;
        if (to.at - from.at > kClipGrid) {
            if (!result.empty() && from.at - result.back().to.at <= kClipGrid)
                result.back().to = to;
            else
                result.push_back({from, to});
        }
        (a[i].to.at < b[j].to.at) ? ++i : ++j;
    }
    return result;
}

/// The reach of the boundary from a crossing on, one way round the ring.
double reachOfWalk(const PlaneLine &line, const Polygon &ring, int start, int step,
                   double halfWidth, double floor, int sign)
{
    const int n = static_cast<int>(ring.size());
    const auto along = [&](const Vec2 &p) { return sign * line.along(p); };
    // The crossing lies on edge start → start + 1; walking forwards the next vertex is start + 1.
    int previous = step > 0 ? start : (start + 1) % n;
    int next = step > 0 ? (start + 1) % n : start;
    double reach = -std::numeric_limits<double>::infinity();
    for (int count = 0; count < n; ++count) {
        const double across = line.across(ring[next]);
        if (std::abs(across) > halfWidth) {
            // Where the edge leaves the strip.
            const double before = line.across(ring[previous]);
            const double limit = across > 0.0 ? halfWidth : -halfWidth;
            const double u = std::clamp((limit - before) / (across - before), 0.0, 1.0);
            const double s = (1.0 - u) * along(ring[previous]) + u * along(ring[next]);
            return std::max(reach, s);
        }
        reach = std::max(reach, along(ring[next]));
        if (along(ring[next]) < floor)
            return reach;
        previous = next;
        next = (next + step + n) % n;
    }
    return reach;
}

} // namespace

std::optional<Axis> intersectionAxis(const Frame &a, const Frame &b)
{
    const Vec3 na = a.normal(), nb = b.normal();
    const Vec3 direction = na.cross(nb);
    const double sine = direction.norm();
    if (sine < std::sin(kMinJointAngle))
        return std::nullopt;
    // p = c + α na + β nb with na·p = na·a.origin and nb·p = nb·b.origin.
    const Vec3 c = 0.5 * (a.origin + b.origin);
    const double cosine = na.dot(nb);
    const double ra = na.dot(a.origin - c), rb = nb.dot(b.origin - c);
    const double determinant = sine * sine;
    const double alpha = (ra - cosine * rb) / determinant;
    const double beta = (rb - cosine * ra) / determinant;
    return Axis{c + alpha * na + beta * nb, direction / sine};
}

PlaneLine lineInFrame(const Axis &axis, const Frame &frame)
{
    return {frame.toLocal(axis.point), frame.directionToLocal(axis.direction)};
}

std::vector<Interval> intervalsOn(const PlaneLine &line, const Region &region)
{
    const int rings = 1 + static_cast<int>(region.holes.size());
    bool hasZero = false;
    std::vector<std::vector<signed char>> sides;
    for (int r = 0; r < rings; ++r)
        sides.push_back(sidesOf(line, ringOf(region, r), hasZero));
    const auto insideWhenZeroIs = [&](int zero) {
        std::vector<AxisEnd> crossings;
        for (int r = 0; r < rings; ++r)
            addCrossings(line, ringOf(region, r), r, sides[r], zero, crossings);
        return paired(std::move(crossings));
    };
    if (!hasZero)
        return insideWhenZeroIs(1);
    return intersected(insideWhenZeroIs(1), insideWhenZeroIs(-1));
}

double mouthReach(const PlaneLine &line, const Region &region, const AxisEnd &end, double halfWidth,
                  double floor, int sign)
{
    const Polygon &ring = ringOf(region, end.ring);
    double reach = sign * end.at;
    for (const int step : {1, -1})
        reach = std::max(reach, reachOfWalk(line, ring, end.edge, step, halfWidth, floor, sign));
    return reach;
}

} // namespace fff
