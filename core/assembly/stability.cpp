#include "core/assembly/stability.h"

#include "core/base/tolerances.h"
#include "core/geometry/convex_hull.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fff {

namespace {

/// A support polygon below this share of thickness · size is a line (no unit).
constexpr double kLineShare = 0.01;
/// Corners of one contact that are not worth a hull of their own: the whole gets one.
constexpr std::size_t kFewCorners = 8;

Vec2 onGround(const Vec3 &p)
{
    return {p.x(), p.z()};
}

/// Where the edge from a to b, one of them low, passes the height below which things touch.
Vec3 passing(const Vec3 &a, const Vec3 &b, const Ground &ground)
{
    const double from = ground.above(a), to = ground.above(b);
    return a + std::clamp((kGroundContact - from) / (to - from), 0.0, 1.0) * (b - a);
}

/// One face of a slab, of which mostly heights are asked.
class Face
{
public:
    Face(const Slab &slab, double offset, const Ground &ground)
        : m_ring(slab.region.outer), m_frame(slab.frame), m_shift(offset * slab.frame.normal()),
          m_ground(ground)
    {
        m_isLow.reserve(m_ring.size());
        const double base = ground.above(m_frame.origin + m_shift);
        const Vec2 up(ground.up.dot(m_frame.x), ground.up.dot(m_frame.y));
        for (const Vec2 &p : m_ring)
            m_isLow.push_back(base + up.dot(p) <= kGroundContact);
    }
    std::size_t count() const { return m_ring.size(); }
    bool isLow(std::size_t i) const { return m_isLow[i]; }
    Vec3 at(std::size_t i) const { return m_frame.toWorld(m_ring[i]) + m_shift; }
    /// The corners of what of the edge is low.
    void addLow(std::size_t a, std::size_t b, std::vector<Vec2> &corners) const
    {
        if (isLow(a))
            corners.push_back(onGround(at(a)));
        if (isLow(a) != isLow(b))
            corners.push_back(onGround(passing(at(a), at(b), m_ground)));
    }
    /// Where stretches begin and end that are low; of a ring that is low all round those of its
    /// hull.
    void addEnds(std::vector<Vec3> &ends) const
    {
        if (lowStretches() > 0 && std::find(m_isLow.begin(), m_isLow.end(), 0) == m_isLow.end()) {
            for (const Vec2 &corner : convexHull(m_ring))
                ends.push_back(m_frame.toWorld(corner) + m_shift);
            return;
        }
        for (std::size_t i = 0, j = count() - 1; i < count(); j = i++)
            if (isLow(i) != isLow(j))
                ends.push_back(passing(at(i), at(j), m_ground));
    }
    /// Stretches that are low; the whole ring is one.
    int lowStretches() const
    {
        int begins = 0;
        for (std::size_t i = 0, j = count() - 1; i < count(); j = i++)
            begins += isLow(i) && !isLow(j) ? 1 : 0;
        return begins == 0 && count() > 0 && isLow(0) ? 1 : begins;
    }

private:
    const Polygon &m_ring;
    const Frame &m_frame;
    Vec3 m_shift;
    const Ground &m_ground;
    std::vector<char> m_isLow;
};

void addContact(const Slab &slab, const Ground &ground, GroundContact &contact)
{
    const double half = 0.5 * slab.thickness;
    // The face that is lower; of an upright slab both are alike.
    const bool isUpper = slab.frame.normal().y() > 0.0;
    const Face low(slab, isUpper ? -half : half, ground),
        high(slab, isUpper ? half : -half, ground);
    contact.stretches += low.lowStretches();
    for (std::size_t i = 0, j = low.count() - 1; i < low.count(); j = i++) {
        low.addLow(j, i, contact.corners);
        high.addLow(j, i, contact.corners);
        if (low.isLow(i) && !high.isLow(i))
            contact.corners.push_back(onGround(passing(low.at(i), high.at(i), ground)));
    }
}

void measureHeights(const Slab &slab, GroundContact &contact)
{
    const Vec3 down =
        -std::abs(0.5 * slab.thickness) *
        (slab.frame.normal().y() < 0.0 ? Vec3(-slab.frame.normal()) : slab.frame.normal());
    const Vec2 up(slab.frame.x.y(), slab.frame.y.y());
    const Vec2 *lowest = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const Vec2 &p : slab.region.outer) {
        if (const double height = up.dot(p); height < least) {
            least = height;
            lowest = &p;
        }
    }
    if (!lowest)
        return;
    const Vec3 middle = slab.frame.toWorld(*lowest);
    contact.lowestMiddle = middle.y();
    contact.lowestPoint = middle + down;
    contact.lowest = contact.lowestPoint.y();
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

GroundContact contactOf(const Slab &slab, double level)
{
    GroundContact contact;
    measureHeights(slab, contact);
    if (contact.lowest <= level + kGroundContact) {
        addContact(slab, {Vec3::UnitY(), level}, contact);
        if (contact.corners.size() > kFewCorners)
            contact.corners = roughHull(contact.corners);
    }
    return contact;
}

std::vector<Vec3> feetOf(const Slab &slab, const Ground &ground)
{
    const double half = 0.5 * slab.thickness;
    std::vector<Vec3> feet;
    for (const double offset : {-half, half})
        Face(slab, offset, ground).addEnds(feet);
    for (Vec3 &foot : feet)
        foot -= ground.above(foot) * ground.up;
    return feet;
}

GroundContact together(std::span<const GroundContact *const> contacts)
{
    GroundContact all;
    for (const GroundContact *contact : contacts) {
        const bool isFirst = contact == contacts.front();
        if (isFirst || contact->lowest < all.lowest) {
            all.lowest = contact->lowest;
            all.lowestPoint = contact->lowestPoint;
        }
        all.lowestMiddle =
            isFirst ? contact->lowestMiddle : std::min(all.lowestMiddle, contact->lowestMiddle);
    }
    if (all.lowest > kGroundContact || all.lowestMiddle < -kGroundSunk)
        return all;
    for (const GroundContact *contact : contacts) {
        all.stretches += contact->stretches;
        all.corners.insert(all.corners.end(), contact->corners.begin(), contact->corners.end());
    }
    return all;
}

GroundContact groundContact(const std::vector<Slab> &slabs)
{
    std::vector<GroundContact> contacts;
    std::vector<const GroundContact *> pointers;
    contacts.reserve(slabs.size());
    for (const Slab &slab : slabs) {
        contacts.push_back(contactOf(slab));
        pointers.push_back(&contacts.back());
    }
    return together(pointers);
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
    result.nearest = nearest;
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
