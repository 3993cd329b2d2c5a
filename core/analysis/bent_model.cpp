#include "core/analysis/bent_model.h"

#include "core/analysis/straining.h"
#include "core/physics/fitting_motions.h"
#include "core/physics/sparse_field.h"

#include <algorithm>
#include <cmath>

namespace fff {

/// What a body carries, and what comes of it; vectors of the world.
struct BentBody
{
    BodyHold hold;
    std::vector<std::vector<WrenchVector>> cases; // of each way to share: at each attachment
    double strength = 0.0;                        // MPa
    std::vector<double> cornerUses;               // of its mesh's sharp corners
    StressFieldPointer field, drawn;
    std::vector<WrenchVector> moved; // of each attachment
};

namespace {

/// Of the largest force or moment of all: what differs by less is not seen. Forces that are found
/// for all bodies together differ by rounding of that size wherever one is changed.
constexpr double kSameForce = 1e-7;
constexpr double kSameUse = 1e-4; // of a use at a corner, likewise
/// mm between a corner and the end of a line across it.
constexpr double kAtCorner = 0.25;

std::vector<WrenchVector> wrenchesOn(const BodyHold &hold, int body, const Equilibrium &equilibrium)
{
    std::vector<WrenchVector> wrenches;
    std::size_t link = 0;
    for (const MemberAttachment &at : hold.at) {
        const auto index = static_cast<std::size_t>(at.index);
        WrenchVector wrench = WrenchVector::Zero();
        if (at.kind == MemberAttachment::Kind::Foot) {
            wrench.head<3>() = equilibrium.feet[index].force;
        } else {
            const Wrench &onA = equilibrium.links[index].onA;
            wrench << onA.force, onA.moment;
            if (hold.links[link++].a != body)
                wrench = -wrench;
        }
        wrenches.push_back(wrench);
    }
    return wrenches;
}

/// Of a mesh's sharp corners: what the notch factor makes of lines that end there.
std::vector<double> cornerUses(const PlateMesh &mesh, const BodyStrength &body)
{
    std::vector<double> uses(mesh.sharp.size(), 0.0);
    for (const NeckStress &line : body.lines)
        for (std::size_t i = 0; line.stress.notch > 1.0 && i < uses.size(); ++i)
            if ((line.begin - mesh.sharp[i]).norm() < kAtCorner ||
                (line.end - mesh.sharp[i]).norm() < kAtCorner)
                uses[i] = std::max(uses[i], line.cornerUse);
    return uses;
}

bool areAlike(const std::vector<double> &a, const std::vector<double> &b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {
        return std::abs(x - y) <= kSameUse * std::max(x, y);
    });
}

/// The largest force or moment on any body, N or N·mm.
double largestForce(const Strength &strength)
{
    double largest = 0.0;
    for (const Equilibrium &equilibrium : strength.envelope) {
        for (const LinkForce &link : equilibrium.links)
            largest = std::max({largest, link.onA.force.norm(), link.onA.moment.norm()});
        for (const FootForce &foot : equilibrium.feet)
            largest = std::max(largest, foot.force.norm());
    }
    return largest;
}

/// But for differences of force up to `rounding`.
bool carriesTheSame(const BentBody &a, const BentBody &b, double rounding)
{
    if (a.strength != b.strength || !isHeldAlike(a.hold, b.hold) ||
        a.cases.size() != b.cases.size())
        return false;
    for (std::size_t k = 0; k < a.cases.size(); ++k)
        for (std::size_t i = 0; i < a.cases[k].size(); ++i)
            if (!((a.cases[k][i] - b.cases[k][i]).cwiseAbs().maxCoeff() <= rounding))
                return false;
    return true;
}

WrenchVector turned(const Frame &frame, const WrenchVector &wrench)
{
    WrenchVector result;
    result << inFrame(frame, wrench.head<3>()), inFrame(frame, wrench.tail<3>());
    return result;
}

WrenchVector turnedBack(const Frame &frame, const WrenchVector &wrench)
{
    Eigen::Matrix3d turn;
    turn << frame.x, frame.y, frame.normal();
    WrenchVector result;
    result << turn * wrench.head<3>(), turn * wrench.tail<3>();
    return result;
}

/// Feet stand on an edge of the sheet, their attachments are in the middle of it.
Vec3 footArm(const BodyHold &hold, std::size_t attachment, const Frame &frame)
{
    const std::size_t foot = attachment - hold.links.size();
    return attachment < hold.links.size() ? Vec3(Vec3::Zero())
                                          : Vec3(0.0, 0.0, frame.height(hold.feet[foot]));
}

void fillIn(BentBody &bent, int index, const Body &body, const PlateModel &model,
            const Vec3 &gravity)
{
    const Frame &frame = body.frame();
    const std::vector<PlateAttachment> attachments = attachmentsOf(model, bent.hold, index, body);
    PlateField same = model.noField();
    model.addWeight(same, inFrame(frame, gravity));
    addLoads(same, model, bent.hold, body);
    std::vector<PlateField> cases;
    for (const std::vector<WrenchVector> &wrenches : bent.cases) {
        PlateField forces = same;
        for (std::size_t i = 0; i < attachments.size(); ++i) {
            WrenchVector wrench = turned(frame, wrenches[i]);
            const Vec3 force = wrench.head<3>();
            wrench.tail<3>() += footArm(bent.hold, i, frame).cross(force);
            addWrench(forces, model, attachments[i], wrench);
        }
        cases.push_back(model.solve(forces));
    }
    bent.field = std::make_shared<const StressField>(
        stressField(model, cases, bent.strength, bent.cornerUses));
    bent.drawn = std::make_shared<const StressField>(sparseField(*bent.field));
    for (std::size_t i = 0; i < attachments.size(); ++i) {
        WrenchVector moved = attachmentMotion(model, cases.front(), attachments[i]);
        const Vec3 turn = moved.tail<3>();
        moved.head<3>() += turn.cross(footArm(bent.hold, i, frame));
        bent.moved.push_back(turnedBack(frame, moved));
    }
}

/// Where bodies get to, from how they give.
void setMotions(BentModel &model, const Strength &strength,
                const std::vector<std::shared_ptr<const BentBody>> &bodies)
{
    const Structure &structure = strength.made.structure;
    std::vector<MemberGive> gives(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        model.centroids.push_back(structure.members[i].centroid);
        if (bodies[i])
            gives[i] = {bodies[i]->hold.at, bodies[i]->moved};
    }
    FittingMotions fitting = fittingMotions(structure, gives, strength.equilibrium());
    model.motions = std::move(fitting.members);
    model.worstGap = fitting.worstGap;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        for (std::size_t k = 0; model.fields[i] && k < model.fields[i]->points.size(); ++k) {
            const double moved = model.moved(static_cast<int>(i), k).norm();
            if (moved > model.most) {
                model.most = moved;
                model.mostIn = static_cast<int>(i);
            }
        }
    }
}

} // namespace

