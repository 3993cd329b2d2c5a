#include "core/physics/elastic_equilibrium.h"

#include "core/physics/least_energy.h"
#include "core/physics/link_compliance.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

constexpr double kNoLoad = 1e-300; // N: keeps what is left of no load at all a number

/// Some unknowns and the wrench that they are, in the world, at a point.
struct Action
{
    Vec3 point = Vec3::Zero();
    int first = 0;                                   // of its unknowns
    Eigen::Matrix<double, 6, Eigen::Dynamic> wrench; // 6 × unknowns
};

/// The unknowns of a structure: six a link in the link's axes, moments over the size; one a foot,
/// and two more where it, or every one, is pinned.
struct ElasticUnknowns
{
    std::vector<Action> links, feet;
    int count = 0;
};

ElasticUnknowns unknownsOf(const Structure &structure, FootHold hold)
{
    ElasticUnknowns result;
    for (const Link &link : structure.links) {
        Action action{link.point, result.count, {}};
        action.wrench.setZero(6, 6);
        action.wrench.topLeftCorner<3, 3>() = linkAxes(link);
        action.wrench.bottomRightCorner<3, 3>() = structure.size * linkAxes(link);
        result.count += 6;
        result.links.push_back(std::move(action));
    }
    const Vec3 up = structure.up.normalized(), aside = up.unitOrthogonal();
    for (const Foot &foot : structure.feet) {
        Action action{foot.point, result.count, {}};
        const bool isPinned = hold == FootHold::Pinned || foot.isPinned;
        action.wrench.setZero(6, isPinned ? 3 : 1);
        action.wrench.col(0).head<3>() = up;
        if (isPinned) {
            action.wrench.col(1).head<3>() = aside;
            action.wrench.col(2).head<3>() = up.cross(aside);
        }
        result.count += static_cast<int>(action.wrench.cols());
        result.feet.push_back(std::move(action));
    }
    return result;
}

using Entries = std::vector<Eigen::Triplet<double>>;

template <class Block>
void addBlock(Entries &entries, int row, int column, const Block &block)
{
    for (int j = 0; j < static_cast<int>(block.cols()); ++j) {
        for (int i = 0; i < static_cast<int>(block.rows()); ++i) {
            if (block(i, j) != 0.0)
                entries.emplace_back(row + i, column + j, block(i, j));
        }
    }
}

/// A wrench about `point` as force and moment about `centre`, the moment over `size`.
template <class Columns>
Eigen::Matrix<double, 6, Eigen::Dynamic> shifted(const Columns &wrench, const Vec3 &point,
                                                 const Vec3 &centre, double size)
{
    Eigen::Matrix<double, 6, Eigen::Dynamic> result = wrench;
    for (Eigen::Index k = 0; k < result.cols(); ++k) {
        const Vec3 force = result.col(k).template head<3>();
        result.col(k).template tail<3>() += (point - centre).cross(force);
    }
    result.bottomRows(3) /= size;
    return result;
}

void setEquations(EnergyProblem &problem, const Structure &structure,
                  const ElasticUnknowns &unknowns)
{
    Entries entries;
    const auto add = [&](int member, const Action &action, double sign) {
        const Vec3 &centre = structure.members[static_cast<std::size_t>(member)].centroid;
        addBlock(entries, 6 * member, action.first,
                 (sign * shifted(action.wrench, action.point, centre, structure.size)).eval());
    };
    for (std::size_t j = 0; j < structure.links.size(); ++j) {
        add(structure.links[j].a, unknowns.links[j], 1.0);
        add(structure.links[j].b, unknowns.links[j], -1.0);
    }
    for (std::size_t k = 0; k < structure.feet.size(); ++k)
        add(structure.feet[k].member, unknowns.feet[k], 1.0);
    const auto rows = 6 * static_cast<Eigen::Index>(structure.members.size());
    problem.equations.resize(rows, unknowns.count);
    problem.equations.setFromTriplets(entries.begin(), entries.end());

    problem.constant.setZero(rows);
    for (std::size_t i = 0; i < structure.members.size(); ++i)
        problem.constant.segment<3>(6 * static_cast<Eigen::Index>(i)) +=
            structure.members[i].mass * structure.gravity;
    for (const MemberLoad &load : structure.loads) {
        WrenchVector wrench;
        wrench << load.force, load.moment;
        const Vec3 &centre = structure.members[static_cast<std::size_t>(load.member)].centroid;
        problem.constant.segment<6>(6 * load.member) +=
            shifted(wrench, load.point, centre, structure.size);
    }
}

