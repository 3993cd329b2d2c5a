#include "core/assembly/intervals.h"

#include "core/assembly/rings_near.h"
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

/// On which side of a line points lie, exactly. In floating point where that is certain, which is
/// nearly everywhere.
class LineSide
{
public:
    explicit LineSide(const PlaneLine &line) : m_from(line.point), m_to(line.at(kBaseLength)) {}

    int operator()(const Vec2 &p) const
    {
        // J. R. Shewchuk, Adaptive precision floating-point arithmetic, 1997: the first filter.
        constexpr double kError = 3.4e-16;
        const double left = (m_to.x() - m_from.x()) * (p.y() - m_from.y());
        const double right = (m_to.y() - m_from.y()) * (p.x() - m_from.x());
        const double difference = left - right;
        if (std::abs(difference) > kError * (std::abs(left) + std::abs(right)))
            return difference > 0.0 ? 1 : -1;
        return CGAL::orientation(Kernel::Point_2(m_from.x(), m_from.y()),
                                 Kernel::Point_2(m_to.x(), m_to.y()),
                                 Kernel::Point_2(p.x(), p.y()));
    }

private:
    Vec2 m_from, m_to;
};

/// Sides (−1, 0, +1) of all vertices of a ring.
std::vector<signed char> sidesOf(const PlaneLine &line, const Polygon &ring)
{
    const LineSide side(line);
    std::vector<signed char> sides;
    sides.reserve(ring.size());
    for (const Vec2 &p : ring)
        sides.push_back(static_cast<signed char>(side(p)));
    return sides;
}

/// Where the edge from a to b crosses the line, which its ends lie to both sides of.
double crossingAlong(const PlaneLine &line, const Vec2 &a, const Vec2 &b)
{
    const double di = std::abs(line.across(a)), dj = std::abs(line.across(b));
    const double u = di + dj > 0.0 ? di / (di + dj) : 0.0;
    return (1.0 - u) * line.along(a) + u * line.along(b);
}

/// Crossings of one ring, or false when a vertex lies on the line.
bool addPlainCrossings(const PlaneLine &line, const LineSide &side, const Polygon &ring,
                       int ringIndex, std::vector<AxisEnd> &crossings)
{
    if (ring.empty())
        return true;
    const int first = side(ring.front());
    int here = first;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const bool isLast = i + 1 == ring.size();
        const Vec2 &next = ring[isLast ? 0 : i + 1];
        const int there = isLast ? first : side(next);
        if (here == 0)
            return false;
        if (here * there < 0)
            crossings.push_back(
                {crossingAlong(line, ring[i], next), ringIndex, static_cast<int>(i)});
        here = there;
    }
    return true;
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
        crossings.push_back(
            {crossingAlong(line, ring[i], ring[j]), ringIndex, static_cast<int>(i)});
    }
}

void pairUp(std::vector<AxisEnd> &crossings, std::vector<Interval> &intervals)
{
    std::sort(crossings.begin(), crossings.end(),
              [](const AxisEnd &a, const AxisEnd &b) { return a.at < b.at; });
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
        // A gap below the grid of the booleans is none: a corner that just touches the line.
        if (!intervals.empty() && crossings[i].at - intervals.back().to.at <= kClipGrid)
            intervals.back().to = crossings[i + 1];
        else
            intervals.push_back({crossings[i], crossings[i + 1]});
    }
    std::erase_if(intervals, [](const Interval &i) { return i.length() <= kClipGrid; });
}