Vec3 BentModel::moved(int body, std::size_t point) const
{
    return moved(body, *fields[static_cast<std::size_t>(body)], point);
}

Vec3 BentModel::moved(int body, const StressField &field, std::size_t point) const
{
    const auto i = static_cast<std::size_t>(body);
    const Frame &frame = analysis->bodies.at(body).frame();
    const Vec3 own = field.moved[point].cast<double>();
    const Vec3 at = frame.toWorld(field.points[point]) - centroids[i];
    return motions[i].translation + motions[i].rotation.cross(at) + own.x() * frame.x +
           own.y() * frame.y + own.z() * frame.normal();
}

Result<BentModel> bentModel(AnalysisPointer analysis, const Strength &strength,
                            StrengthCaches &caches, const LongWork &work)
{
    BentModel model;
    model.analysis = std::move(analysis);
    const Bodies &bodies = model.analysis->bodies;
    model.fields.resize(bodies.size());
    model.drawn.resize(bodies.size());
    std::vector<std::shared_ptr<const BentBody>> bent(bodies.size());
    std::vector<std::vector<char>> hasForces;
    for (const Equilibrium &equilibrium : strength.envelope)
        hasForces.push_back(bodiesWithForces(equilibrium, bodies.size()));
    std::vector<BodyHold> holds = holdsOf(strength.made.structure);
    const double rounding = kSameForce * largestForce(strength);
    std::map<BodyPointer, std::shared_ptr<const BentBody>> used;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const int index = static_cast<int>(i);
        const BodyStrength &known = strength.bodies[i];
        if (work.isStopped())
            return failure(ErrorCode::Cancelled);
        work.tell(static_cast<double>(i) / static_cast<double>(bodies.size()));
        if (!hasForces.front()[i] || !known.strength)
            continue;
        BentBody now{std::move(holds[i]), {}, *known.strength, {}, nullptr, nullptr, {}};
        for (std::size_t k = 0; k < strength.envelope.size(); ++k)
            if (hasForces[k][i])
                now.cases.push_back(wrenchesOn(now.hold, index, strength.envelope[k]));
        const BodyPointer &body = bodies.pointer(index);
        const auto before = caches.bent.find(body);
        if (const auto mesh = caches.meshes.find(body); mesh != caches.meshes.end() && mesh->second)
            now.cornerUses = cornerUses(*mesh->second, known);
        if (before != caches.bent.end() && carriesTheSame(*before->second, now, rounding) &&
            areAlike(before->second->cornerUses, now.cornerUses)) {
            now.field = before->second->field;
            now.drawn = before->second->drawn;
            now.moved = before->second->moved;
        } else {
            const Stock &stock =
                model.analysis->model.stockOf(static_cast<std::size_t>(bodies.sectionOf(index)));
            const Result<PlateModel> plate = plateOf(body, stock, caches.meshes, {work.stop, {}});
            if (!plate && plate.error().code == ErrorCode::Cancelled)
                return tl::unexpected(plate.error());
            if (!plate)
                continue;
            now.cornerUses = cornerUses(plate->mesh(), known);
            fillIn(now, index, *body, *plate, strength.made.structure.gravity);
        }
        model.fields[i] = now.field;
        model.drawn[i] = now.drawn;
        bent[i] = std::make_shared<const BentBody>(std::move(now));
        used[body] = bent[i];
    }
    caches.bent = std::move(used);
    setMotions(model, strength, bent);
    return model;
}

} // namespace fff
