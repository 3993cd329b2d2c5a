#include "core/assembly/settling.h"

#include "core/base/tolerances.h"
#include "core/geometry/convex_hull.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace fff {

namespace {

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
        : m_points(&points), m_centre(centre)
    {
        m_ground.height = lowest();
        look();
    }

    const Ground &ground() const { return m_ground; }
    double lean() const { return std::acos(std::clamp(m_ground.up.y(), -1.0, 1.0)); }
    /// What touches, indices into the points.
    const std::vector<int> &touching() const { return m_touching; }
    /// Over which it can be pushed.
    std::vector<Roll> edges() const;
    /// mm from the centre of mass to the line, radians by which it has to be tilted until the
    /// centre is over it; less than 0: it is beyond.
    double marginTo(const Roll &edge) const { return edge.way.dot(edge.from - along(m_centre)); }
    double tiltOver(const Roll &edge) const
    {
        return std::atan2(marginTo(edge), std::max(0.0, m_ground.above(m_centre)));
    }
    /// Of the line, nearest to the centre of mass; in the world.
    Vec3 pointOf(const Roll &edge) const;
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
    std::vector<int> m_touching;
    Polygon m_feet; // their hull
};

void Rolling::look()
{
    m_x = m_ground.acrossX();
    m_z = m_ground.acrossZ();
    m_touching.clear();
    std::vector<Vec2> feet;
    for (std::size_t i = 0; i < m_points->size(); ++i)
        if (touches((*m_points)[i])) {
            m_touching.push_back(static_cast<int>(i));
            feet.push_back(along((*m_points)[i]));
        }
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

std::vector<Roll> Rolling::edges() const
{
    std::vector<Roll> edges;
    if (m_feet.size() < 2)
        return edges;
    for (std::size_t i = 0, j = m_feet.size() - 1; i < m_feet.size(); j = i++)
        if (m_feet[i] != m_feet[j])
            // Its hull runs counter-clockwise as (x, z) has it: outside is to the right.
            edges.push_back({m_feet[j], -perpendicular((m_feet[i] - m_feet[j]).normalized())});
    if (m_feet.size() == 2 && edges.size() == 2) { // a line has two ends, too
        const Vec2 way = (m_feet[1] - m_feet[0]).normalized();
        edges.push_back({m_feet[0], -way});
        edges.push_back({m_feet[1], way});
    }
    return edges;
}

Vec3 Rolling::pointOf(const Roll &edge) const
{
    const Vec2 at = along(m_centre) + marginTo(edge) * edge.way;
    return at.x() * m_x + at.y() * m_z + m_ground.height * m_ground.up;
}

/// Of the points those that can come to touch: the corners of what touches as it was drawn, and
/// what reaches beyond these so low that a ground which leans by twice kFarthestLean comes to it
/// first.
std::vector<Vec3> undermost(const std::vector<Vec3> &points)
{
    const auto lower = [](const Vec3 &a, const Vec3 &b) { return a.y() < b.y(); };
    const double level =
        std::min_element(points.begin(), points.end(), lower)->y() + kGroundContact;
    const auto across = [](const Vec3 &p) { return Vec2(p.x(), p.z()); };
    std::vector<Vec2> low;
    for (const Vec3 &p : points)
        if (p.y() <= level)
            low.push_back(across(p));
    const Polygon feet = convexHull(low);
    const double slope = std::tan(2.0 * kFarthestLean);
    std::vector<Vec3> kept;
    for (const Vec3 &p : points) {
        const bool canTouch =
            p.y() <= level ? std::find(feet.begin(), feet.end(), across(p)) != feet.end()
                           : p.y() - level < -slope * signedDistance(feet, across(p), nullptr);
        if (canTouch)
            kept.push_back(p);
    }
    // Nor does what lies within such a slope above another one.
    std::sort(kept.begin(), kept.end(), lower);
    std::vector<Vec3> able;
    for (const Vec3 &p : kept) {
        const bool isAbove = std::any_of(able.begin(), able.end(), [&](const Vec3 &q) {
            const double up = p.y() - q.y();
            return up * up > slope * slope * (across(p) - across(q)).squaredNorm();
        });
        if (!isAbove)
            able.push_back(p);
    }
    return able;
}

double angleBetween(const Ground &a, const Ground &b)
{
    return std::acos(std::clamp(a.up.dot(b.up), -1.0, 1.0));
}

/// An edge that keeps it from falling.
struct Hold
{
    double tilt = -std::numeric_limits<double>::infinity(); // radians, less than which it keeps
    double margin = 0.0;                                    // mm
    Vec3 at = Vec3::Zero();
};

/// All that it may come to lie on when it is pushed, and over which edge it falls.
class Pushing
{
public:
    explicit Pushing(const Rolling &rest)
    {
        m_known.push_back({rest, Hold()});
        m_next.emplace(m_known.front().held.tilt, 0);
        while (!m_next.empty() && (!m_last || m_next.top().first < m_last->tilt)) {
            const std::size_t index = m_next.top().second;
            m_next.pop();
            if (std::exchange(m_known[index].isDone, true))
                continue;
            const Known from = m_known[index]; // the list may move
            for (const Roll &edge : from.at.edges()) {
                const double tilt = from.at.tiltOver(edge);
                push(from.at, edge,
                     tilt > from.held.tilt
                         ? Hold{tilt, from.at.marginTo(edge), from.at.pointOf(edge)}
                         : from.held);
            }
        }
    }

    void tell(const std::vector<Vec3> &points, Rest &rest) const
    {
        const Hold last = m_last.value_or(Hold{0.0, 0.0, points.front()}); // on one point
        rest.tipAngle = last.tilt;
        rest.margin = last.margin;
        rest.edge = last.at;
        std::vector<char> touches(points.size(), 0);
        for (const Known &known : m_known) {
            if (!known.isDone)
                continue;
            for (const int i : known.at.touching())
                touches[static_cast<std::size_t>(i)] = 1;
            const double angle = angleBetween(known.at.ground(), rest.ground);
            if (known.held.tilt < kSteadyTilt)
                rest.rocking = std::max(rest.rocking, angle);
        }
        for (std::size_t i = 0; i < points.size(); ++i)
            if (touches[i])
                rest.contacts.push_back(points[i]);
    }

private:
    struct Known
    {
        Rolling at;
        Hold held; // of the edges on the way here the one that takes most tilting
        bool isDone = false;
    };

    void push(const Rolling &from, const Roll &edge, const Hold &held);

    std::vector<Known> m_known;
    using Reached = std::pair<double, std::size_t>; // tilt, index of a known one
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> m_next;
    std::optional<Hold> m_last; // when that gives way it falls
};

void Pushing::push(const Rolling &from, const Roll &edge, const Hold &held)
{
    if (m_last && held.tilt >= m_last->tilt)
        return;
    const double angle = from.angleOf(edge);
    Rolling then = from;
    if (angle <= 2.0 * kFarthestLean)
        then.roll(edge, angle);
    const double turned = angleBetween(then.ground(), m_known.front().at.ground());
    if (angle > 2.0 * kFarthestLean || turned > kFarthestLean || m_known.size() >= kMostRests) {
        m_last = held;
        return;
    }
    const auto known = std::find_if(m_known.begin(), m_known.end(), [&](const Known &one) {
        return one.at.touching() == then.touching();
    });
    const auto index = static_cast<std::size_t>(known - m_known.begin());
    if (known == m_known.end())
        m_known.push_back({std::move(then), held});
    else if (held.tilt < known->held.tilt)
        known->held = held;
    else
        return;
    m_next.emplace(held.tilt, index);
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
    const std::vector<Vec3> able = undermost(points);
    Rolling rolling(able, centreOfMass);
    for (int step = 0; step < kMostSteps; ++step) {
        const std::optional<Roll> roll = rolling.next();
        if (!roll) {
            Rest rest;
            rest.ground = rolling.ground();
            rest.lean = rolling.lean();
            Pushing(rolling).tell(able, rest);
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