/// The action at an attachment of a member, and its sign there.
std::pair<const Action *, double> actionAt(const Structure &structure,
                                           const ElasticUnknowns &unknowns, int member,
                                           const MemberAttachment &attachment)
{
    const auto index = static_cast<std::size_t>(attachment.index);
    if (attachment.kind == MemberAttachment::Kind::Foot)
        return {&unknowns.feet[index], 1.0};
    return {&unknowns.links[index], structure.links[index].a == member ? 1.0 : -1.0};
}

void addFlexibility(Entries &entries, Eigen::VectorXd &slope, const Structure &structure,
                    const ElasticUnknowns &unknowns, int member,
                    const MemberFlexibility &flexibility)
{
    const std::size_t n = flexibility.attachments.size();
    const PlateFlexibility &plate = flexibility.flexibility;
    for (std::size_t i = 0; i < n; ++i) {
        const auto [rows, rowSign] =
            actionAt(structure, unknowns, member, flexibility.attachments[i]);
        const auto row = 6 * static_cast<Eigen::Index>(i);
        slope.segment(rows->first, rows->wrench.cols()) +=
            rowSign * rows->wrench.transpose() * plate.deflection.segment<6>(row);
        for (std::size_t j = 0; j < n; ++j) {
            const auto [columns, columnSign] =
                actionAt(structure, unknowns, member, flexibility.attachments[j]);
            const auto column = 6 * static_cast<Eigen::Index>(j);
            addBlock(entries, rows->first, columns->first,
                     (rowSign * columnSign * rows->wrench.transpose() *
                      plate.compliance.block<6, 6>(row, column) * columns->wrench)
                         .eval());
        }
    }
}

void setEnergy(EnergyProblem &problem, const Structure &structure, const ElasticUnknowns &unknowns,
               const std::vector<MemberFlexibility> &members)
{
    Entries entries;
    problem.slope.setZero(unknowns.count);
    for (std::size_t j = 0; j < structure.links.size(); ++j) {
        Eigen::Matrix<double, 6, 1> compliance = linkCompliance(structure.links[j]);
        compliance.tail<3>() *= structure.size * structure.size;
        for (int k = 0; k < 6; ++k) {
            const int at = unknowns.links[j].first + k;
            entries.emplace_back(at, at, compliance[k]);
        }
    }
    for (std::size_t k = 0; k < structure.feet.size(); ++k) {
        for (int i = 0; i < static_cast<int>(unknowns.feet[k].wrench.cols()); ++i) {
            const int at = unknowns.feet[k].first + i;
            entries.emplace_back(at, at, 1.0 / structure.feet[k].stiffness);
        }
    }
    for (std::size_t i = 0; i < members.size(); ++i)
        addFlexibility(entries, problem.slope, structure, unknowns, static_cast<int>(i),
                       members[i]);
    problem.energy.resize(unknowns.count, unknowns.count);
    problem.energy.setFromTriplets(entries.begin(), entries.end());
}

