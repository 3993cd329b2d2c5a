#include "core/assembly/settling.h"

#include "core/base/tolerances.h"
#include "core/geometry/convex_hull.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace fff {

namespace {

/// More steps than this no rolling takes that leans by kFarthestLean at the most.
constexpr int kMostSteps = 200;
/// A distance that is only to leave out what is farther away, made a little larger than rounding.
constexpr double kRoundedUp = 1.0 + 1e-9;

/// How it would roll: about a line on the ground, away from its feet.
struct Roll
{
    Vec2 from = Vec2::Zero(); // of the line, a point, along the ground's axes
    Vec2 way = Vec2::Zero();  // unit, square to the line
};

class Rolling
{
public:
    Rolling(const std::vector<Vec3> &points, const Vec3 &centre)
        : m_points(&points), m_centre(centre)
    {
        m_ground.height = lowest();
        look();
    }

    const Ground &ground() const { return m_ground; }
    double lean() const { return std::acos(std::clamp(m_ground.up.y(), -1.0, 1.0)); }
    /// About which it rolls on, if it does.
    std::optional<Roll> next() const;
    /// Until another point touches, radians; a right angle: none will.
    double angleOf(const Roll &roll) const;
    void roll(const Roll &roll, double angle);

private:
    double lowest() const
    {
        double least = std::numeric_limits<double>::infinity();
        for (const Vec3 &p : *m_points)
            least = std::min(least, m_ground.up.dot(p));
        return least;
    }
    Vec2 along(const Vec3 &p) const { return {m_x.dot(p), m_z.dot(p)}; }
    bool touches(const Vec3 &p) const { return m_ground.above(p) <= kGroundContact; }
    /// Where of what touches the centre of mass is.
    void look();

    const std::vector<Vec3> *m_points;
    Vec3 m_centre;
    Ground m_ground;
    Vec3 m_x = Vec3::UnitX(), m_z = Vec3::UnitZ();
    Polygon m_feet; // of what touches the hull
};

void Rolling::look()
{
    m_x = m_ground.acrossX();
    m_z = m_ground.acrossZ();
    std::vector<Vec2> feet;
    for (const Vec3 &p : *m_points)
        if (touches(p))
            feet.push_back(along(p));
    m_feet = convexHull(feet);
}

std::optional<Roll> Rolling::next() const
{
    const Vec2 centre = along(m_centre);
    Roll roll;
    if (signedDistance(m_feet, centre, &roll.from) >= 0.0)
        return std::nullopt;
    const Vec2 out = centre - roll.from;
    if (out.norm() <= kClipGrid)
        return std::nullopt; // right over an edge of its feet, to rounding
    roll.way = out.normalized();
    return roll;
}

double Rolling::angleOf(const Roll &roll) const
{
    const Vec3 way = roll.way.x() * m_x + roll.way.y() * m_z;
    const double from = roll.way.dot(roll.from);
    double least = std::numeric_limits<double>::infinity(); // slope
    for (const Vec3 &p : *m_points) {
        const double above = m_ground.above(p), out = way.dot(p) - from;
        if (out > kClipGrid && above > kGroundContact && above < least * out)
            least = above / out;
    }
    return std::atan(least);
}

void Rolling::roll(const Roll &roll, double angle)
{
    const Vec3 way = roll.way.x() * m_x + roll.way.y() * m_z;
    // Seen from the model it is the ground that comes up on that side.
    m_ground.up = (std::cos(angle) * m_ground.up - std::sin(angle) * way).normalized();
    m_ground.height = lowest();
    look();
}

/// Leaned on by what leans by twice kFarthestLean.
const double kSlope = std::tan(2.0 * kFarthestLean);

Vec2 across(const Vec3 &p)
{
    return {p.x(), p.z()};
}

bool isLower(const Vec3 &a, const Vec3 &b)
{
    return a.y() < b.y();
}

/// Whether something lies so far above something else (mm) that no ground which leans by kSlope
/// comes to it first.
bool isOutOfReach(double up, double squaredAcross)
{
    return up > 0.0 && up * up > kSlope * kSlope * squaredAcross;
}

/// Of the points those that can come to touch. What keeps one from it stands no farther from it
/// than its height above the lowest of all allows: only such are looked at, in the order of the
/// axis along which the points are strung out. O(n log n) for what has most feet on the ground.
std::vector<Vec3> withinReach(std::vector<Vec3> points)
{
    std::sort(points.begin(), points.end(), isLower);
    std::vector<Vec3> able;
    if (points.empty())
        return able;
    Box3 box;
    for (const Vec3 &p : points)
        box.extend(p);
    const int axis = box.size().x() >= box.size().z() ? 0 : 2;
    std::multimap<double, Vec3> placed;
    for (const Vec3 &p : points) {
        const auto isBelow = [&](const auto &other) {
            const Vec3 &q = other.second;
            return isOutOfReach(p.y() - q.y(), (across(p) - across(q)).squaredNorm());
        };
        const double reach = kRoundedUp * (p.y() - points.front().y()) / kSlope;
        const auto begin = placed.lower_bound(p[axis] - reach);
        const auto end = placed.upper_bound(p[axis] + reach);
        if (std::any_of(begin, end, isBelow))
            continue;
        able.push_back(p);
        placed.emplace(p[axis], p);
    }
    return able;
}

} // namespace

std::vector<Vec3> undermost(const Slab &slab)
{
    Vec3 toLower = 0.5 * slab.thickness * slab.frame.normal();
    if (toLower.y() > 0.0)
        toLower = -toLower;
    // Of an upright one both faces come to the ground.
    const bool hasTwo = !isOutOfReach(-2.0 * toLower.y(), (2.0 * across(toLower)).squaredNorm());
    std::vector<Vec3> points;
    for (const Vec2 &corner : convexHull(slab.region.outer)) {
        const Vec3 middle = slab.frame.toWorld(corner);
        points.push_back(middle + toLower);
        if (hasTwo)
            points.push_back(middle - toLower);
    }
    return withinReach(std::move(points));
}

std::optional<Rest> settle(const std::vector<Vec3> &points, const Vec3 &centreOfMass)
{
    if (points.empty())
        return std::nullopt;
    const std::vector<Vec3> able = withinReach(points);
    Rolling rolling(able, centreOfMass);
    for (int step = 0; step < kMostSteps; ++step) {
        const std::optional<Roll> roll = rolling.next();
        if (!roll) {
            Rest rest{topplingOf(able, centreOfMass, rolling.ground()), 0.0};
            rest.lean = std::acos(std::clamp(rest.ground.up.y(), -1.0, 1.0));
            return rest;
        }
        const double angle = rolling.angleOf(*roll);
        if (angle > 2.0 * kFarthestLean)
            return std::nullopt;
        rolling.roll(*roll, angle);
        if (rolling.lean() > kFarthestLean)
            return std::nullopt;
    }
    return std::nullopt;
}

} // namespace fff
