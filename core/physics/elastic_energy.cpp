#include "core/physics/elastic_energy.h"

#include "core/physics/link_compliance.h"

#include <algorithm>

namespace fff {

namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// What acts on a member at one place: `wrench` times the unknowns of a block, and `rest`, about
/// `point`.
struct Action
{
    Vec3 point = Vec3::Zero();
    int block = -1; // −1: nothing unknown
    int size = 0;   // of the block; further columns are nought
    Matrix6 wrench = Matrix6::Zero();
    WrenchVector rest = WrenchVector::Zero();
};

class EnergyBuilder
{
public:
    EnergyBuilder(const Structure &structure, const LinkChains &chains)
        : m_structure(structure), m_chains(chains)
    {
        m_problem.sizes.assign(chains.points.size(), 6);
        m_problem.sizes.resize(chains.points.size() + structure.feet.size(), 3);
        int count = 0;
        for (const int size : m_problem.sizes) {
            m_problem.own.push_back(Eigen::MatrixXd::Zero(size, size));
            m_starts.push_back(count);
            count += size;
        }
        m_problem.slope = Eigen::VectorXd::Zero(count);
        m_heldBy.resize(structure.members.size());
        for (std::size_t j = 0; j < structure.links.size(); ++j)
            for (const int member : {structure.links[j].a, structure.links[j].b})
                if (chains.links[j].chain >= 0)
                    m_heldBy[at(member)].push_back({MemberAttachment::Kind::Link, int(j)});
        for (std::size_t k = 0; k < structure.feet.size(); ++k)
            m_heldBy[at(structure.feet[k].member)].push_back(
                {MemberAttachment::Kind::Foot, int(k)});
    }

    void addJoints()
    {
        for (std::size_t j = 0; j < m_structure.links.size(); ++j) {
            const LinkChains::Link &chained = m_chains.links[j];
            const Link &link = m_structure.links[j];
            const Eigen::Matrix3d axes = linkAxes(link);
            const Eigen::Matrix<double, 6, 1> compliance = linkCompliance(link);
            Matrix6 gives = Matrix6::Zero();
            gives.topLeftCorner<3, 3>() =
                axes * compliance.head<3>().asDiagonal() * axes.transpose();
            gives.bottomRightCorner<3, 3>() =
                axes * compliance.tail<3>().asDiagonal() * axes.transpose();
            if (chained.chain < 0)
                continue;
            const Action action = actionOf({MemberAttachment::Kind::Link, int(j)}, link.a);
            m_problem.own[at(action.block)] += action.wrench.transpose() * gives * action.wrench;
            slopeOf(action) += action.wrench.transpose() * gives * action.rest;
        }
        for (std::size_t k = 0; k < m_structure.feet.size(); ++k)
            m_problem.own[m_chains.points.size() + k].diagonal().array() +=
                1.0 / m_structure.feet[k].stiffness;
    }

    /// flexibility  null: it is rigid
    void addMember(int member, const MemberFlexibility *flexibility)
    {
        EnergyPiece piece;
        std::vector<int> starts; // in the piece, of its blocks
        int size = 0;
        for (const MemberAttachment &held : m_heldBy[at(member)]) {
            const int block = actionOf(held, member).block;
            if (std::find(piece.blocks.begin(), piece.blocks.end(), block) != piece.blocks.end())
                continue;
            piece.blocks.push_back(block);
            starts.push_back(size);
            size += m_problem.sizes[at(block)];
        }
        if (piece.blocks.empty())
            return;
        m_starting.resize(m_problem.sizes.size());
        for (std::size_t i = 0; i < starts.size(); ++i)
            m_starting[at(piece.blocks[i])] = starts[i];
        piece.energy = Eigen::MatrixXd::Zero(size, size);
        if (flexibility)
            addFlexibility(member, *flexibility, piece.energy);
        if (m_chains.isBalanced[at(member)]) { // it has one chain
            m_problem.own[at(piece.blocks.front())] +=
                piece.energy.selfadjointView<Eigen::Lower>().toDenseMatrix();
            return;
        }
        piece.equations = Eigen::MatrixXd::Zero(6, size);
        addEquations(member, piece);
        m_problem.pieces.push_back(std::move(piece));
    }

    EnergyProblem take() && { return std::move(m_problem); }

private:
    static std::size_t at(int i) { return static_cast<std::size_t>(i); }

    Eigen::VectorBlock<Eigen::VectorXd> slopeOf(const Action &action)
    {
        return m_problem.slope.segment(m_starts[at(action.block)], action.size);
    }

    Action actionOf(const MemberAttachment &held, int member) const
    {
        Action action;
        if (held.kind == MemberAttachment::Kind::Foot) {
            action.point = m_structure.feet[at(held.index)].point;
            action.block = static_cast<int>(m_chains.points.size()) + held.index;
            action.size = 3;
            action.wrench.topLeftCorner<3, 3>() = footAxes(m_structure);
            return action;
        }
        const Link &link = m_structure.links[at(held.index)];
        const LinkChains::Link &chained = m_chains.links[at(held.index)];
        const double sign = link.a == member ? 1.0 : -1.0;
        action.point = link.point;
        action.rest = sign * chained.rest;
        if (chained.chain < 0)
            return action;
        action.block = chained.chain;
        action.size = 6;
        action.wrench.topLeftCorner<3, 3>() = sign * chained.side * Eigen::Matrix3d::Identity();
        action.wrench.bottomRightCorner<3, 3>() =
            sign * chained.side * m_structure.size * Eigen::Matrix3d::Identity();
        const Vec3 arm = sign * chained.side * (m_chains.points[at(chained.chain)] - link.point);
        for (int k = 0; k < 3; ++k)
            action.wrench.block<3, 1>(3, k) = arm.cross(Vec3(Vec3::Unit(k)));
        return action;
    }

