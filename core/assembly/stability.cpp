#include "core/assembly/stability.h"

#include "core/base/tolerances.h"
#include "core/geometry/convex_hull.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// A support polygon below this share of thickness · size is a line (no unit).
constexpr double kLineShare = 0.01;

Vec2 onGround(const Vec3 &p)
{
    return {p.x(), p.z()};
}

/// A closed chain of points in the world.
using Ring = std::vector<Vec3>;

Ring faceRing(const Slab &slab, double offset)
{
    const Vec3 shift = offset * slab.frame.normal();
    Ring ring;
    ring.reserve(slab.region.outer.size());
    for (const Vec2 &p : slab.region.outer)
        ring.push_back(slab.frame.toWorld(p) + shift);
    return ring;
}

bool isLow(const Vec3 &p)
{
    return p.y() <= kGroundContact;
}

/// Where the edge from a to b, one of them low, passes the height below which things touch.
Vec3 passing(const Vec3 &a, const Vec3 &b)
{
    return a + std::clamp((kGroundContact - a.y()) / (b.y() - a.y()), 0.0, 1.0) * (b - a);
}

/// The corners of what of the edge is low.
void addLow(const Vec3 &a, const Vec3 &b, std::vector<Vec2> &corners)
{
    if (isLow(a))
        corners.push_back(onGround(a));
    if (isLow(a) != isLow(b))
        corners.push_back(onGround(passing(a, b)));
}

/// Stretches of the ring that are low; the whole ring is one.
int lowStretches(const Ring &ring)
{
    int begins = 0;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
        begins += isLow(ring[i]) && !isLow(ring[j]) ? 1 : 0;
    return begins == 0 && !ring.empty() && isLow(ring.front()) ? 1 : begins;
}

void addContact(const Slab &slab, GroundContact &contact)
{
    const double half = 0.5 * slab.thickness;
    // The face that is lower; of an upright slab both are alike.
    const bool isUpper = slab.frame.normal().y() > 0.0;
    const Ring low = faceRing(slab, isUpper ? -half : half);
    const Ring high = faceRing(slab, isUpper ? half : -half);
    contact.stretches += lowStretches(low);
    for (std::size_t i = 0, j = low.size() - 1; i < low.size(); j = i++) {
        addLow(low[j], low[i], contact.corners);
        addLow(high[j], high[i], contact.corners);
        if (isLow(low[i]) && !isLow(high[i]))
            contact.corners.push_back(onGround(passing(low[i], high[i])));
    }
}

void measureHeights(const std::vector<Slab> &slabs, GroundContact &contact)
{
    bool isFirst = true;
    for (const Slab &slab : slabs) {
        const Vec3 down =
            -std::abs(0.5 * slab.thickness) *
            (slab.frame.normal().y() < 0.0 ? Vec3(-slab.frame.normal()) : slab.frame.normal());
        for (const Vec2 &p : slab.region.outer) {
            const Vec3 middle = slab.frame.toWorld(p);
            const Vec3 corner = middle + down;
            if (isFirst || corner.y() < contact.lowest) {
                contact.lowest = corner.y();
                contact.lowestPoint = corner;
            }
            contact.lowestMiddle =
                isFirst ? middle.y() : std::min(contact.lowestMiddle, middle.y());
            isFirst = false;
        }
    }
}

/// Into which direction it falls over the nearest point of the polygon's boundary.
Vec2 fallDirection(const Polygon &support, const Vec2 &centre, const Vec2 &nearest, double margin)
{
    Vec2 direction = margin < 0.0 ? Vec2(centre - nearest) : Vec2(nearest - centre);
    if (direction.norm() <= kClipGrid && support.size() >= 3) {
        // Right above an edge: square to it, outwards.
        for (std::size_t i = 0, j = support.size() - 1; i < support.size(); j = i++) {
            const Vec2 edge = (support[i] - support[j]).normalized();
            if (std::abs(cross(edge, centre - support[j])) <= kClipGrid)
                direction = -perpendicular(edge);
        }
    }
    return direction.norm() > 0.0 ? Vec2(direction.normalized()) : Vec2(Vec2::Zero());
}

} // namespace

GroundContact groundContact(const std::vector<Slab> &slabs)
{
    GroundContact contact;
    measureHeights(slabs, contact);
    if (contact.lowest > kGroundContact || contact.lowestMiddle < -kGroundSunk)
        return contact;
    for (const Slab &slab : slabs)
        addContact(slab, contact);
    return contact;
}

Stability stability(const GroundContact &contact, const Vec3 &centreOfMass, double thickness,
                    double size)
{
    Stability result;
    result.contacts = contact.stretches;
    result.height = contact.lowest;
    result.lowestPoint = contact.lowestPoint;
    if (contact.stretches == 0) {
        const bool isBelow = contact.lowestMiddle < -kGroundSunk;
        result.standing = isBelow ? Standing::BelowGround : Standing::NoContact;
        if (isBelow)
            result.height = contact.lowestMiddle;
        return result;
    }
    result.support = convexHull(contact.corners);
    const Vec2 centre = onGround(centreOfMass);
    Vec2 nearest = centre;
    result.margin = signedDistance(result.support, centre, &nearest);
    result.fall = fallDirection(result.support, centre, nearest, result.margin);
    if (signedArea(result.support) < kLineShare * thickness * size)
        result.standing = Standing::LineSupport;
    else if (result.margin <= 0.0)
        result.standing = Standing::Topples;
    else
        result.standing = Standing::Stands;
    if (result.standing == Standing::Stands)
        result.tipAngle = std::atan2(result.margin, std::max(0.0, centreOfMass.y()));
    return result;
}

} // namespace fff
