#include "core/physics/cut_sides.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {
/// How far beyond a slit's root the force of a link is taken to be, mm: its root is on the
/// boundary.
constexpr double kBeyondRoot = 1e-3;
} // namespace

std::vector<ForceSite> forceSites(const SectionOutline &outline,
                                  const std::vector<AppliedForce> &forces, double thickness)
{
    std::vector<ForceSite> sites;
    sites.reserve(forces.size());
    for (const AppliedForce &force : forces) {
        ForceSite site;
        site.at = force.at;
        site.radius = std::max(0.0, force.radius);
        Vec2 inside = force.at;
        if (force.kind == ForceKind::Link) {
            inside -= kBeyondRoot * force.slit.opening;
            site.radius = std::max(site.radius, 0.5 * force.slit.width);
        }
        if (force.kind == ForceKind::Foot)
            site.radius = std::max(site.radius, 0.5 * thickness);
        site.held = held(outline, inside);
        sites.push_back(site);
    }
    return sites;
}

PlusShare plusShare(const LineCut &cut, const ForceSite &site)
{
    const bool isPlus = isOnPlusSide(cut, site.held);
    const double away = std::abs(cut.line.across(site.held.at));
    const PlusShare whole{isPlus ? 1.0 : 0.0, site.at};
    if (away >= site.radius)
        return whole;
    const double along = cut.line.along(site.at), slack = 0.5 * site.radius;
    if (along < cut.chords.front().from - slack || along > cut.chords.back().to + slack)
        return whole;
    // `away` on the side that the site is on: beyond the line lies the rest of its disc.
    const DiscPart plus = discBeyond(isPlus ? -away / site.radius : away / site.radius);
    return {plus.share, site.at + plus.away * site.radius * cut.normal()};
}

} // namespace fff
