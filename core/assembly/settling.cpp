#include "core/assembly/settling.h"

#include "core/base/tolerances.h"
#include "core/geometry/convex_hull.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>

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

bool isKeptOff(const Vec3 &p, const Vec3 &by)
{
    return isOutOfReach(p.y() - by.y(), (across(p) - across(by)).squaredNorm());
}

/// Of points at one height, to rounding, those of which the hull is that of all.
std::vector<Vec3> outermostOf(std::span<const Vec3> level)
{
    std::vector<Vec2> places;
    places.reserve(level.size());
    for (const Vec3 &p : level)
        places.push_back(across(p));
    std::vector<Vec3> outer;
    for (const std::size_t i : outermost(places))
        outer.push_back(level[i]);
    return outer;
}

/// withinReach() of few.
std::vector<Vec3> fewWithinReach(std::vector<Vec3> points)
{
    std::sort(points.begin(), points.end(), isLower);
    auto kept = points.begin();
    for (const Vec3 &p : points)
        if (std::none_of(points.begin(), kept, [&](const Vec3 &q) { return isKeptOff(p, q); }))
            *kept++ = p;
    points.erase(kept, points.end());
    return points;
}

/// Of the points those that can come to touch. What keeps one from it stands no farther from it
/// than its height above the lowest of all allows: only such are looked at, in the order of the
/// axis along which the points are strung out. O(n log n) for what has most feet on the ground.
std::vector<Vec3> withinReach(std::vector<Vec3> points)
{
    constexpr std::size_t kFew = 16;
    if (points.size() <= kFew)
        return fewWithinReach(std::move(points));
    const double lowest = std::min_element(points.begin(), points.end(), isLower)->y();
    // The many feet of what stands are thinned first: those between others never touch alone.
    const auto raised = std::partition(points.begin(), points.end(),
                                       [&](const Vec3 &p) { return p.y() <= lowest + kClipGrid; });
    std::vector<Vec3> able = outermostOf({points.begin(), raised});
    if (raised == points.end())
        return able;
    std::sort(raised, points.end(), isLower);
    Box3 box;
    for (const Vec3 &p : points)
        box.extend(p);
    const int axis = box.size().x() >= box.size().z() ? 0 : 2;
    std::multimap<double, Vec3> placed;
    for (const Vec3 &p : able)
        placed.emplace(p[axis], p);
    for (auto it = raised; it != points.end(); ++it) {
        const Vec3 &p = *it;
        const double reach = kRoundedUp * (p.y() - lowest) / kSlope;
        const auto begin = placed.lower_bound(p[axis] - reach);
        const auto end = placed.upper_bound(p[axis] + reach);
        if (std::any_of(begin, end, [&](const auto &other) { return isKeptOff(p, other.second); }))
            continue;
        able.push_back(p);
        placed.emplace(p[axis], p);
    }
    return able;
}

/// Of an outline the corners of a hull of what the lowest one does not keep from touching: mostly
/// two or three of hundreds.
Polygon lowCorners(const Slab &slab)
{
    const Vec2 up(slab.frame.x.y(), slab.frame.y.y());
    const Polygon &ring = slab.region.outer;
    Polygon low;
    if (ring.empty())
        return low;
    const auto isLower = [&](const Vec2 &a, const Vec2 &b) { return up.dot(a) < up.dot(b); };
    const Vec2 lowest = *std::min_element(ring.begin(), ring.end(), isLower);
    for (const Vec2 &p : ring) {
        const double rise = up.dot(p - lowest);
        if (!isOutOfReach(rise, (p - lowest).squaredNorm() - rise * rise))
            low.push_back(p);
    }
    return low.size() > 2 ? convexHull(low) : low;
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
    for (const Vec2 &corner : lowCorners(slab)) {
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
