#include "tests/core/physics/reference_section.h"

#include "core/geometry/moments.h"

namespace fff::test {

namespace {

constexpr double kCubicMm = 1e-9; // m³

const ReferenceSection &sectionAt(const ReferenceCase &found, int index)
{
    return found.sections[static_cast<std::size_t>(index)];
}

/// A force in space as one at the middle of the sheet.
AppliedForce applied(const ReferenceSection &section, ForceKind kind, const Vec3 &point,
                     const Vec3 &force, const Vec3 &moment, double radius)
{
    AppliedForce result;
    result.kind = kind;
    result.at = section.frame.toLocal(point);
    result.force = inFrameOf(section, force);
    result.moment =
        inFrameOf(section, moment) + Vec3(0, 0, section.frame.height(point)).cross(result.force);
    result.radius = radius;
    return result;
}

void addLinks(const ReferenceCase &found, int index, const ReferenceForces &carried,
              std::vector<AppliedForce> &forces)
{
    const ReferenceSection &section = sectionAt(found, index);
    for (std::size_t j = 0; j < found.structure.links.size(); ++j) {
        const Link &link = found.structure.links[j];
        if (link.a != index && link.b != index)
            continue;
        const double sign = link.a == index ? 1.0 : -1.0;
        AppliedForce force =
            applied(section, ForceKind::Link, link.point, sign * carried.links[j].force,
                    sign * carried.links[j].moment, 0.0);
        for (const ReferenceSlit &slit : section.slits) {
            if (slit.joint == found.joints[j])
                force.slit = {slit.innerEnd, slit.opening, slit.length, slit.width};
        }
        forces.push_back(force);
    }
}

/// The clamp carries what nothing else does.
void addClamp(const ReferenceCase &found, int index, ReferencePiece &piece)
{
    int clamps = 0;
    AppliedForce held;
    for (const ReferenceClamp &clamp : found.clamps) {
        if (clamp.section != index)
            continue;
        ++clamps;
        held.kind = ForceKind::Clamp;
        held.at = sectionAt(found, index).frame.toLocal(clamp.point);
    }
    piece.isClampedOnce = clamps <= 1;
    if (clamps == 0)
        return;
    const auto take = [&](const Vec2 &at, const Vec3 &force, const Vec3 &moment) {
        const Vec2 lever = at - held.at;
        held.force -= force;
        held.moment -= moment + Vec3(lever.x(), lever.y(), 0).cross(force);
    };
    for (const AppliedForce &force : piece.forces)
        take(force.at, force.force, force.moment);
    const ReferenceSection &section = sectionAt(found, index);
    take(section.frame.toLocal(section.mass.centre),
         section.mass.mass * inFrameOf(section, found.structure.gravity), Vec3::Zero());
    piece.forces.push_back(held);
}

} // namespace

std::optional<ReferenceForces> forcesOf(const ReferenceCase &found, const ReferenceTruth &truth)
{
    ReferenceForces forces{truth.reactions, {}};
    if (truth.reactions.size() != found.structure.feet.size())
        return {};
    for (const std::string &joint : found.joints) {
        const auto wrench = truth.joints.find(joint);
        if (wrench == truth.joints.end())
            return {};
        forces.links.push_back(wrench->second);
    }
    return forces;
}

ReferenceForces forcesOf(const Equilibrium &found)
{
    ReferenceForces forces;
    for (const FootForce &foot : found.feet)
        forces.feet.push_back(foot.force);
    for (const LinkForce &link : found.links)
        forces.links.push_back(link.onA);
    return forces;
}

ReferenceForces forcesOf(const ElasticEquilibrium &found)
{
    ReferenceForces forces{found.feet, {}};
    for (const WrenchVector &link : found.links)
        forces.links.push_back({link.head<3>(), link.tail<3>()});
    return forces;
}

Vec3 inFrameOf(const ReferenceSection &section, const Vec3 &world)
{
    return {section.frame.x.dot(world), section.frame.y.dot(world),
            section.frame.normal().dot(world)};
}

Vec3 arealWeightOf(const ReferenceCase &found, int index)
{
    const ReferenceSection &section = sectionAt(found, index);
    return section.material.density * kCubicMm * section.thickness *
           inFrameOf(section, found.structure.gravity);
}

ReferencePiece pieceOf(const ReferenceCase &found, int index, const ReferenceForces &carried)
{
    const ReferenceSection &section = sectionAt(found, index);
    ReferencePiece piece;
    std::vector<SlitLine> slits;
    for (const ReferenceSlit &slit : section.slits)
        slits.push_back({slit.innerEnd, slit.opening, slit.length, slit.width});
    for (const Region &region : section.regions)
        piece.shapes.emplace_back(region, slits);
    piece.sheet.thickness = section.thickness;
    piece.sheet.strength = section.material.tensileStrength;
    piece.sheet.modulus = section.material.modulus;
    piece.sheet.arealWeight = arealWeightOf(found, index);
    for (const ReferencePatch &patch : found.patches) {
        if (patch.load.member == index)
            piece.forces.push_back(applied(section, ForceKind::Load, patch.load.point,
                                           patch.load.force, patch.load.moment, patch.radius));
    }
    for (std::size_t k = 0; k < found.structure.feet.size(); ++k) {
        const Foot &foot = found.structure.feet[k];
        if (foot.member == index)
            piece.forces.push_back(
                applied(section, ForceKind::Foot, foot.point, carried.feet[k], Vec3::Zero(), 0.0));
    }
    addLinks(found, index, carried, piece.forces);
    addClamp(found, index, piece);
    return piece;
}

} // namespace fff::test
