#include "core/analysis/body_plate.h"

#include <algorithm>

namespace fff {

namespace {

constexpr double kUsualPoisson = 0.3;      // no unit; of wood and plastics 0.3 to 0.4
constexpr double kCubicMillimetres = 1e-9; // m³

PlateAttachment attachmentOf(const PlateModel &model, const Link &link, bool isA,
                             const Frame &frame)
{
    const Vec2 at = frame.toLocal(link.point);
    const double partner = isA ? link.thicknessB : link.thicknessA;
    if (link.kind != LinkKind::Slits) {
        const Vec3 other = isA ? link.normalB : link.normalA;
        Vec2 along = frame.directionToLocal(other.cross(frame.normal()));
        along = along.norm() > 0.0 ? Vec2(along.normalized()) : Vec2(Vec2::UnitX());
        return slotAttachment(model, at, along, link.depthA, partner);
    }
    SlitAttachment slit;
    slit.inner = at;
    slit.opens = frame.directionToLocal(isA ? link.axis : Vec3(-link.axis));
    slit.depth = isA ? link.depthA : link.depthB;
    slit.heldDepth = isA ? link.depthB : link.depthA;
    slit.width = slit.heldWidth = partner;
    return slitAttachment(model, slit);
}

} // namespace

std::vector<BodyHold> holdsOf(const Structure &structure)
{
    std::vector<BodyHold> bodies(structure.members.size());
    const auto of = [&](int body) -> BodyHold & { return bodies[static_cast<std::size_t>(body)]; };
    for (std::size_t i = 0; i < structure.links.size(); ++i) {
        for (const int body : {structure.links[i].a, structure.links[i].b}) {
            of(body).at.push_back({MemberAttachment::Kind::Link, static_cast<int>(i)});
            of(body).links.push_back(structure.links[i]);
        }
    }
    for (std::size_t i = 0; i < structure.feet.size(); ++i) {
        const Foot &foot = structure.feet[i];
        of(foot.member).at.push_back({MemberAttachment::Kind::Foot, static_cast<int>(i)});
        of(foot.member).feet.push_back(foot.point);
    }
    for (const MemberLoad &load : structure.loads) {
        of(load.member).loadPoints.push_back(load.point);
        of(load.member).loadForces.push_back(load.force);
    }
    return bodies;
}

bool isHeldAlike(const BodyHold &a, const BodyHold &b)
{
    return a.feet == b.feet && a.loadPoints == b.loadPoints && a.loadForces == b.loadForces &&
           a.links.size() == b.links.size() &&
           std::equal(a.links.begin(), a.links.end(), b.links.begin(), [](Link x, Link y) {
               x.a = y.a;
               x.b = y.b;
               return x == y;
           });
}

void keepMeshesOf(const Bodies &bodies, PlateMeshes &meshes)
{
    if (meshes.empty())
        return;
    PlateMeshes used;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (auto found = meshes.extract(bodies.pointer(static_cast<int>(i))))
            used.insert(std::move(found));
    meshes = std::move(used);
}

Result<PlateModel> plateOf(const BodyPointer &body, const Stock &stock, PlateMeshes &meshes,
                           const LongWork &work)
{
    std::shared_ptr<const PlateMesh> &mesh = meshes[body];
    if (!mesh) {
        auto made = plateMesh(body->outline().region, {}, work);
        if (!made)
            return tl::unexpected(made.error());
        mesh = std::make_shared<const PlateMesh>(*std::move(made));
    }
    const PlateMaterial material(stock.thickness, modulusOf(stock), kUsualPoisson,
                                 stock.density * kCubicMillimetres);
    return PlateModel::make(*mesh, material, {}, work);
}

std::vector<PlateAttachment> attachmentsOf(const PlateModel &model, const BodyHold &hold, int index,
                                           const Body &body)
{
    const Frame &frame = body.frame();
    std::vector<PlateAttachment> attachments;
    for (const Link &link : hold.links)
        attachments.push_back(attachmentOf(model, link, link.a == index, frame));
    for (const Vec3 &foot : hold.feet)
        attachments.push_back(discAttachment(model, frame.toLocal(foot), 0.5 * body.thickness()));
    return attachments;
}

void addLoads(PlateField &field, const PlateModel &model, const BodyHold &hold, const Body &body)
{
    const Frame &frame = body.frame();
    for (std::size_t i = 0; i < hold.loadPoints.size(); ++i) {
        WrenchVector wrench = WrenchVector::Zero();
        wrench.head<3>() = inFrame(frame, hold.loadForces[i]);
        addWrench(field, model,
                  discAttachment(model, frame.toLocal(hold.loadPoints[i]), 0.5 * body.thickness()),
                  wrench);
    }
}

} // namespace fff
