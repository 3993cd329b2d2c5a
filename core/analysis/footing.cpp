#include "core/analysis/footing.h"

#include "core/geometry/convex_hull.h"

#include <algorithm>

namespace fff {

namespace {

using Group = std::vector<int>;

GroundContact contactOf(const Bodies &bodies, const Group &group)
{
    std::vector<const GroundContact *> contacts;
    for (const int section : group)
        for (const BodyPointer &body : bodies.of(section))
            contacts.push_back(&body->contact());
    GroundContact contact = together(contacts);
    contact.corners = convexHull(contact.corners);
    return contact;
}

/// The same as long as its sections' contacts are.
const GroundContact &refreshedContact(const Bodies &bodies, const Group &group,
                                      const CheckCaches &caches, CheckCaches::OfStance &stance)
{
    const auto isAsBefore = [&](int section) {
        return caches.sections[static_cast<std::size_t>(section)].contactsSince <= stance.since;
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
    for (const int section : group) {
        for (const BodyPointer &body : bodies.of(section)) {
            box.extend(body->box());
            thinnest = std::min(thinnest, body->thickness());
        }
    }
    if (box.isEmpty())
        return {};
    return stability(contact, mass.centre, thinnest, box.size().maxCoeff());
}

} // namespace

MassProperties loadedMass(const Analysis &analysis, const std::vector<int> &sections)
{
    const Model &model = analysis.model;
    MassProperties sum;
    for (const int section : sections) {
        const auto index = static_cast<std::size_t>(section);
        const Section &host = *model.section(index);
        sum += analysis.bodies.massOf(section);
        for (const Weight &weight : model.document.weights)
            if (weight.section == model.ref(index))
                sum += {weight.mass, host.frame.toWorld(weight.position)};
    }
    return sum;
}

Stability stabilityOf(const Analysis &analysis, const std::vector<int> &sections)
{
    return stabilityOf(analysis.bodies, sections, loadedMass(analysis, sections),
                       contactOf(analysis.bodies, sections));
}

Stability stabilityOf(const Analysis &analysis, const std::vector<int> &sections,
                      const MassProperties &mass, const CheckCaches &caches,
                      CheckCaches::OfStance &stance)
{
    return stabilityOf(analysis.bodies, sections, mass,
                       refreshedContact(analysis.bodies, sections, caches, stance));
}

} // namespace fff
