#include "core/analysis/footing.h"

#include "core/model/placed_loads.h"

#include "core/geometry/convex_hull.h"

#include <algorithm>

namespace fff {

namespace {

using Group = std::vector<int>;

GroundContact contactOf(const Bodies &bodies, const Group &group)
{
    std::vector<const GroundContact *> contacts;
    for (const int body : group)
        contacts.push_back(&bodies.at(body).contact());
    GroundContact contact = together(contacts);
    contact.corners = convexHull(contact.corners);
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

Stability stabilityOf(const Bodies &bodies, const Group &group, const MassProperties &mass,
                      const GroundContact &contact)
{
    Box3 box;
    double thinnest = std::numeric_limits<double>::infinity();
    for (const int body : group) {
        box.extend(bodies.at(body).box());
        thinnest = std::min(thinnest, bodies.at(body).thickness());
    }
    if (box.isEmpty())
        return {};
    return stability(contact, mass.centre, thinnest, box.size().maxCoeff());
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

Stability stabilityOf(const Analysis &analysis, const std::vector<int> &group,
                      const MassProperties &mass, const CheckCaches &caches,
                      CheckCaches::OfStance &stance)
{
    return stabilityOf(analysis.bodies, group, mass,
                       refreshedContact(analysis.bodies, group, caches, stance));
}

} // namespace fff
