#include "core/analysis/findings/upright_stand.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace fff {

std::optional<UprightStand> uprightStandOf(const Model &model, int section)
{
    const auto index = static_cast<std::size_t>(section);
    const Section &own = *model.section(index);
    const Vec3 normal = own.frame.normal();
    // Only a plate that stands upright has an edge to be made longer.
    if (std::abs(normal.y()) > kPracticallyParallel || !model.ref(index).drawn.isValid())
        return {};
    const Vec3 along = normal.cross(Vec3::UnitY()).normalized();
    UprightStand stand{section, Vec2(along.x(), along.z()), std::numeric_limits<double>::infinity(),
                       -std::numeric_limits<double>::infinity(),
                       Vec2(own.frame.origin.x(), own.frame.origin.z())};
    for (const Vec2 &p : own.shape->region().outer) {
        const Vec3 at = own.frame.toWorld(p);
        if (std::abs(at.y()) > kGroundSunk)
            continue;
        const double s = stand.placeOf(at);
        stand.from = std::min(stand.from, s);
        stand.to = std::max(stand.to, s);
    }
    return stand;
}

Vec2 onPlane(const Section &section, const UprightStand &stand, double s, double height)
{
    const Vec2 at = stand.at(s);
    return section.frame.toLocal(Vec3(at.x(), height, at.y()));
}

} // namespace fff
