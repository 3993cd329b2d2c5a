#include "tests/core/physics/reference_plates.h"

#include "core/physics/plate_flexibility.h"

#include <cmath>

namespace fff::test {

namespace {

constexpr double kOnClampedPlane = 1e-4; // mm: files round
constexpr double kCubicMmInM3 = 1e-9;

WrenchVector wrenchOf(const Vec3 &force, const Vec3 &moment)
{
    WrenchVector wrench;
    wrench << force, moment;
    return wrench;
}

/// A clamp as the stretches of the outline that lie in its plane.
std::vector<PlateClamp> clampsOf(const ReferenceCase &found, int index,
                                 const ReferenceSection &section)
{
    std::vector<PlateClamp> clamps;
    for (const ReferenceClamp &clamp : found.clamps) {
        if (clamp.section != index)
            continue;
        const auto isOn = [&](const Vec2 &p) {
            return std::abs(clamp.normal.dot(section.frame.toWorld(p) - clamp.point)) <
                   kOnClampedPlane;
        };
        const Polygon &ring = section.regions.front().outer;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec2 &p = ring[i], &q = ring[(i + 1) % ring.size()];
            if (isOn(p) && isOn(q))
                clamps.push_back({p, q});
        }
    }
    return clamps;
}

PlateAttachment attachmentOf(const PlateModel &model, const ReferenceSection &section,
                             const Link &link, bool isA, const std::string &joint)
{
    SlitAttachment slit;
    slit.inner = section.frame.toLocal(link.point);
    slit.opens = section.frame.directionToLocal(isA ? link.axis : Vec3(-link.axis));
    slit.depth = isA ? link.depthA : link.depthB;
    slit.heldDepth = isA ? link.depthB : link.depthA;
    slit.width = slit.heldWidth = isA ? link.thicknessB : link.thicknessA;
    for (const ReferenceSlit &own : section.slits) {
        if (own.joint == joint && own.width > 0.0)
            slit.width = own.width;
    }
    return slitAttachment(model, slit);
}

void addHolds(const ReferenceCase &found, int index, ReferencePlate &plate)
{
    const ReferenceSection &section = found.sections[static_cast<std::size_t>(index)];
    const Structure &structure = found.structure;
    for (std::size_t j = 0; j < structure.links.size(); ++j) {
        const Link &link = structure.links[j];
        if (link.a != index && link.b != index)
            continue;
        plate.at.push_back({MemberAttachment::Kind::Link, static_cast<int>(j)});
        plate.attachments.push_back(
            attachmentOf(plate.model, section, link, link.a == index, found.joints[j]));
        plate.heights.push_back(section.frame.height(link.point));
    }
    for (std::size_t k = 0; k < structure.feet.size(); ++k) {
        const Foot &foot = structure.feet[k];
        if (foot.member != index)
            continue;
        plate.at.push_back({MemberAttachment::Kind::Foot, static_cast<int>(k)});
        plate.attachments.push_back(discAttachment(plate.model, section.frame.toLocal(foot.point),
                                                   0.5 * section.thickness));
        plate.heights.push_back(section.frame.height(foot.point));
    }
}

void addLoads(const ReferenceCase &found, int index, ReferencePlate &plate)
{
    const ReferenceSection &section = found.sections[static_cast<std::size_t>(index)];
    plate.loads = plate.model.noField();
    plate.model.addWeight(plate.loads, inFrameOf(section, found.structure.gravity));
    for (const ReferencePatch &patch : found.patches) {
        if (patch.load.member != index)
            continue;
        const Vec3 force = inFrameOf(section, patch.load.force);
        const Vec3 lever(0.0, 0.0, section.frame.height(patch.load.point));
        const double radius = patch.radius > 0.0 ? patch.radius : 0.5 * section.thickness;
        addWrench(plate.loads, plate.model,
                  discAttachment(plate.model, section.frame.toLocal(patch.load.point), radius),
                  wrenchOf(force, inFrameOf(section, patch.load.moment) + lever.cross(force)));
    }
}

/// What acts over the middle of the sheet also turns it.
Eigen::MatrixXd leversOf(const ReferencePlate &plate)
{
    const auto size = 6 * static_cast<Eigen::Index>(plate.at.size());
    Eigen::MatrixXd levers = Eigen::MatrixXd::Identity(size, size);
    for (std::size_t i = 0; i < plate.at.size(); ++i) {
        const auto row = 6 * static_cast<Eigen::Index>(i);
        // (0, 0, h) × F
        levers(row + 3, row + 1) = -plate.heights[i];
        levers(row + 4, row) = plate.heights[i];
    }
    return levers;
}

} // namespace

Result<ReferencePlate> plateOf(const ReferenceCase &found, int index,
                               const PlateMeshOptions &options)
{
    const ReferenceSection &section = found.sections[static_cast<std::size_t>(index)];
    auto mesh = plateMesh(section.regions.front(), options);
    if (!mesh)
        return tl::unexpected(mesh.error());
    auto model =
        PlateModel::make(*std::move(mesh),
                         {section.thickness, section.material.modulus, section.material.poisson,
                          section.material.density * kCubicMmInM3},
                         clampsOf(found, index, section));
    if (!model)
        return tl::unexpected(model.error());
    ReferencePlate plate{*std::move(model), {}, {}, {}, {}};
    addHolds(found, index, plate);
    addLoads(found, index, plate);
    return plate;
}

Result<std::vector<ReferencePlate>> platesOf(const ReferenceCase &found)
{
    std::vector<ReferencePlate> plates;
    for (std::size_t i = 0; i < found.sections.size(); ++i) {
        auto plate = plateOf(found, static_cast<int>(i));
        if (!plate)
            return tl::unexpected(plate.error());
        plates.push_back(*std::move(plate));
    }
    return plates;
}

std::vector<MemberFlexibility> flexibilitiesOf(const ReferenceCase &found,
                                               const std::vector<ReferencePlate> &plates)
{
    std::vector<MemberFlexibility> members;
    for (std::size_t i = 0; i < plates.size(); ++i) {
        const ReferencePlate &plate = plates[i];
        PlateFlexibility own =
            plateFlexibility(plate.model, plate.attachments, plate.loads).value();
        const Eigen::MatrixXd levers = leversOf(plate);
        own.compliance = levers.transpose() * own.compliance * levers;
        own.deflection = levers.transpose() * own.deflection;
        members.push_back({plate.at, own.inWorld(found.sections[i].frame)});
    }
    return members;
}

PlateStress stressOf(const ReferenceCase &found, const ReferencePlate &plate, int index,
                     const ReferenceForces &carried)
{
    const ReferenceSection &section = found.sections[static_cast<std::size_t>(index)];
    PlateField forces = plate.loads;
    for (std::size_t i = 0; i < plate.at.size(); ++i) {
        const auto k = static_cast<std::size_t>(plate.at[i].index);
        Wrench world;
        double sign = 1.0;
        if (plate.at[i].kind == MemberAttachment::Kind::Foot)
            world.force = carried.feet[k];
        else {
            world = carried.links[k];
            sign = found.structure.links[k].a == index ? 1.0 : -1.0;
        }
        const Vec3 force = sign * inFrameOf(section, world.force);
        const Vec3 lever(0.0, 0.0, plate.heights[i]);
        addWrench(forces, plate.model, plate.attachments[i],
                  wrenchOf(force, sign * inFrameOf(section, world.moment) + lever.cross(force)));
    }
    return plateStress(plate.model, plate.model.solve(forces));
}

} // namespace fff::test