std::vector<Interval> paired(std::vector<AxisEnd> crossings)
{
    std::vector<Interval> intervals;
    intervals.reserve(crossings.size() / 2);
    pairUp(crossings, intervals);
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

/// The least share of the way from p to q at which p + share · (q − p) is `distance` from the
/// origin or to the left of the line through (−distance, 0) at 45°; above 1 when it is none.
double chamferShare(const Vec2 &p, const Vec2 &q, double distance)
{
    constexpr double kNever = 2.0;
    const auto beyond = [&](const Vec2 &v) { return v.y() - v.x() - distance; };
    double share = kNever;
    if (beyond(q) >= 0.0)
        share = beyond(p) < 0.0 ? beyond(p) / (beyond(p) - beyond(q)) : 0.0;
    if (q.norm() < distance)
        return share;
    const Vec2 way = q - p;
    const double a = way.squaredNorm(), b = p.dot(way), c = p.squaredNorm() - distance * distance;
    const double root = std::sqrt(std::max(0.0, b * b - a * c));
    return std::min(share, a > 0.0 ? std::clamp((root - b) / a, 0.0, 1.0) : 0.0);
}

/// Follows the boundary one way round the ring out of the strip and to the chamfer's end. Which
/// side it leaves on: 0 left, 1 right; −1 when it does not.
int walkToChamfer(const PlaneLine &line, const Polygon &ring, int start, int step, double halfWidth,
                  double floor, int sign, double chamfer, WallEnd &wall)
{
    const int n = static_cast<int>(ring.size());
    int previous = step > 0 ? start : (start + 1) % n;
    int next = step > 0 ? (start + 1) % n : start;
    int side = 0; // of the line: +1 left
    // As (outwards along the slit, outwards from the wall).
    const auto fromWall = [&](const Vec2 &p) {
        return Vec2(sign * line.along(p) - wall.at, side * line.across(p) - halfWidth);
    };
    wall.reach = -std::numeric_limits<double>::infinity();
    for (int count = 0; count < n; ++count) {
        const Vec2 &from = ring[static_cast<std::size_t>(previous)];
        const Vec2 &to = ring[static_cast<std::size_t>(next)];
        Vec2 begin = from;
        const double across = line.across(to);
        if (side == 0 && std::abs(across) > halfWidth) {
            side = across > 0.0 ? 1 : -1;
            const double before = line.across(from);
            const double u = std::clamp((side * halfWidth - before) / (across - before), 0.0, 1.0);
            begin = from + u * (to - from);
            wall.at = sign * line.along(begin);
            wall.reach = std::max(wall.reach, wall.at);
        }
        if (side != 0) {
            const Vec2 p = fromWall(begin), q = fromWall(to);
            const double share = chamferShare(p, q, chamfer);
            if (share <= 1.0) {
                const Vec2 last = p + share * (q - p);
                wall.chamferEnd = {wall.at + last.x(), std::max(last.y(), 0.0)};
                wall.reach = std::max(wall.reach, wall.chamferEnd.x());
                wall.isThere = true;
                return side > 0 ? 0 : 1;
            }
        }
        const double along = sign * line.along(to);
        wall.reach = std::max(wall.reach, along);
        if (side == 0 && along < floor)
            return -1;
        previous = next;
        next = (next + step + n) % n;
    }
    return -1;
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
    std::vector<AxisEnd> plain;
    plain.reserve(4);
    const LineSide side(line);
    bool isPlain = true;
    for (int r = 0; r < rings && isPlain; ++r)
        isPlain = addPlainCrossings(line, side, ringOf(region, r), r, plain);
    if (isPlain)
        return plain.empty() ? std::vector<Interval>() : paired(std::move(plain));

    std::vector<std::vector<signed char>> sides;
    for (int r = 0; r < rings; ++r)
        sides.push_back(sidesOf(line, ringOf(region, r)));
    const auto insideWhenZeroIs = [&](int zero) {
        std::vector<AxisEnd> crossings;
        for (int r = 0; r < rings; ++r)
            addCrossings(line, ringOf(region, r), r, sides[r], zero, crossings);
        return paired(std::move(crossings));
    };
    return intersected(insideWhenZeroIs(1), insideWhenZeroIs(-1));
}

std::vector<Interval> intervalsOn(const PlaneLine &line, const Shape &shape)
{
    const RingsNear rings(line, shape, 0.0);
    std::vector<Interval> intervals = intervalsOn(line, rings.region());
    for (Interval &interval : intervals)
        for (AxisEnd *end : {&interval.from, &interval.to})
            *end = rings.inShape(*end);
    return intervals;
}

std::optional<std::span<const Interval>>
intervalsOn(const PlaneLine &line, std::span<const LineEdge> edges, IntervalMemory &memory)
{
    memory.crossings.clear();
    memory.intervals.clear();
    const LineSide side(line);
    for (const LineEdge &edge : edges) {
        const int from = side(edge.from), to = side(edge.to);
        if (from == 0 || to == 0)
            return {};
        if (from != to)
            memory.crossings.push_back({crossingAlong(line, edge.from, edge.to)});
    }
    pairUp(memory.crossings, memory.intervals);
    return memory.intervals;
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

std::array<WallEnd, 2> wallEnds(const PlaneLine &line, const Region &region, const AxisEnd &end,
                                double halfWidth, double floor, int sign, double chamfer)
{
    std::array<WallEnd, 2> walls;
    for (const int step : {1, -1}) {
        WallEnd wall;
        const int side = walkToChamfer(line, ringOf(region, end.ring), end.edge, step, halfWidth,
                                       floor, sign, chamfer, wall);
        if (side >= 0 && !walls[static_cast<std::size_t>(side)].isThere)
            walls[static_cast<std::size_t>(side)] = wall;
    }
    return walls;
}

} // namespace fff
