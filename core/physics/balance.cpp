#include "core/physics/balance.h"

#include "core/base/tolerances.h"
#include "core/geometry/convex_hull.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace fff {

namespace {

/// A support polygon below this share of thickness · size is a line (no unit).
constexpr double kSupportLineShare = 0.01;
/// Forces below this share of all of them are rounding (no unit).
constexpr double kNoForce = 1e-9;
/// A resultant that leaves the vertical by less than this share of all forces slides nowhere: that
/// much comes of a file's digits (no unit).
constexpr double kLevelForce = 1e-6;
/// A resultant this far from a line of feet, by the structure's size, is on it (no unit).
constexpr double kOnSupportLine = 1e-9;
/// Farther from the feet than so many sizes of the structure no resultant is said to be (no unit).
constexpr double kFarthestResultant = 1e6;

/// Of all weights and loads on a component; the moment about a point.
struct Resultant
{
    Vec3 force = Vec3::Zero();
    Vec3 moment = Vec3::Zero();
    double scale = 0.0;
};

Resultant resultant(const Structure &structure, const Component &component, const Vec3 &about)
{
    Resultant sum;
    for (int i : component.members) {
        const Member &member = structure.members[i];
        const Vec3 weight = member.mass * structure.gravity;
        sum.force += weight;
        sum.moment += (member.centroid - about).cross(weight);
        sum.scale += weight.norm();
    }
    for (int i : component.loads) {
        const MemberLoad &load = structure.loads[i];
        sum.force += load.force;
        sum.moment += (load.point - about).cross(load.force) + load.moment;
        sum.scale += load.force.norm() + load.moment.norm() / structure.size;
    }
    return sum;
}

Vec3 middle(const Structure &structure, const Component &component)
{
    Vec3 sum = Vec3::Zero();
    if (component.feet.empty()) {
        for (int i : component.members)
            sum += structure.members[i].centroid;
        return sum / std::max<double>(1.0, component.members.size());
    }
    for (int i : component.feet)
        sum += structure.feet[i].point;
    return sum / component.feet.size();
}

/// How far the component reaches, at least: no more than the structure's size.
double extent(const Structure &structure, const Component &component)
{
    Box3 box;
    for (int i : component.feet)
        box.extend(structure.feet[i].point);
    for (int i : component.members)
        box.extend(structure.members[i].centroid);
    for (int i : component.links)
        box.extend(structure.links[i].point);
    return std::min(structure.size, box.isEmpty() ? 0.0 : box.size().norm());
}

/// The feet, seen on the ground.
class SupportPolygon
{
public:
    /// Coordinates are those of the world but for turning, so that they are exact on its axes.
    SupportPolygon(const Structure &structure, const Component &component)
        : m_axes(groundAxes(structure.up)), m_feet(component.feet)
    {
        for (int i : component.feet)
            m_points.push_back(onPlane(structure.feet[i].point));
        m_hull = convexHull(m_points);
    }

    Vec2 onPlane(const Vec3 &p) const { return {m_axes[0].dot(p), m_axes[1].dot(p)}; }
    Vec3 direction(const Vec2 &p) const { return p.x() * m_axes[0] + p.y() * m_axes[1]; }
    const Polygon &hull() const { return m_hull; }
    double area() const { return m_hull.size() < 3 ? 0.0 : signedArea(m_hull); }
    int footAt(const Vec2 &corner) const
    {
        for (std::size_t i = 0; i < m_points.size(); ++i) {
            if (m_points[i] == corner)
                return m_feet[i];
        }
        return -1;
    }
    /// Feet at the ends of the edge that comes nearest to the point.
    std::array<int, 2> edgeAt(const Vec2 &point) const
    {
        std::size_t best = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < m_hull.size(); ++i) {
            const Polygon edge{m_hull[i], m_hull[(i + 1) % m_hull.size()]};
            if (const double distance = std::abs(signedDistance(edge, point)); distance < least) {
                least = distance;
                best = i;
            }
        }
        return {footAt(m_hull[best]), footAt(m_hull[(best + 1) % m_hull.size()])};
    }
    double meanDistance(const Vec2 &from) const
    {
        double sum = 0.0;
        for (const Vec2 &p : m_points)
            sum += (p - from).norm();
        return sum / m_points.size();
    }

private:
    std::array<Vec3, 2> m_axes;
    const std::vector<int> &m_feet;
    std::vector<Vec2> m_points;
    Polygon m_hull;
};

