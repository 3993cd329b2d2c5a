#include "core/analysis/footing.h"

#include "core/model/placed_loads.h"

#include "core/assembly/settling.h"
#include "core/base/tolerances.h"
#include "core/geometry/convex_hull.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

using Group = std::vector<int>;

/// What carries is what is lowest: where a slab's face reaches below the ground it stands on that,
/// and what hangs no higher than it may be sunk comes down.
GroundContact contactOf(const Bodies &bodies, const Group &group)
{
    std::vector<const GroundContact *> contacts;
    for (const int body : group)
        contacts.push_back(&bodies.at(body).contact());
    GroundContact contact = together(contacts);
    const bool isSunk = contact.stretches > 0 && contact.lowest < -kGroundContact;
    if (isSunk || (contact.lowest > kGroundContact && contact.lowest <= kGroundSunk)) {
        contact.stretches = 0;
        contact.corners.clear();
        for (const int body : group) {
            if (bodies.at(body).contact().lowest > contact.lowest + kGroundContact)
                continue;
            const GroundContact low = contactOf(bodies.at(body).slab(), contact.lowest);
            contact.stretches += low.stretches;
            contact.corners.insert(contact.corners.end(), low.corners.begin(), low.corners.end());
        }
    }
    contact.corners = roughHull(contact.corners);
    return contact;
}

/// The same as long as the contacts of its bodies' sections are.
const GroundContact &refreshedContact(const Bodies &bodies, const Group &group,
                                      const CheckCaches &caches, CheckCaches::OfStance &stance)
{
    const auto isAsBefore = [&](int body) {
        const auto section = static_cast<std::size_t>(bodies.sectionOf(body));
        return caches.sections[section].contactsSince <= stance.since;
    };
    if (stance.group != group || !std::all_of(group.begin(), group.end(), isAsBefore))
        stance = {group, caches.count, contactOf(bodies, group)};
    return stance.contact;
}

/// Of what is low enough to touch the ground when the group leans as far as it may, and rocks from
/// there.
std::vector<Vec3> lowPoints(const Bodies &bodies, const Group &group, double lowest, double size)
{
    const double reach = lowest + kGroundContact + size * std::tan(2.0 * kFarthestLean);
    std::vector<Vec3> points;
    for (const int index : group)
        if (const Body &body = bodies.at(index); body.box().min.y() <= reach)
            for (const Vec3 &point : body.undermost())
                if (point.y() <= reach)
                    points.push_back(point);
    return points;
}

/// As it stands on these points, seen along its ground.
Stability onRest(const Rest &rest, const GroundContact &drawn, const Vec3 &centre, double thinnest,
                 double size)
{
    const Vec3 x = rest.ground.acrossX(), z = rest.ground.acrossZ();
    GroundContact contact = drawn;
    contact.corners.clear();
    for (const Vec3 &p : rest.contacts)
        contact.corners.emplace_back(centre.x() + x.dot(p - centre),
                                     centre.z() + z.dot(p - centre));
    Stability found =
        stability(contact, {centre.x(), rest.ground.above(centre), centre.z()}, thinnest, size);
    if (found.standing != Standing::LineSupport)
        found.standing = rest.tipAngle > 0.0 ? Standing::Stands : Standing::Topples;
    found.margin = rest.margin;
    found.tipAngle = std::max(0.0, rest.tipAngle);
    found.nearest = {centre.x() + x.dot(rest.edge - centre),
                     centre.z() + z.dot(rest.edge - centre)};
    const Vec2 out = found.nearest - Vec2(centre.x(), centre.z());
    if (out.norm() > kClipGrid)
        found.fall = out.normalized();
    found.ground = rest.ground;
    found.lean = rest.lean;
    found.rocking = rest.rocking;
    return found;
}

/// Of a group, the scale of what counts as a line.
struct GroupExtent
{
    GroupExtent(const Bodies &bodies, const Group &group)
    {
        Box3 box;
        for (const int body : group) {
            box.extend(bodies.at(body).box());
            thinnest = std::min(thinnest, bodies.at(body).thickness());
        }
        size = box.isEmpty() ? 0.0 : box.size().maxCoeff();
    }
    double thinnest = std::numeric_limits<double>::infinity(), size = 0.0; // mm
};

Stability drawnStability(const GroupExtent &extent, const Vec3 &centre,
                         const GroundContact &contact)
{
    if (extent.size == 0.0)
        return {};
    const bool isDrawnThere = std::abs(contact.lowest) <= kGroundContact;
    const Ground level{Vec3::UnitY(), isDrawnThere ? 0.0 : contact.lowest};
    Stability found =
        stability(contact, centre - level.height * Vec3::UnitY(), extent.thinnest, extent.size);
    found.ground = level;
    return found;
}

Stability stabilityOf(const Bodies &bodies, const Group &group, const MassProperties &mass,
                      const GroundContact &contact)
{
    const GroupExtent extent(bodies, group);
    const Stability drawn = drawnStability(extent, mass.centre, contact);
    if (contact.stretches == 0)
        return drawn;
    const auto rest = settle(lowPoints(bodies, group, contact.lowest, extent.size), mass.centre);
    if (!rest)
        return drawn;
    return onRest(*rest, contact, mass.centre, extent.thinnest, extent.size);
}

} // namespace

int bodyAt(const Bodies &bodies, int section, const Vec2 &point)
{
    int nearest = bodies.firstOf(section);
    double least = std::numeric_limits<double>::infinity();
    for (int body = nearest, end = nearest + bodies.countOf(section); body < end; ++body) {
        const Region &region = bodies.at(body).outline().region;
        if (locate(point, region) != Side::Outside)
            return body;
        if (const double distance = distanceTo(point, region); distance < least) {
            least = distance;
            nearest = body;
        }
    }
    return nearest;
}

MassProperties loadedMass(const Analysis &analysis, const std::vector<int> &group)
{
    const Model &model = analysis.model;
    const Bodies &bodies = analysis.bodies;
    MassProperties sum;
    for (const int body : group)
        sum += bodies.at(body).mass();
    // Of thousands of groups each looks at the loads of its own sections only.
    std::vector<int> sections = sectionsOf(bodies, group);
    std::sort(sections.begin(), sections.end());
    for (const PlacedLoad &placed : placedLoads(model)) {
        const Load &load = model.document.loads[static_cast<std::size_t>(placed.load)];
        if (load.isPush() || !std::binary_search(sections.begin(), sections.end(), placed.section))
            continue;
        const int body = bodyAt(bodies, placed.section, placed.position);
        if (std::find(group.begin(), group.end(), body) != group.end())
            sum += {load.mass,
                    bodies.at(body).frame().toWorld(placed.position) + load.height * Vec3::UnitY()};
    }
    return sum;
}

Stability stabilityOf(const Analysis &analysis, const std::vector<int> &group)
{
    return stabilityOf(analysis.bodies, group, loadedMass(analysis, group),
                       contactOf(analysis.bodies, group));
}

Stability asDrawn(const Analysis &analysis, const std::vector<int> &group)
{
    return drawnStability(GroupExtent(analysis.bodies, group), loadedMass(analysis, group).centre,
                          contactOf(analysis.bodies, group));
}

Stability stabilityOf(const Analysis &analysis, const std::vector<int> &group,
                      const MassProperties &mass, const CheckCaches &caches,
                      CheckCaches::OfStance &stance)
{
    return stabilityOf(analysis.bodies, group, mass,
                       refreshedContact(analysis.bodies, group, caches, stance));
}

} // namespace fff
