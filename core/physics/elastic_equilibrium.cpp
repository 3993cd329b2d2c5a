#include "core/physics/elastic_equilibrium.h"

#include "core/physics/elastic_energy.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

constexpr double kNoLoad = 1e-300; // N: keeps what is left of no load at all a number
/// Of the largest force: a pull beyond a grip by less is rounding (no unit).
constexpr double kGripSlack = 1e-9;

bool isOf(const Structure &structure, int member, const MemberAttachment &attachment)
{
    const bool isFoot = attachment.kind == MemberAttachment::Kind::Foot;
    const std::size_t count = isFoot ? structure.feet.size() : structure.links.size();
    const auto index = static_cast<std::size_t>(attachment.index);
    if (attachment.index < 0 || index >= count)
        return false;
    return isFoot ? structure.feet[index].member == member
                  : structure.links[index].a == member || structure.links[index].b == member;
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
        for (const MemberAttachment &at : attachments)
            if (!isOf(structure, static_cast<int>(i), at))
                return false;
    }
    return true;
}

/// What drives each member, about its centroid, moments over the size.
Eigen::VectorXd drivingLoads(const Structure &structure)
{
    Eigen::VectorXd loads =
        Eigen::VectorXd::Zero(6 * static_cast<Eigen::Index>(structure.members.size()));
    for (std::size_t i = 0; i < structure.members.size(); ++i)
        loads.segment<3>(6 * static_cast<Eigen::Index>(i)) +=
            structure.members[i].mass * structure.gravity;
    for (const MemberLoad &load : structure.loads) {
        const Vec3 &centroid = structure.members[static_cast<std::size_t>(load.member)].centroid;
        WrenchVector wrench;
        wrench << load.force, load.moment;
        wrench = movedTo(centroid, load.point, wrench);
        wrench.tail<3>() /= structure.size;
        loads.segment<6>(6 * static_cast<Eigen::Index>(load.member)) += wrench;
    }
    return loads;
}

} // namespace

Result<ElasticStructure> ElasticStructure::make(const Structure &structure,
                                                const std::vector<MemberFlexibility> &members)
{
    if (!fits(structure, members))
        return failure(ErrorCode::BadCount);
    ElasticStructure made(structure, members);
    if (!made.m_isFinite)
        return failure(ErrorCode::NonFinite);
    return made;
}

ElasticStructure::ElasticStructure(const Structure &structure,
                                   const std::vector<MemberFlexibility> &members)
    : m_structure(structure), m_chains(linkChains(structure)),
      m_boundOf(structure.links.size(), -1), m_loads(drivingLoads(structure).norm())
{
    EnergyProblem problem = elasticEnergy(structure, m_chains, members);
    m_isFinite = std::isfinite(m_loads) && isFinite(problem);
    for (std::size_t k = 0; k < structure.feet.size(); ++k)
        problem.bounds.push_back(footBound(m_chains, static_cast<int>(k)));
    for (std::size_t j = 0; j < structure.links.size(); ++j) {
        if (m_chains.links[j].chain < 0 || !std::isfinite(structure.links[j].grip))
            continue;
        m_boundOf[j] = static_cast<int>(problem.bounds.size());
        problem.bounds.push_back(gripBound(structure.links[j], m_chains.links[j]));
    }
    for (const LinkChains::Link &link : m_chains.links)
        problem.leastForce = std::max(problem.leastForce, link.rest.head<3>().norm());
    if (m_isFinite && !problem.sizes.empty())
        m_search.emplace(std::move(problem));
}

Result<ElasticEquilibrium> ElasticStructure::solve(FootHold hold, const LongWork &work)
{
    if (!m_search) {
        LeastEnergy nothing;
        nothing.isSettled = true;
        return told(nothing);
    }
    std::vector<int> zeros;
    for (std::size_t k = 0; hold == FootHold::Frictionless && k < m_structure.feet.size(); ++k) {
        const int first = firstOfFoot(m_chains, static_cast<int>(k));
        if (!m_structure.feet[k].isPinned)
            zeros.insert(zeros.end(), {first + 1, first + 2});
    }
    const LeastEnergy least = m_search->least(zeros, work);
    if (work.isStopped())
        return failure(ErrorCode::Cancelled);
    return told(least);
}

ElasticEquilibrium ElasticStructure::told(const LeastEnergy &least) const
{
    const Structure &structure = m_structure;
    ElasticEquilibrium result;
    result.passes = least.passes;
    result.isSettled = least.isSettled;
    Eigen::VectorXd left = drivingLoads(structure);
    const auto act = [&](int member, const Vec3 &point, const WrenchVector &wrench) {
        const auto i = static_cast<std::size_t>(member);
        WrenchVector moved = movedTo(structure.members[i].centroid, point, wrench);
        moved.tail<3>() /= structure.size;
        left.segment<6>(6 * static_cast<Eigen::Index>(i)) += moved;
    };
    double largest = least.unknowns.size() > 0 ? least.unknowns.cwiseAbs().maxCoeff() : 0.0;
    for (const LinkChains::Link &link : m_chains.links)
        largest = std::max(largest, link.rest.head<3>().norm());
    for (std::size_t j = 0; j < structure.links.size(); ++j) {
        const Link &link = structure.links[j];
        const WrenchVector wrench =
            wrenchOf(structure, m_chains, static_cast<int>(j), least.unknowns);
        const int bound = m_boundOf[j];
        result.links.push_back(wrench);
        result.isParted.push_back(bound >= 0 && least.isAtBound[static_cast<std::size_t>(bound)]);
        // What follows from statics alone nothing can share.
        if (bound < 0 &&
            wrench.head<3>().dot(link.axis.normalized()) - link.grip > kGripSlack * largest)
            result.isSettled = false;
        act(link.a, link.point, wrench);
        act(link.b, link.point, -wrench);
    }
    for (std::size_t k = 0; k < structure.feet.size(); ++k) {
        const Foot &foot = structure.feet[k];
        WrenchVector wrench = WrenchVector::Zero();
        wrench.head<3>() = footAxes(structure) *
                           least.unknowns.segment<3>(firstOfFoot(m_chains, static_cast<int>(k)));
        result.feet.push_back(wrench.head<3>());
        result.isLifted.push_back(least.isAtBound[k]);
        act(foot.member, foot.point, wrench);
    }
    for (Eigen::Index i = 0; i < left.size(); i += 6) {
        result.residual.push_back(left.segment<6>(i).norm() / std::max(m_loads, kNoLoad));
        result.worstResidual = std::max(result.worstResidual, result.residual.back());
    }
    return result;
}

Result<ElasticEquilibrium> elasticEquilibrium(const Structure &structure,
                                              const std::vector<MemberFlexibility> &members,
                                              FootHold hold, const LongWork &work)
{
    auto made = ElasticStructure::make(structure, members);
    if (!made)
        return tl::unexpected(made.error());
    return made->solve(hold, work);
}

} // namespace fff
