#include "core/assembly/solid.h"

#include "core/geometry/convex_hull.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();
/// Squared sine below which two edges are parallel: their common normal is rounding.
constexpr double kParallel = 1e-18;
/// A way so short that nothing moves, mm.
constexpr double kStill = 1e-9;

Extent extentOf(const std::array<Vec3, 3> &triangle, const Vec3 &axis)
{
    const double a = axis.dot(triangle[0]), b = axis.dot(triangle[1]), c = axis.dot(triangle[2]);
    return {std::min({a, b, c}), std::max({a, b, c})};
}

/// Leaves of `way` where the extent of a, moved on by `speed` each mm, and that of b share more
/// than `depth`. False when nothing is left.
bool keepShared(const Extent &a, const Extent &b, double speed, double depth, Travel &way)
{
    // a.max + t speed > b.min + depth  and  a.min + t speed < b.max − depth
    const double low = b.min + depth - a.max, high = b.max - depth - a.min;
    if (speed == 0.0)
        return low < 0.0 && high > 0.0;
    const double first = low / speed, second = high / speed;
    way.from = std::max(way.from, std::min(first, second));
    way.to = std::min(way.to, std::max(first, second));
    // A product of negative depths can turn the two around; then there is nothing.
    return low < high && way.from < way.to;
}

/// One of the prisms of a solid, as its axes need it.
struct Prism
{
    const std::array<Vec3, 3> &corners;
    const Vec3 &normal;
    double half;

    Extent along(const Vec3 &axis) const
    {
        const double more = half * std::abs(axis.dot(normal));
        const Extent flat = extentOf(corners, axis);
        return {flat.min - more, flat.max + more};
    }
    Vec3 edge(std::size_t i) const { return corners[(i + 1) % 3] - corners[i]; }
};

/// Calls `look` with each axis that can separate two prisms (unit) until it answers false.
template <typename Look>
bool forEachAxis(const Prism &a, const Prism &b, const Look &look)
{
    if (!look(a.normal) || !look(b.normal))
        return false;
    const auto lookAcross = [&](const Vec3 &u, const Vec3 &v) {
        const Vec3 axis = u.cross(v);
        const double length = axis.squaredNorm();
        return !(length > kParallel * u.squaredNorm() * v.squaredNorm()) ||
               look(Vec3(axis / std::sqrt(length)));
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 edge = a.edge(i);
        if (!lookAcross(edge, a.normal) || !lookAcross(b.edge(i), b.normal) ||
            !lookAcross(edge, b.normal) || !lookAcross(a.normal, b.edge(i)))
            return false;
        for (std::size_t k = 0; k < 3; ++k)
            if (!lookAcross(edge, b.edge(k)))
                return false;
    }
    return lookAcross(a.normal, b.normal);
}

/// Two unit vectors square to a direction and to each other.
std::array<Vec3, 2> across(const Vec3 &direction)
{
    const Vec3 u = direction.unitOrthogonal();
    return {u, direction.cross(u)};
}

/// A triangle that may meet the other solid, with where it is seen along the direction.
struct Candidate
{
    const std::array<Vec3, 3> *corners;
    Extent u, v;
};

/// Of `solid`, what comes as deep as `depth` into the slab of the other's plane on the way.
/// speed: of `solid` against the other, along the other's normal.
std::vector<Candidate> candidates(const Solid &solid, const Solid &other, double speed,
                                  double depth, const std::array<Vec3, 2> &screen, Travel &way)
{
    std::vector<Candidate> found;
    const double middle = other.normal.dot(other.frame.origin);
    const Extent slab{middle - other.half, middle + other.half};
    const double more = solid.half * std::abs(other.normal.dot(solid.normal));
    std::array<double, 2> wider{};
    for (std::size_t i = 0; i < 2; ++i)
        wider[i] = solid.half * std::abs(screen[i].dot(solid.normal));
    Travel all{kEndless, -kEndless};
    for (const std::array<Vec3, 3> &corners : solid.triangles) {
        Extent extent = extentOf(corners, other.normal);
        extent.min -= more;
        extent.max += more;
        Travel own = way;
        if (!keepShared(extent, slab, speed, depth, own))
            continue;
        all.from = std::min(all.from, own.from);
        all.to = std::max(all.to, own.to);
        Candidate candidate{&corners, extentOf(corners, screen[0]), extentOf(corners, screen[1])};
        candidate.u = {candidate.u.min - wider[0], candidate.u.max + wider[0]};
        candidate.v = {candidate.v.min - wider[1], candidate.v.max + wider[1]};
        found.push_back(candidate);
    }
    if (!found.empty())
        way = all;
    return found;
}

/// Calls `meet` with two prisms and the stretch in which they share more than `depth`, for each
/// pair that has one in `way`, until it answers false.
template <typename Meet>
void forEachMeeting(const Solid &a, const Solid &b, const Vec3 &direction, double depth, Travel way,
                    const Meet &meet)
{
    const std::array<Vec3, 2> screen = across(direction);
    const std::vector<Candidate> movers =
        candidates(a, b, b.normal.dot(direction), depth, screen, way);
    if (movers.empty())
        return;
    std::vector<Candidate> others = candidates(b, a, -a.normal.dot(direction), depth, screen, way);
    std::sort(others.begin(), others.end(),
              [](const Candidate &x, const Candidate &y) { return x.u.min < y.u.min; });
    double widest = 0.0;
    for (const Candidate &other : others)
        widest = std::max(widest, other.u.max - other.u.min);
    for (const Candidate &mover : movers) {
        auto other = std::lower_bound(
            others.begin(), others.end(), mover.u.min + depth - widest,
            [](const Candidate &candidate, double value) { return candidate.u.min < value; });
        for (; other != others.end() && other->u.min + depth < mover.u.max; ++other) {
            if (!(other->u.max > mover.u.min + depth && other->v.max > mover.v.min + depth &&
                  other->v.min + depth < mover.v.max))
                continue;
            const Prism p{*mover.corners, a.normal, a.half}, q{*other->corners, b.normal, b.half};
            Travel shared = way;
            const bool meets = forEachAxis(p, q, [&](const Vec3 &axis) {
                return keepShared(p.along(axis), q.along(axis), axis.dot(direction), depth, shared);
            });
            if (meets && !meet(p, q, shared))
                return;
        }
    }
}

