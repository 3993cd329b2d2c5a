#include "core/analysis/bending_bodies.h"

#include "core/physics/plate_flexibility.h"

namespace fff {

/// Where a body is held, and how it gives there; vectors of the world.
struct BendingBody
{
    std::vector<MemberAttachment> at;
    std::vector<Link> links; // of those, to tell whether the same holds it
    std::vector<Vec3> feet, loadPoints, loadForces;
    PlateFlexibility own;       // under its own weight
    Eigen::VectorXd underLoads; // what its loads add to the deflection
};

namespace {

constexpr double kUsualPoisson = 0.3;      // no unit; of wood and plastics 0.3 to 0.4
constexpr double kCubicMillimetres = 1e-9; // m³

/// What holds and loads each body.
std::vector<BendingBody> actingOn(const Structure &structure)
{
    std::vector<BendingBody> bodies(structure.members.size());
    const auto of = [&](int body) -> BendingBody & {
        return bodies[static_cast<std::size_t>(body)];
    };
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

/// But for the numbers of links and feet, which change with others.
bool isHeldAlike(const BendingBody &a, const BendingBody &b)
{
    return a.feet == b.feet && a.loadPoints == b.loadPoints && a.loadForces == b.loadForces &&
           a.links.size() == b.links.size() &&
           std::equal(a.links.begin(), a.links.end(), b.links.begin(), [](Link x, Link y) {
               x.a = y.a;
               x.b = y.b;
               return x == y;
           });
}

PlateAttachment attachmentOf(const PlateModel &model, const Link &link, bool isA,
                             const Frame &frame)
{
    const Vec2 at = frame.toLocal(link.point);
    const double partner = isA ? link.thicknessB : link.thicknessA;
    if (link.kind == LinkKind::Slot) {
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

/// A foot is on an edge of the sheet, its attachment in the middle of it: what displaces the one
/// also turns it about the other.
void moveTo(double height, Eigen::Index block, PlateFlexibility &flexibility)
{
    const Eigen::Index size = flexibility.deflection.size();
    Eigen::MatrixXd lever = Eigen::MatrixXd::Identity(size, size);
    // (0, 0, h) × F
    lever(6 * block + 3, 6 * block + 1) = -height;
    lever(6 * block + 4, 6 * block) = height;
    flexibility.compliance = lever.transpose() * flexibility.compliance * lever;
    flexibility.deflection = lever.transpose() * flexibility.deflection;
}

Result<PlateModel> plateOf(const Body &body, const Stock &stock, const LongWork &work)
{
    auto mesh = plateMesh(body.outline().region, {}, work);
    if (!mesh)
        return tl::unexpected(mesh.error());
    PlateMaterial material;
    material.thickness = stock.thickness;
    material.modulus = modulusOf(stock);
    material.poisson = kUsualPoisson;
    material.density = stock.density * kCubicMillimetres;
    return PlateModel::make(*std::move(mesh), material, {}, work);
}

/// Fills in how it gives.
Result<void> fillIn(BendingBody &bending, int index, const Body &body, const PlateModel &model,
                    const Vec3 &gravity, const LongWork &work)
{
    const Frame &frame = body.frame();
    std::vector<PlateAttachment> attachments;
    for (const Link &link : bending.links)
        attachments.push_back(attachmentOf(model, link, link.a == index, frame));
    for (const Vec3 &foot : bending.feet)
        attachments.push_back(discAttachment(model, frame.toLocal(foot), 0.5 * body.thickness()));
    PlateField weight = model.noField();
    model.addWeight(weight, inFrame(frame, gravity));
    PlateField loaded = weight;
    for (std::size_t i = 0; i < bending.loadPoints.size(); ++i) {
        WrenchVector wrench = WrenchVector::Zero();
        wrench.head<3>() = inFrame(frame, bending.loadForces[i]);
        addWrench(
            loaded, model,
            discAttachment(model, frame.toLocal(bending.loadPoints[i]), 0.5 * body.thickness()),
            wrench);
    }
    auto own = plateFlexibility(model, attachments, weight, work);
    auto all = own ? plateFlexibility(model, attachments, loaded, work) : own;
    if (!own || !all)
        return tl::unexpected(own ? all.error() : own.error());
    for (std::size_t k = 0; k < bending.feet.size(); ++k) {
        const auto block = static_cast<Eigen::Index>(bending.links.size() + k);
        const double height = frame.height(bending.feet[k]);
        moveTo(height, block, *own);
        moveTo(height, block, *all);
    }
    bending.own = own->inWorld(frame);
    bending.underLoads = all->inWorld(frame).deflection - bending.own.deflection;
    return {};
}

} // namespace

Result<BendingBodies> BendingBodies::of(const Analysis &analysis, const ModelStructure &made,
                                        Cache &cache, const LongWork &longWork)
{
    BendingBodies bodies;
    Cache used;
    const std::size_t count = analysis.bodies.size();
    std::vector<BendingBody> held = actingOn(made.structure);
    for (std::size_t i = 0; i < count; ++i) {
        const int index = static_cast<int>(i);
        const BodyPointer &body = analysis.bodies.pointer(index);
        BendingBody &bending = held[i];
        if (longWork.isStopped())
            return failure(ErrorCode::Cancelled);
        if (bending.at.size() < 2) { // one place gives nothing that could be shared
            bodies.m_bodies.push_back(nullptr);
            continue;
        }
        if (const auto known = cache.find(body);
            known != cache.end() && isHeldAlike(*known->second, bending)) {
            bending.own = known->second->own;
            bending.underLoads = known->second->underLoads;
        } else {
            const Stock &stock =
                analysis.model.stockOf(static_cast<std::size_t>(analysis.bodies.sectionOf(index)));
            const Result<PlateModel> model = plateOf(*body, stock, {longWork.stop, {}});
            const Result<void> worked = model ? fillIn(bending, index, *body, *model,
                                                       made.structure.gravity, {longWork.stop, {}})
                                              : tl::unexpected(model.error());
            if (!worked) {
                if (worked.error().code == ErrorCode::Cancelled)
                    return tl::unexpected(worked.error());
                bodies.m_stiff.push_back(index);
                bodies.m_bodies.push_back(nullptr);
                continue;
            }
        }
        bodies.m_bodies.push_back(std::make_shared<const BendingBody>(std::move(bending)));
        used[body] = bodies.m_bodies.back();
        longWork.tell(static_cast<double>(i + 1) / static_cast<double>(count));
    }
    cache = std::move(used);
    return bodies;
}

std::vector<MemberFlexibility> BendingBodies::under(double scale) const
{
    std::vector<MemberFlexibility> members;
    for (const auto &body : m_bodies) {
        members.emplace_back();
        if (!body)
            continue;
        members.back().attachments = body->at;
        members.back().flexibility = body->own;
        members.back().flexibility.deflection += scale * body->underLoads;
    }
    return members;
}

} // namespace fff
