#include "core/assembly/settling.h"

#include "core/base/tolerances.h"
#include "core/geometry/convex_hull.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fff {

namespace {

/// What leans rocks back onto the feet that it came from: by no more than this is that seen to (5°,
/// radians).
constexpr double kMostRocking = 0.08726646259971647;
/// More steps than this no rolling takes that leans by kFarthestLean at the most.
constexpr int kMostSteps = 200;

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
        : m_points(points), m_centre(centre)
    {
        m_ground.height = lowest();
        look();
    }

    const Ground &ground() const { return m_ground; }
    /// With those that come down when it rocks by less.
    std::vector<Vec3> contacts(double rocking) const;
    /// About which it rolls on, if it does.
    std::optional<Roll> next() const;
    /// Until another point touches, radians; infinite: none will.
    double angleOf(const Roll &roll) const;
    void roll(const Roll &roll, double angle);

private:
    double lowest() const
    {
        double least = std::numeric_limits<double>::infinity();
        for (const Vec3 &p : m_points)
            least = std::min(least, m_ground.up.dot(p));
        return least;
    }
    Vec2 along(const Vec3 &p) const { return {m_x.dot(p), m_z.dot(p)}; }
    bool touches(const Vec3 &p) const { return m_ground.above(p) <= kGroundContact; }
    /// Where of what touches the centre of mass is.
    void look();

    const std::vector<Vec3> &m_points;
    Vec3 m_centre;
    Ground m_ground;
    Vec3 m_x = Vec3::UnitX(), m_z = Vec3::UnitZ();
    Polygon m_feet; // their hull
};

void Rolling::look()
{
    m_x = m_ground.acrossX();
    m_z = m_ground.acrossZ();
    std::vector<Vec2> feet;
    for (const Vec3 &p : m_points)
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
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3 &p : m_points) {
        const double out = roll.way.dot(along(p) - roll.from), above = m_ground.above(p);
        if (out > kClipGrid && above > kGroundContact)
            least = std::min(least, std::atan2(above, out));
    }
    return least;
}

void Rolling::roll(const Roll &roll, double angle)
{
    const Vec3 way = roll.way.x() * m_x + roll.way.y() * m_z;
    // Seen from the model it is the ground that comes up on that side.
    m_ground.up = (std::cos(angle) * m_ground.up - std::sin(angle) * way).normalized();
    m_ground.height = lowest();
    look();
}

/// Where it rocks over an edge it stands on the same edge and what comes down beyond it.
std::vector<Vec3> Rolling::contacts(double rocking) const
{
    std::vector<Roll> edges;
    for (std::size_t i = 0, j = m_feet.size() - 1; i < m_feet.size(); j = i++)
        if (m_feet.size() > 1 && m_feet[i] != m_feet[j])
            // Its hull runs counter-clockwise as (x, z) has it: outside is to the right.
            edges.push_back({m_feet[j], -perpendicular((m_feet[i] - m_feet[j]).normalized())});
    std::vector<Vec3> found;
    for (const Vec3 &p : m_points) {
        const double above = m_ground.above(p);
        const bool comesDown = std::any_of(edges.begin(), edges.end(), [&](const Roll &edge) {
            const double out = edge.way.dot(along(p) - edge.from);
            return out > kClipGrid && std::atan2(above, out) <= rocking;
        });
        if (touches(p) || comesDown)
            found.push_back(p);
    }
    return found;
}

} // namespace

Vec3 Ground::acrossX() const
{
    return Eigen::Quaterniond::FromTwoVectors(Vec3::UnitY(), up) * Vec3::UnitX();
}

Vec3 Ground::acrossZ() const
{
    return Eigen::Quaterniond::FromTwoVectors(Vec3::UnitY(), up) * Vec3::UnitZ();
}

std::optional<Rest> settle(const std::vector<Vec3> &points, const Vec3 &centreOfMass)
{
    if (points.empty())
        return std::nullopt;
    Rolling rolling(points, centreOfMass);
    const auto lean = [&rolling] {
        return std::acos(std::clamp(rolling.ground().up.y(), -1.0, 1.0));
    };
    for (int step = 0; step < kMostSteps; ++step) {
        const std::optional<Roll> roll = rolling.next();
        if (!roll)
            return Rest{rolling.ground(), lean(),
                        rolling.contacts(kRocking + std::min(lean(), kMostRocking))};
        const double angle = rolling.angleOf(*roll);
        if (angle > 2.0 * kFarthestLean)
            return std::nullopt;
        rolling.roll(*roll, angle);
        if (lean() > kFarthestLean)
            return std::nullopt;
    }
    return std::nullopt;
}

} // namespace fff
