#include "core/physics/cut_forces.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// What of a link's force is on a side: what walls bear on their stretches, the rest at its root.
void addLink(const SectionOutline &outline, const AppliedForce &link,
             const SummedForces::LinkParts &parts, const PlusShare &plus, SlitFit fit,
             SideForce &side)
{
    WallForce pressed;
    for (const bool isLeft : {true, false}) {
        const WallStretch &stretch = plus.walls[isLeft ? 0 : 1];
        const WallForce part = parts.pressure.on(isLeft, stretch.from, stretch.to, fit);
        pressed.force += part.force;
        pressed.moment += part.moment;
    }
    const Vec3 onWalls = pressed.force * parts.across;
    const Vec3 rest = plus.share * parts.rest;
    side.force += onWalls + rest;
    side.moment += momentOf(link.at - outline.base(), onWalls) + pressed.moment * Vec3::UnitZ();
    side.moment += plus.share * Vec3(link.moment.x(), link.moment.y(), 0.0) +
                   momentOf(plus.at - outline.base(), rest);
}

void addPart(const SectionOutline &outline, const SummedForces &forces, int place,
             const PlusShare &plus, SlitFit fit, SideForce &side)
{
    const AppliedForce &force = forces.at(place);
    if (plus.hasWalls)
        return addLink(outline, force, forces.linkAt(place), plus, fit, side);
    if (plus.share == 0.0)
        return;
    const Vec3 f = plus.share * force.force;
    side.force += f;
    side.moment += plus.share * force.moment + momentOf(plus.at - outline.base(), f);
}

SummedForces::LinkParts partsOf(const AppliedForce &link)
{
    const Vec2 e = perpendicular(link.slit.opening);
    const Vec3 across(e.x(), e.y(), 0.0);
    return {WallPressure(link), across, link.force - across.dot(link.force) * across};
}

SideForce allOf(const SectionOutline &outline, const AppliedForce &force)
{
    return {force.force, force.moment + momentOf(force.at - outline.base(), force.force)};
}

} // namespace

SummedForces::SummedForces(const SectionOutline &outline, const ForceSites &sites,
                           const std::vector<AppliedForce> &forces)
    : m_sites(sites), m_forces(forces)
{
    SideForce sum;
    int loaded = 0;
    m_sums.push_back(sum);
    m_loaded.push_back(loaded);
    m_links.resize(static_cast<std::size_t>(sites.size()));
    for (int place = 0; place < sites.size(); ++place) {
        const AppliedForce &force = at(place);
        sum += allOf(outline, force);
        loaded += force.force.isZero(0.0) && force.moment.isZero(0.0) ? 0 : 1;
        m_sums.push_back(sum);
        m_loaded.push_back(loaded);
        if (sites.at(place).hasWalls)
            m_links[static_cast<std::size_t>(place)] = partsOf(force);
    }
}

SideForce plusForce(const SectionOutline &outline, const LineCut &cut, const SummedForces &forces,
                    const PlusSitesView &plus, const Vec3 &arealWeight, SlitFit fit)
{
    SideForce side;
    side.force = cut.plus.area * arealWeight;
    side.moment = momentOf(cut.plus.first, arealWeight);
    // Stretch by stretch, around what is near, so that nothing is taken off again.
    const auto add = [&](int from, int to) {
        if (from < to)
            side += forces.sum(from, to);
    };
    auto near = plus.near.begin();
    for (const PlusSites::Run &run : plus.runs) {
        int from = run.begin;
        for (; near != plus.near.end() && near->place < run.end; ++near) {
            if (near->place < run.begin)
                continue;
            add(from, near->place);
            from = near->place + 1;
        }
        add(from, run.end);
    }
    for (const PlusSites::Near &one : plus.near)
        addPart(outline, forces, one.place, one.plus, fit, side);
    return side;
}

SideForce allForce(const SectionOutline &outline, const std::vector<AppliedForce> &forces,
                   const Vec3 &arealWeight)
{
    SideForce all;
    all.force = outline.total().area * arealWeight;
    all.moment = momentOf(outline.total().first, arealWeight);
    for (const AppliedForce &force : forces)
        all += allOf(outline, force);
    return all;
}

CutForces resolved(const SideForce &side, const Vec2 &base, const Vec2 &middle, const Vec2 &across)
{
    const Vec3 moment = side.momentAbout(middle, base);
    const Vec2 normal(across.y(), -across.x());
    CutForces result;
    result.axial = side.force.head<2>().dot(normal);
    result.shear = side.force.head<2>().dot(across);
    result.plate = side.force.z();
    result.inPlane = moment.z();
    result.bending = moment.head<2>().dot(across);
    result.torsion = moment.head<2>().dot(normal);
    return result;
}

CutForces forcesOn(const SectionOutline &outline, const LineCut &cut, int index, const Neck &neck,
                   const SideForce &side)
{
    if (cut.chords.size() == 1)
        return resolved(side, outline.base(), neck.middle(), neck.across);
    // Thickness drops out of all shares: lengths stand for areas.
    double length = 0.0, first = 0.0, cubes = 0.0, second = 0.0;
    for (const Chord &c : cut.chords) {
        const double l = c.length();
        length += l;
        first += l * 0.5 * (c.from + c.to);
        cubes += l * l * l;
    }
    const double middle = first / length;
    for (const Chord &c : cut.chords) {
        const double l = c.length(), away = 0.5 * (c.from + c.to) - middle;
        second += l * l * l / 12.0 + l * away * away;
    }
    const CutForces all = resolved(side, outline.base(), cut.line.at(middle), cut.line.direction);
    const Chord &chord = cut.chords[static_cast<std::size_t>(index)];
    const double l = chord.length(), away = 0.5 * (chord.from + chord.to) - middle;
    const double share = l / length, cube = l * l * l;
    CutForces part;
    part.axial = all.axial * share - all.inPlane * l * away / second;
    part.shear = all.shear * std::max(cube / cubes, share);
    part.plate = all.plate * share;
    part.inPlane =
        std::abs(all.inPlane) * cube / (12.0 * second) + std::abs(part.shear) * neck.halfOpening;
    part.bending = all.bending * share;
    part.torsion = all.torsion * share;
    // Into the frame of the chord's own neck.
    const double c = cut.line.direction.dot(neck.across);
    const double s = cross(cut.line.direction, neck.across);
    CutForces turned = part;
    turned.axial = c * part.axial + s * part.shear;
    turned.shear = c * part.shear - s * part.axial;
    turned.torsion = c * part.torsion + s * part.bending;
    turned.bending = c * part.bending - s * part.torsion;
    return turned;
}

} // namespace fff
