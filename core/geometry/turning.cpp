#include "core/geometry/turning.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>

namespace fff {

namespace {

constexpr double kQuarter = 0.5 * std::numbers::pi;

Vec2 direction(double angle)
{
    return {std::cos(angle), std::sin(angle)};
}

/// Angles in a quarter turn at which an edge lies along an axis, ascending, with both ends.
std::vector<double> eventAngles(const Polygon &hull)
{
    std::vector<double> angles{0.0, kQuarter};
    for (std::size_t i = 0, j = hull.size() - 1; i < hull.size(); j = i++) {
        const Vec2 edge = hull[i] - hull[j];
        double angle = std::fmod(std::atan2(edge.y(), edge.x()), kQuarter);
        if (angle < 0.0)
            angle += kQuarter;
        angles.push_back(angle);
    }
    std::sort(angles.begin(), angles.end());
    return angles;
}

/// The corners that reach farthest in four directions, followed while these turn.
class Calipers
{
public:
    explicit Calipers(const Polygon &hull) : m_hull(hull) {}

    /// The first direction, of any length and turning counter-clockwise from call to call.
    void turnTo(Vec2 d)
    {
        for (std::size_t k = 0; k < 4; ++k, d = perpendicular(d)) {
            std::size_t &at = m_at[k];
            if (m_isFirst) {
                for (std::size_t i = 1; i < m_hull.size(); ++i)
                    if (d.dot(m_hull[i]) > d.dot(m_hull[at]))
                        at = i;
            }
            while (d.dot(m_hull[next(at)]) > d.dot(m_hull[at]))
                at = next(at);
        }
        m_isFirst = false;
    }
    Vec2 along() const { return m_hull[m_at[0]] - m_hull[m_at[2]]; }
    Vec2 across() const { return m_hull[m_at[1]] - m_hull[m_at[3]]; }

private:
    std::size_t next(std::size_t i) const { return i + 1 == m_hull.size() ? 0 : i + 1; }

    const Polygon &m_hull;
    std::array<std::size_t, 4> m_at{};
    bool m_isFirst = true;
};

/// The box of a convex polygon that turns from one of its edges to the next, for a quarter turn:
/// then every edge has lain along one of the box's sides.
class TurningBox
{
public:
    explicit TurningBox(const Polygon &hull) : m_hull(hull)
    {
        // Below, to the right, above, to the left; of two that reach as far the one that is left
        // last when going counter-clockwise.
        Vec2 outwards(0.0, -1.0);
        for (std::size_t side = 0; side < 4; ++side, outwards = perpendicular(outwards)) {
            std::size_t &at = m_at[side];
            for (std::size_t i = 1; i < hull.size(); ++i)
                if (outwards.dot(hull[i]) > outwards.dot(hull[at]))
                    at = i;
            while (outwards.dot(hull[next(at)]) >= outwards.dot(hull[at]) && next(at) != 0)
                at = next(at);
        }
    }

    /// To the next edge: which way the box lies then, of any length; from +x to +y in all.
    Vec2 turn()
    {
        std::size_t first = 0;
        Vec2 along = edge(0);
        for (std::size_t side = 1; side < 4; ++side) {
            const Vec2 other = edge(side);
            const bool isBefore = cross(other, along) > 0.0;
            first = isBefore ? side : first;
            along = isBefore ? other : along;
        }
        m_at[first] = next(m_at[first]);
        return along;
    }
    Vec2 along() const { return m_hull[m_at[1]] - m_hull[m_at[3]]; }
    Vec2 across() const { return m_hull[m_at[2]] - m_hull[m_at[0]]; }

private:
    std::size_t next(std::size_t i) const { return i + 1 == m_hull.size() ? 0 : i + 1; }
    /// That which the side comes to lie along next, turned back to the direction of the first side.
    Vec2 edge(std::size_t side) const
    {
        const Vec2 e = m_hull[next(m_at[side])] - m_hull[m_at[side]];
        switch (side) {
        case 0:
            return e;
        case 1:
            return {e.y(), -e.x()};
        case 2:
            return -e;
        default:
            return {-e.y(), e.x()};
        }
    }

