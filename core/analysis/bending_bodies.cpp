#include "core/analysis/bending_bodies.h"

#include "core/analysis/body_plate.h"
#include "core/physics/plate_flexibility.h"

namespace fff {

/// Where a body is held, and how it gives there; vectors of the world.
struct BendingBody
{
    BodyHold hold;
    PlateFlexibility own;       // under its own weight
    Eigen::VectorXd underLoads; // what its loads add to the deflection
};

namespace {

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

/// Fills in how it gives.
Result<void> fillIn(BendingBody &bending, int index, const Body &body, const PlateModel &model,
                    const Vec3 &gravity, const LongWork &work)
{
    const Frame &frame = body.frame();
    const BodyHold &hold = bending.hold;
    const std::vector<PlateAttachment> attachments = attachmentsOf(model, hold, index, body);
    PlateField weight = model.noField();
    model.addWeight(weight, inFrame(frame, gravity));
    PlateField loaded = weight;
    addLoads(loaded, model, hold, body);
    auto own = plateFlexibility(model, attachments, weight, work);
    auto all = own ? plateFlexibility(model, attachments, loaded, work) : own;
    if (!own || !all)
        return tl::unexpected(own ? all.error() : own.error());
    for (std::size_t k = 0; k < hold.feet.size(); ++k) {
        const auto block = static_cast<Eigen::Index>(hold.links.size() + k);
        const double height = frame.height(hold.feet[k]);
        moveTo(height, block, *own);
        moveTo(height, block, *all);
    }
    bending.own = own->inWorld(frame);
    bending.underLoads = all->inWorld(frame).deflection - bending.own.deflection;
    return {};
}

} // namespace

Result<BendingBodies> BendingBodies::of(const Analysis &analysis, const ModelStructure &made,
                                        Cache &cache, PlateMeshes &meshes, const LongWork &longWork)
{
    BendingBodies bodies;
    Cache used;
    const std::size_t count = analysis.bodies.size();
    std::vector<BodyHold> holds = holdsOf(made.structure);
    for (std::size_t i = 0; i < count; ++i) {
        const int index = static_cast<int>(i);
        const BodyPointer &body = analysis.bodies.pointer(index);
        BendingBody bending{std::move(holds[i]), {}, {}};
        if (longWork.isStopped())
            return failure(ErrorCode::Cancelled);
        if (bending.hold.at.size() < 2) { // one place gives nothing that could be shared
            bodies.m_bodies.push_back(nullptr);
            continue;
        }
        if (const auto known = cache.find(body);
            known != cache.end() && isHeldAlike(known->second->hold, bending.hold)) {
            bending.own = known->second->own;
            bending.underLoads = known->second->underLoads;
        } else {
            const Stock &stock =
                analysis.model.stockOf(static_cast<std::size_t>(analysis.bodies.sectionOf(index)));
            const Result<PlateModel> model = plateOf(body, stock, meshes, {longWork.stop, {}});
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
        members.back().attachments = body->hold.at;
        members.back().flexibility = body->own;
        members.back().flexibility.deflection += scale * body->underLoads;
    }
    return members;
}

} // namespace fff
