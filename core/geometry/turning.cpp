#include "core/geometry/turning.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

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

/// The same as unit vectors, without a sine or an angle: every part of a layout asks for them.
std::vector<Vec2> eventDirections(const Polygon &hull)
{
    std::vector<Vec2> directions{Vec2::UnitX(), Vec2::UnitY()};
    directions.reserve(hull.size() + 2);
    for (std::size_t i = 0, j = hull.size() - 1; i < hull.size(); j = i++) {
        Vec2 edge = hull[i] - hull[j];
        if (!(edge.squaredNorm() > 0.0))
            continue;
        while (!(edge.x() > 0.0 && edge.y() >= 0.0))
            edge = perpendicular(edge);
        directions.push_back(edge.normalized());
    }
    std::sort(directions.begin() + 2, directions.end(),
              [](const Vec2 &a, const Vec2 &b) { return a.y() < b.y(); });
    std::rotate(directions.begin() + 1, directions.begin() + 2, directions.end()); // Y last
    return directions;
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

/// Corners that a turned box can rest on: all of the hull but for rounding.
Polygon outerCorners(Polygon points)
{
    std::sort(points.begin(), points.end(), [](const Vec2 &a, const Vec2 &b) {
        return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
    });
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
    const std::vector<Vec2> directions = eventDirections(hull);
    Calipers calipers(hull);
    double smallest = std::numeric_limits<double>::infinity(), lowest = smallest;
    for (std::size_t i = 0; i + 1 < directions.size(); ++i) {
        // The interval's other end begins the next one; the last of all is the first, turned.
        const Vec2 &along = directions[i];
        calipers.turnTo(along + directions[i + 1]);
        const double width = calipers.along().dot(along),
                     height = calipers.across().dot(perpendicular(along));
        const Vec2 turn(along.x(), -along.y()); // lays it down along x
        const Vec2 lying = width >= height ? turn : quarterMore(turn);
        if (width * height < smallest) {
            smallest = width * height;
            turns.smallest = lying;
        }
        if (std::min(width, height) < lowest) {
            lowest = std::min(width, height);
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