/// The middle of what the boxes of two prisms share.
Vec3 middleOf(const Prism &a, const Prism &b)
{
    Vec3 middle;
    for (int i = 0; i < 3; ++i) {
        const Extent first = a.along(Vec3::Unit(i)), second = b.along(Vec3::Unit(i));
        middle[i] = 0.5 * (std::max(first.min, second.min) + std::min(first.max, second.max));
    }
    return middle;
}

/// Whether the boxes come as near as that on the way.
bool keepBoxes(const Box3 &a, const Box3 &b, const Vec3 &direction, double depth, Travel &way)
{
    for (int i = 0; i < 3; ++i) {
        if (!keepShared({a.min[i], a.max[i]}, {b.min[i], b.max[i]}, direction[i], depth, way))
            return false;
    }
    return true;
}

} // namespace

Extent Solid::along(const Vec3 &axis) const
{
    Extent extent;
    for (const Vec3 &p : hull) {
        const double x = axis.dot(p);
        extent = {std::min(extent.min, x), std::max(extent.max, x)};
    }
    const double more = half * std::abs(axis.dot(normal));
    return {extent.min - more, extent.max + more};
}

Solid makeSolid(const Triangulation &triangulation, const Frame &frame, double thickness)
{
    Solid solid;
    solid.frame = frame;
    solid.normal = frame.normal();
    solid.half = 0.5 * thickness;
    solid.triangles.reserve(triangulation.triangles.size());
    const Vec3 reach = solid.half * solid.normal;
    const auto corner = [&](int i) {
        return frame.toWorld(triangulation.points[static_cast<std::size_t>(i)]);
    };
    for (const auto &t : triangulation.triangles)
        solid.triangles.push_back({corner(t[0]), corner(t[1]), corner(t[2])});
    for (const Vec2 &p : convexHull(triangulation.points)) {
        solid.hull.push_back(frame.toWorld(p));
        solid.box.extend(Vec3(solid.hull.back() + reach));
        solid.box.extend(Vec3(solid.hull.back() - reach));
    }
    return solid;
}

Solid movedBy(Solid solid, const Vec3 &by)
{
    solid.frame.origin += by;
    for (std::array<Vec3, 3> &triangle : solid.triangles)
        for (Vec3 &corner : triangle)
            corner += by;
    for (Vec3 &p : solid.hull)
        p += by;
    solid.box.min += by;
    solid.box.max += by;
    return solid;
}

std::optional<Travel> collisionAlong(const Solid &a, const Solid &b, const Vec3 &direction,
                                     double depth)
{
    Travel way{0.0, kEndless};
    if (!keepBoxes(a.box, b.box, direction, depth, way))
        return {};
    std::optional<Travel> found;
    forEachMeeting(a, b, direction, depth, way, [&](auto &, auto &, const Travel &meeting) {
        if (!found || meeting.from < found->from)
            found = meeting;
        return meeting.from > 0.0; // nothing is earlier than that
    });
    return found;
}

bool comesFree(const Solid &a, const Solid &b, const Vec3 &direction, double depth)
{
    Travel way{0.0, kEndless};
    if (!keepBoxes(a.box, b.box, direction, depth, way))
        return true;
    bool isFree = true;
    forEachMeeting(a, b, direction, depth, way,
                   [&](auto &, auto &, const Travel &) { return isFree = false; });
    return isFree;
}

double wayToClear(const Solid &a, const Solid &b, const Vec3 &direction, double gap)
{
    Travel way{0.0, kEndless};
    if (!keepBoxes(a.box, b.box, direction, -gap, way))
        return 0.0;
    double last = 0.0;
    forEachMeeting(a, b, direction, -gap, way, [&](auto &, auto &, const Travel &meeting) {
        last = std::max(last, meeting.to);
        return true;
    });
    return last;
}

std::optional<Interpenetration> interpenetration(const Solid &a, const Solid &b, double depth)
{
    std::optional<Interpenetration> deepest;
    Travel still{-kStill, kStill};
    if (!a.box.intersects(b.box))
        return deepest;
    forEachMeeting(a, b, a.normal, depth, still,
                   [&](const Prism &p, const Prism &q, const Travel &) {
                       double least = kEndless;
                       forEachAxis(p, q, [&](const Vec3 &axis) {
                           const Extent ofP = p.along(axis), ofQ = q.along(axis);
                           least = std::min({least, ofP.max - ofQ.min, ofQ.max - ofP.min});
                           return true;
                       });
                       if (least > depth && (!deepest || least > deepest->depth))
                           deepest = Interpenetration{least, middleOf(p, q)};
                       return true;
                   });
    return deepest;
}

} // namespace fff