/// What friction has to do where feet are not pinned, N.
double slidingForce(const Structure &structure, const Component &component,
                    const SupportPolygon &polygon, const Vec3 &about, const Resultant &sum)
{
    const Vec3 &up = structure.up;
    Vec3 pin = Vec3::Zero();
    int pinned = 0;
    bool isTurnHeld = false;
    for (int i : component.feet) {
        const Foot &foot = structure.feet[i];
        if (!foot.isPinned)
            continue;
        isTurnHeld = isTurnHeld ||
                     (pinned > 0 &&
                      (polygon.onPlane(foot.point) - polygon.onPlane(pin)).norm() > kTouchingDepth);
        pin = foot.point;
        ++pinned;
    }
    if (isTurnHeld)
        return 0.0;
    const Vec3 centre = pinned > 0 ? pin : about;
    const double turn = std::abs((sum.moment + (about - centre).cross(sum.force)).dot(up));
    const double arm = std::max(polygon.meanDistance(polygon.onPlane(centre)), kTouchingDepth);
    const double push = pinned > 0 ? 0.0 : (sum.force - up.dot(sum.force) * up).norm();
    const double needed = std::hypot(push, turn / arm);
    return needed > kLevelForce * sum.scale ? needed : 0.0;
}

} // namespace

std::array<Vec3, 2> groundAxes(const Vec3 &up)
{
    // The world's axes where they are square to it, in an order that keeps hands.
    for (int i = 0; i < 3; ++i) {
        if (std::abs(up[i]) == 1.0) {
            Vec3 first = Vec3::Unit((i + 1) % 3), second = Vec3::Unit((i + 2) % 3);
            if (up[i] < 0.0)
                std::swap(first, second);
            return {first, second};
        }
    }
    const Vec3 first = up.unitOrthogonal();
    return {first, up.cross(first)};
}

BodyBalance bodyBalance(const Structure &structure, const Component &component,
                        const Support &support, bool isOnly)
{
    BodyBalance body;
    const Vec3 &up = structure.up;
    const Vec3 about = middle(structure, component);
    const Resultant sum = resultant(structure, component, about);
    body.scale = sum.scale;
    body.onGround = body.nearest = about;
    body.pressing = -up.dot(sum.force);
    const double rounding = kNoForce * sum.scale;
    body.balance = isOnly ? Balance::NoContact : Balance::Floating;
    if (component.feet.empty() || body.pressing < -rounding)
        return body;

    // Where the resultant meets the ground. Without weight it is nowhere in particular.
    const SupportPolygon polygon(structure, component);
    Vec3 offset = Vec3::Zero();
    const Vec3 lever = -up.cross(sum.moment);
    if (body.pressing > rounding)
        offset = lever / body.pressing;
    else if (lever.norm() > rounding * structure.size)
        offset = lever.normalized() * kFarthestResultant * structure.size;
    if (offset.norm() > kFarthestResultant * structure.size)
        offset *= kFarthestResultant * structure.size / offset.norm();
    body.onGround = about + offset;
    const Vec2 point = polygon.onPlane(body.onGround);

    Vec2 nearest = point;
    body.margin = signedDistance(polygon.hull(), point, &nearest);
    body.nearest = body.onGround + polygon.direction(nearest - point);
    body.edge = polygon.edgeAt(point);
    body.sliding =
        support.arePinned
            ? 0.0
            : slidingForce(
                  structure, component, polygon, body.onGround,
                  {sum.force, sum.moment + (about - body.onGround).cross(sum.force), sum.scale});
    const bool doesSlide = body.sliding > std::max(0.0, support.friction) * body.pressing;
    body.areAllHeld = support.arePinned || (body.sliding > 0.0 && !doesSlide);
    const double lineArea = kSupportLineShare * structure.thickness * extent(structure, component);
    const bool isLine = polygon.area() <= 0.0 || polygon.area() < lineArea;
    if (isLine)
        body.balance = Balance::LineSupport;
    else if (body.margin <= 0.0)
        body.balance = Balance::Topples;
    else
        body.balance = doesSlide ? Balance::Slides : Balance::Stands;
    const bool isOnLine =
        isLine && polygon.hull().size() == 2 && body.margin > -kOnSupportLine * structure.size;
    body.canCarry = body.balance == Balance::Stands || (isOnLine && !doesSlide);
    return body;
}

} // namespace fff