    const Polygon &m_hull;
    std::array<std::size_t, 4> m_at{};
};

struct Range
{
    double from = 0.0, to = 0.0;

    double width() const { return to - from; }
};

/// What of the ranges leaves |c| cos(angle − phase) ≤ limit, where c is the vector that is measured
/// along a direction `lead` ahead of the angle.
std::vector<Range> within(const std::vector<Range> &ranges, const Vec2 &c, double lead,
                          double limit)
{
    const double length = c.norm();
    if (length <= limit)
        return ranges;
    if (limit < 0.0)
        return {};
    const double reach = std::acos(limit / length);
    double phase = std::atan2(c.y(), c.x()) - lead;
    std::vector<Range> left;
    for (const Range &range : ranges) {
        // Of all phases that are the same the one nearest to the range.
        const double middle = 0.5 * (range.from + range.to);
        phase += 2.0 * std::numbers::pi * std::round((middle - phase) / (2.0 * std::numbers::pi));
        if (range.from <= std::min(range.to, phase - reach))
            left.push_back({range.from, std::min(range.to, phase - reach)});
        if (std::max(range.from, phase + reach) <= range.to)
            left.push_back({std::max(range.from, phase + reach), range.to});
    }
    return left;
}

/// Clockwise by `angle`, so that what lay along that direction lies along x. Exact for none.
Vec2 layingDown(double angle)
{
    return direction(-angle);
}

Vec2 quarterMore(const Vec2 &turn)
{
    return {-turn.y(), turn.x()};
}

/// Extends the range by where a coordinate of the curve is largest or smallest within it: at the
/// zeros of its derivative a t² + 2 b t + c.
void extendByExtremes(double p0, double p1, double p2, double p3, double &low, double &high)
{
    const double d0 = p1 - p0, d1 = p2 - p1, d2 = p3 - p2;
    const double a = d0 - 2.0 * d1 + d2, b = d1 - d0, c = d0;
    const double discriminant = b * b - a * c;
    if (!(discriminant >= 0.0))
        return;
    // Without cancellation, also where a is next to nothing.
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    for (const double t : {q / a, c / q}) {
        if (!(t > 0.0 && t < 1.0)) // neither of them when it is not finite
            continue;
        const double s = 1.0 - t;
        const double value = s * s * (s * p0 + 3.0 * t * p1) + t * t * (3.0 * s * p2 + t * p3);
        low = std::min(low, value);
        high = std::max(high, value);
    }
}

bool isBefore(const Vec2 &a, const Vec2 &b)
{
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

/// From left to right, below before above. By counting into columns first, since what is left to
/// compare then is next to nothing.
Polygon fromLeftToRight(const Polygon &points)
{
    const Box2 box = bounds(points);
    const double width = box.max.x() - box.min.x();
    const auto last = static_cast<double>(points.size() - 1);
    const double toColumn = width > 0.0 ? last / width : 0.0;
    const auto column = [&](const Vec2 &p) {
        return static_cast<std::size_t>(std::min((p.x() - box.min.x()) * toColumn, last));
    };
    std::vector<std::uint32_t> ends(points.size(), 0);
    for (const Vec2 &p : points)
        ++ends[column(p)];
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    Polygon sorted(points.size());
    for (const Vec2 &p : points)
        sorted[--ends[column(p)]] = p;
    for (std::size_t c = 0; c < ends.size(); ++c) { // which are starts by now
        const std::size_t end = c + 1 < ends.size() ? ends[c + 1] : sorted.size();
        if (end - ends[c] > 1)
            std::sort(sorted.begin() + ends[c], sorted.begin() + static_cast<std::ptrdiff_t>(end),
                      isBefore);
    }
    return sorted;
}

/// Corners that a turned box can rest on: all of the hull but for rounding.
Polygon outerCorners(const Polygon &polygon)
{
    const Polygon points = fromLeftToRight(polygon);
    // Below from left to right, then above from right to left.
    // Source  A. Andrew 1979, Another efficient algorithm for convex hulls in two dimensions.
    Polygon hull;
    hull.reserve(2 * points.size());
    const auto add = [&hull](const Vec2 &p, std::size_t first) {
        while (hull.size() >= first + 2 &&
               cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0)
            hull.pop_back();
        hull.push_back(p);
    };
    for (const Vec2 &p : points)
        add(p, 0);
    const std::size_t first = hull.size() - 1;
    for (std::size_t i = points.size() - 1; i-- > 0;)
        add(points[i], first);
    hull.pop_back(); // the first again
    return hull;
}

} // namespace

Box2 turnedBounds(const Polygon &polygon, const Vec2 &turn)
{
    Box2 box;
    for (const Vec2 &p : polygon)
        box.extend(turned(p, turn));
    return box;
}

Box2 turnedBounds(const Contour &contour, const Vec2 &turn)
{
    // Ends first: a curve whose control points lie in their box does not reach out of it.
    const std::vector<Vec2> &points = contour.points();
    Box2 box;
    for (std::size_t i = 0; i < points.size(); i += 3)
        box.extend(turned(points[i], turn));
    const Box2 ends = box;
    for (std::size_t i = 0; i < points.size(); i += 3) {
        const Vec2 p1 = turned(points[i + 1], turn), p2 = turned(points[i + 2], turn);
        const bool staysInside[2] = {
            std::min(p1.x(), p2.x()) >= ends.min.x() && std::max(p1.x(), p2.x()) <= ends.max.x(),
            std::min(p1.y(), p2.y()) >= ends.min.y() && std::max(p1.y(), p2.y()) <= ends.max.y()};
        if (staysInside[0] && staysInside[1])
            continue;
        const Vec2 p0 = turned(points[i], turn);
        const Vec2 p3 = turned(points[i + 3 < points.size() ? i + 3 : 0], turn);
        for (const int axis : {0, 1}) {
            if (!staysInside[axis])
                extendByExtremes(p0[axis], p1[axis], p2[axis], p3[axis], box.min[axis],
                                 box.max[axis]);
        }
    }
    return box;
}

Turns findTurns(const Polygon &polygon)
{
    Turns turns;
    if (polygon.size() < 3)
        return turns;
    const Polygon hull = outerCorners(polygon);
    if (hull.size() < 3)
        return turns;
    TurningBox box(hull);
    double smallest = std::numeric_limits<double>::infinity(), lowest = smallest;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Vec2 along = box.turn();
        // Width and height are these over the direction's length.
        const double width = box.along().dot(along),
                     height = box.across().dot(perpendicular(along));
        const double squared = along.squaredNorm();
        const double area = width * height / squared,
                     low = std::min(width, height) * std::min(width, height) / squared;
        if (area >= smallest && low >= lowest)
            continue;
        const Vec2 turn = Vec2(along.x(), -along.y()).normalized(); // lays it down along x
        const Vec2 lying = width >= height ? turn : quarterMore(turn);
        if (area < smallest) {
            smallest = area;
            turns.smallest = lying;
        }
        if (low < lowest) {
            lowest = low;
            turns.lowest = lying;
        }
    }
    return turns;
}

std::optional<Vec2> findFittingTurn(const Polygon &hull, const Vec2 &room)
{
    std::optional<Vec2> fitting;
    double widest = -1.0;
    const std::vector<double> angles = eventAngles(hull);
    Calipers calipers(hull);
    const Vec2 limit = room + Vec2::Constant(kClipGrid);
    for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
        const Range all{angles[i], angles[i + 1]};
        calipers.turnTo(direction(0.5 * (all.from + all.to)));
        for (const bool isTurned : {false, true}) {
            const Vec2 most = isTurned ? Vec2(limit.y(), limit.x()) : limit;
            for (const Range &range : within(within({all}, calipers.along(), 0.0, most.x()),
                                             calipers.across(), kQuarter, most.y())) {
                if (range.width() <= widest)
                    continue;
                widest = range.width();
                const Vec2 turn = layingDown(0.5 * (range.from + range.to));
                fitting = isTurned ? quarterMore(turn) : turn;
            }
        }
    }
    return fitting;
}

} // namespace fff
