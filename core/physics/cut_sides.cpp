#include "core/physics/cut_sides.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {
/// How far beyond a slit's root the force of a link is taken to be, mm: its root is on the
/// boundary.
constexpr double kBeyondRoot = 1e-3;
/// A force at a point is spread over as much, mm, and so parted by a cut right through it: on which
/// side of that it lies would be rounding.
constexpr double kLeastRadius = 1e-3;
/// Boundary that is farther than this many widths from where a slit's wall should be is none of it.
constexpr double kOffWall = 0.25;

bool isNear(const SlitWall &wall, double distance)
{
    const auto away = [](const HeldPoint &p) { return (p.anchor.at - p.at).norm(); };
    return std::max(away(wall.root), away(wall.mouth)) <= distance;
}

/// The walls of a slit, as far as the material has them.
void addWalls(const SectionOutline &outline, const SlitLine &slit, ForceSite &site)
{
    if (!(slit.depth > 0.0) || !(slit.width > 0.0))
        return;
    const Vec2 side = 0.5 * slit.width * perpendicular(slit.opening);
    const Vec2 mouth = slit.root + slit.depth * slit.opening;
    const auto wall = [&](const Vec2 &to) {
        const HeldPoint root = held(outline, slit.root + to, site.held.anchor.at);
        return SlitWall{root, held(outline, mouth + to, root.anchor.at)};
    };
    site.walls = {wall(side), wall(-side)};
    const bool hasLeft = isNear(site.walls[0], kOffWall * slit.width);
    const bool hasRight = isNear(site.walls[1], kOffWall * slit.width);
    site.hasWalls = hasLeft || hasRight;
    if (!hasLeft)
        site.walls[0] = site.walls[1];
    if (!hasRight)
        site.walls[1] = site.walls[0];
}

bool isAlong(const LineCut &cut, const SlitWall &wall)
{
    return std::max(std::abs(cut.line.across(wall.root.at)),
                    std::abs(cut.line.across(wall.mouth.at))) <= kOnCut;
}

/// `slit` is a place in it.
WallStretch plusStretch(const LineCut &cut, const SlitWall &wall, const Vec2 &slit)
{
    bool isRoot = isOnPlusSide(cut, wall.root), isMouth = isOnPlusSide(cut, wall.mouth);
    if (isAlong(cut, wall)) {
        // All of it is where its end beyond the cut is, or where the material behind it is.
        if (!liesOnCut(cut, wall.mouth.at))
            isRoot = isMouth;
        else if (!liesOnCut(cut, wall.root.at))
            isMouth = isRoot;
        else
            isRoot = isMouth = cut.line.across(slit) > 0.0;
    }
    if (isRoot == isMouth)
        return {0.0, isRoot ? 1.0 : 0.0};
    const double root = cut.line.across(wall.root.at), mouth = cut.line.across(wall.mouth.at);
    const double share = root != mouth ? std::clamp(root / (root - mouth), 0.0, 1.0) : 0.0;
    return isRoot ? WallStretch{0.0, share} : WallStretch{share, 1.0};
}
} // namespace

std::vector<ForceSite> forceSites(const SectionOutline &outline,
                                  const std::vector<AppliedForce> &forces, double thickness)
{
    std::vector<ForceSite> sites;
    sites.reserve(forces.size());
    for (const AppliedForce &force : forces) {
        ForceSite site;
        site.at = force.at;
        site.radius = std::max(kLeastRadius, force.radius);
        Vec2 inside = force.at;
        if (force.kind == ForceKind::Link)
            inside -= kBeyondRoot * force.slit.opening;
        site.held = held(outline, inside);
        if (force.kind == ForceKind::Link) {
            site.radius = std::max(site.radius, 0.5 * force.slit.width);
            addWalls(outline, force.slit, site);
        }
        if (force.kind == ForceKind::Foot)
            site.radius = std::max(site.radius, 0.5 * thickness);
        sites.push_back(site);
    }
    return sites;
}

namespace {

PlusShare plusDisc(const LineCut &cut, const ForceSite &site)
{
    const bool isPlus = isOnPlusSide(cut, site.held);
    const double away = std::abs(cut.line.across(site.held.at));
    PlusShare whole;
    whole.share = isPlus ? 1.0 : 0.0;
    whole.at = site.at;
    if (away >= site.radius)
        return whole;
    const double along = cut.line.along(site.at), slack = 0.5 * site.radius;
    if (along < cut.chords.front().from - slack || along > cut.chords.back().to + slack)
        return whole;
    // `away` on the side that the site is on: beyond the line lies the rest of its disc.
    const DiscPart plus = discBeyond(isPlus ? -away / site.radius : away / site.radius);
    PlusShare part;
    part.share = plus.share;
    part.at = site.at + plus.away * site.radius * cut.normal();
    return part;
}

} // namespace

PlusShare plusShare(const LineCut &cut, const ForceSite &site)
{
    PlusShare plus = plusDisc(cut, site);
    plus.hasWalls = site.hasWalls;
    for (std::size_t i = 0; site.hasWalls && i < plus.walls.size(); ++i)
        plus.walls[i] = plusStretch(cut, site.walls[i], site.at);
    return plus;
}

} // namespace fff