    void addFlexibility(int member, const MemberFlexibility &flexibility, Eigen::MatrixXd &energy)
    {
        const PlateFlexibility &plate = flexibility.flexibility;
        std::vector<Action> actions;
        for (const MemberAttachment &attachment : flexibility.attachments)
            actions.push_back(actionOf(attachment, member));
        for (std::size_t i = 0; i < actions.size(); ++i) {
            const Action &rows = actions[i];
            if (rows.block < 0)
                continue;
            const auto row = 6 * static_cast<Eigen::Index>(i);
            const int first = m_starting[at(rows.block)];
            WrenchVector moved = plate.deflection.segment<6>(row);
            for (std::size_t j = 0; j < actions.size(); ++j) {
                const Action &columns = actions[j];
                const Matrix6 gives =
                    plate.compliance.block<6, 6>(row, 6 * static_cast<Eigen::Index>(j));
                moved.noalias() += gives * columns.rest;
                if (columns.block < 0 || m_starting[at(columns.block)] > first)
                    continue;
                Matrix6 half, whole;
                half.noalias() = gives * columns.wrench;
                whole.noalias() = rows.wrench.transpose() * half;
                energy.block(first, m_starting[at(columns.block)], rows.size, columns.size) +=
                    whole.topLeftCorner(rows.size, columns.size);
            }
            slopeOf(rows) += (rows.wrench.transpose() * moved).head(rows.size);
        }
    }

    void addEquations(int member, EnergyPiece &piece) const
    {
        const Vec3 &centroid = m_structure.members[at(member)].centroid;
        const auto scaled = [this](WrenchVector wrench) -> WrenchVector {
            wrench.tail<3>() /= m_structure.size;
            return wrench;
        };
        piece.constant = scaled(m_chains.rest[at(member)]);
        for (const MemberAttachment &held : m_heldBy[at(member)]) {
            const Action action = actionOf(held, member);
            piece.constant += scaled(movedTo(centroid, action.point, action.rest));
            for (int k = 0; k < action.size; ++k)
                piece.equations.col(m_starting[at(action.block)] + k) +=
                    scaled(movedTo(centroid, action.point, action.wrench.col(k)));
        }
    }

    const Structure &m_structure;
    const LinkChains &m_chains;
    EnergyProblem m_problem;
    std::vector<int> m_starts;                           // of blocks
    std::vector<std::vector<MemberAttachment>> m_heldBy; // of each member, what is unknown
    std::vector<int> m_starting;                         // of blocks, in the piece at hand
};

} // namespace

EnergyProblem elasticEnergy(const Structure &structure, const LinkChains &chains,
                            const std::vector<MemberFlexibility> &members)
{
    EnergyBuilder builder(structure, chains);
    builder.addJoints();
    for (std::size_t i = 0; i < structure.members.size(); ++i)
        builder.addMember(static_cast<int>(i), i < members.size() ? &members[i] : nullptr);
    return std::move(builder).take();
}

bool isFinite(const EnergyProblem &problem)
{
    const auto isKnown = [](const Eigen::MatrixXd &matrix) { return matrix.allFinite(); };
    return problem.slope.allFinite() &&
           std::all_of(problem.own.begin(), problem.own.end(), isKnown) &&
           std::all_of(problem.pieces.begin(), problem.pieces.end(), [](const EnergyPiece &piece) {
               return piece.energy.allFinite() && piece.equations.allFinite() &&
                      piece.constant.allFinite();
           });
}

Eigen::Matrix3d footAxes(const Structure &structure)
{
    const Vec3 up = structure.up.normalized(), aside = up.unitOrthogonal();
    Eigen::Matrix3d axes;
    axes << up, aside, up.cross(aside);
    return axes;
}

int firstOfFoot(const LinkChains &chains, int foot)
{
    return 6 * static_cast<int>(chains.points.size()) + 3 * foot;
}

WrenchVector wrenchOf(const Structure &structure, const LinkChains &chains, int link,
                      const Eigen::VectorXd &unknowns)
{
    const LinkChains::Link &chained = chains.links[static_cast<std::size_t>(link)];
    if (chained.chain < 0)
        return chained.rest;
    WrenchVector wrench = chained.side * unknowns.segment<6>(6 * chained.chain);
    wrench.tail<3>() *= structure.size;
    return movedTo(structure.links[static_cast<std::size_t>(link)].point,
                   chains.points[static_cast<std::size_t>(chained.chain)], wrench) +
           chained.rest;
}

EnergyBound footBound(const LinkChains &chains, int foot)
{
    return {EnergyBound::Kind::AtLeast, static_cast<int>(chains.points.size()) + foot,
            Eigen::Vector3d::Unit(0), 0.0, true};
}

EnergyBound gripBound(const Link &link, const LinkChains::Link &chained)
{
    const Vec3 axis = link.axis.normalized();
    Eigen::VectorXd direction = Eigen::VectorXd::Zero(6);
    direction.head<3>() = chained.side * axis;
    return {EnergyBound::Kind::AtMost, chained.chain, direction,
            link.grip - axis.dot(chained.rest.head<3>())};
}

} // namespace fff