void setBounds(EnergyProblem &problem, const Structure &structure, const ElasticUnknowns &unknowns)
{
    problem.bounds.assign(static_cast<std::size_t>(unknowns.count), {});
    const auto bound = [&](int unknown) -> EnergyBound & {
        return problem.bounds[static_cast<std::size_t>(unknown)];
    };
    for (std::size_t j = 0; j < structure.links.size(); ++j) {
        if (std::isfinite(structure.links[j].grip))
            bound(unknowns.links[j].first + 2) = {EnergyBound::Kind::AtMost,
                                                  structure.links[j].grip, -1};
    }
    for (const Action &foot : unknowns.feet) {
        bound(foot.first).kind = EnergyBound::Kind::AtLeast;
        for (int i = 1; i < static_cast<int>(foot.wrench.cols()); ++i)
            bound(foot.first + i).follows = foot.first;
    }
}

bool fits(const Structure &structure, const std::vector<MemberFlexibility> &members)
{
    if (!members.empty() && members.size() != structure.members.size())
        return false;
    for (std::size_t i = 0; i < members.size(); ++i) {
        const auto &[attachments, plate] = members[i];
        const auto rows = 6 * static_cast<Eigen::Index>(attachments.size());
        if (plate.deflection.size() != rows || plate.compliance.rows() != rows ||
            plate.compliance.cols() != rows)
            return false;
        for (const MemberAttachment &at : attachments) {
            const bool isFoot = at.kind == MemberAttachment::Kind::Foot;
            const std::size_t count = isFoot ? structure.feet.size() : structure.links.size();
            if (at.index < 0 || static_cast<std::size_t>(at.index) >= count)
                return false;
        }
    }
    return true;
}

ElasticEquilibrium told(const LeastEnergy &least, const Structure &structure,
                        const ElasticUnknowns &unknowns, double scale)
{
    ElasticEquilibrium result;
    const auto wrench = [&](const Action &action) -> WrenchVector {
        return action.wrench * least.unknowns.segment(action.first, action.wrench.cols());
    };
    for (const Action &link : unknowns.links) {
        result.links.push_back(wrench(link));
        result.isParted.push_back(least.isAtBound[static_cast<std::size_t>(link.first + 2)]);
    }
    for (const Action &foot : unknowns.feet) {
        result.feet.push_back(wrench(foot).head<3>());
        result.isLifted.push_back(least.isAtBound[static_cast<std::size_t>(foot.first)]);
    }
    for (std::size_t i = 0; i < structure.members.size(); ++i) {
        const double rest =
            least.residual.segment<6>(6 * static_cast<Eigen::Index>(i)).norm() / scale;
        result.residual.push_back(rest);
        result.worstResidual = std::max(result.worstResidual, rest);
    }
    result.passes = least.passes;
    result.isSettled = least.isSettled;
    return result;
}

} // namespace

Result<ElasticEquilibrium> elasticEquilibrium(const Structure &structure,
                                              const std::vector<MemberFlexibility> &members,
                                              FootHold hold, const LongWork &work)
{
    if (!fits(structure, members))
        return failure(ErrorCode::BadCount);
    const ElasticUnknowns unknowns = unknownsOf(structure, hold);
    EnergyProblem problem;
    setEnergy(problem, structure, unknowns, members);
    setEquations(problem, structure, unknowns);
    setBounds(problem, structure, unknowns);
    const Eigen::Map<const Eigen::VectorXd> energies(problem.energy.valuePtr(),
                                                     problem.energy.nonZeros());
    if (!energies.allFinite() || !problem.constant.allFinite() || !problem.slope.allFinite())
        return failure(ErrorCode::NonFinite);
    if (unknowns.count == 0) {
        ElasticEquilibrium none;
        none.isSettled = true;
        none.residual.assign(structure.members.size(), problem.constant.isZero(0.0) ? 0.0 : 1.0);
        none.worstResidual = problem.constant.isZero(0.0) ? 0.0 : 1.0;
        return none;
    }
    const LeastEnergy least = leastEnergy(problem, work);
    if (work.isStopped())
        return failure(ErrorCode::Cancelled);
    return told(least, structure, unknowns, std::max(problem.constant.norm(), kNoLoad));
}

} // namespace fff
