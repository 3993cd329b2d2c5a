#include "core/physics/fitting_motions.h"

#include "core/physics/link_compliance.h"

#include <Eigen/SparseCholesky>
#include <algorithm>

namespace fff {

namespace {

/// Of an equation: along the ground, where a foot slides, and of what nothing else says.
constexpr double kSliding = 1e-3, kAtRest = 1e-6;

/// Rows of unknown motions: six a member, rotations times the structure's size.
struct MotionEquations
{
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<double> right, weights;
    double size = 1.0;

    /// along: unit, of a displacement (or, `turns`, a rotation) at a point of a member
    void add(int member, const Vec3 &arm, const Vec3 &along, bool turns, double sign)
    {
        const int row = static_cast<int>(right.size());
        const Vec3 rotation = turns ? along : Vec3(arm.cross(along) / size);
        for (int k = 0; k < 3; ++k) {
            if (!turns)
                entries.emplace_back(row, 6 * member + k, sign * along[k]);
            entries.emplace_back(row, 6 * member + 3 + k, sign * rotation[k]);
        }
    }
    void close(double is, double weight)
    {
        right.push_back(is);
        weights.push_back(weight);
    }
};

/// Where a member's attachment has got to, or nowhere.
class GivesByPlace
{
public:
    GivesByPlace(const Structure &structure, const std::vector<MemberGive> &gives)
        : m_links(structure.links.size()), m_feet(structure.feet.size(), WrenchVector::Zero())
    {
        for (auto &pair : m_links)
            pair.fill(WrenchVector::Zero());
        for (std::size_t i = 0; i < gives.size(); ++i) {
            for (std::size_t k = 0; k < gives[i].attachments.size(); ++k) {
                const MemberAttachment &at = gives[i].attachments[k];
                const auto index = static_cast<std::size_t>(at.index);
                if (at.kind == MemberAttachment::Kind::Foot)
                    m_feet[index] = gives[i].moved[k];
                else
                    m_links[index][structure.links[index].a == static_cast<int>(i) ? 0 : 1] =
                        gives[i].moved[k];
            }
        }
    }
    WrenchVector apart(std::size_t link) const { return m_links[link][0] - m_links[link][1]; }
    Vec3 foot(std::size_t index) const { return m_feet[index].head<3>(); }

private:
    std::vector<std::array<WrenchVector, 2>> m_links;
    std::vector<WrenchVector> m_feet;
};

void addLinks(MotionEquations &equations, const Structure &structure, const GivesByPlace &gives,
              const Equilibrium &equilibrium)
{
    for (std::size_t i = 0; i < structure.links.size(); ++i) {
        const Link &link = structure.links[i];
        const Eigen::Matrix3d axes = linkAxes(link);
        const Eigen::Matrix<double, 6, 1> compliance = linkCompliance(link);
        const LinkForce &force = equilibrium.links[i];
        const WrenchVector apart = gives.apart(i);
        for (int k = 0; k < 6; ++k) {
            if (k == 2 && force.isOpen)
                continue;
            const bool turns = k >= 3;
            const Vec3 along = axes.col(k % 3);
            const double held = along.dot(turns ? force.onA.moment : force.onA.force);
            const double given = along.dot(turns ? Vec3(apart.tail<3>()) : Vec3(apart.head<3>()));
            for (const bool isA : {true, false}) {
                const int member = isA ? link.a : link.b;
                const Vec3 &centre = structure.members[static_cast<std::size_t>(member)].centroid;
                equations.add(member, link.point - centre, along, turns, isA ? 1.0 : -1.0);
            }
            equations.close((-compliance[k] * held - given) * (turns ? structure.size : 1.0), 1.0);
        }
    }
}

void addFeet(MotionEquations &equations, const Structure &structure, const GivesByPlace &gives,
             const Equilibrium &equilibrium)
{
    const Vec3 up = structure.up.normalized(), aside = up.unitOrthogonal();
    for (std::size_t i = 0; i < structure.feet.size(); ++i) {
        const Foot &foot = structure.feet[i];
        if (!equilibrium.feet[i].isPressing)
            continue;
        const Vec3 &centre = structure.members[static_cast<std::size_t>(foot.member)].centroid;
        for (const Vec3 &along : {up, aside, Vec3(up.cross(aside))}) {
            const bool isUp = along == up;
            equations.add(foot.member, foot.point - centre, along, false, 1.0);
            equations.close((isUp ? -equilibrium.feet[i].force.dot(up) / foot.stiffness : 0.0) -
                                along.dot(gives.foot(i)),
                            isUp || foot.isPinned ? 1.0 : kSliding);
        }
    }
}

} // namespace

FittingMotions fittingMotions(const Structure &structure, const std::vector<MemberGive> &gives,
                              const Equilibrium &equilibrium)
{
    FittingMotions result;
    const std::size_t count = structure.members.size();
    result.members.resize(count);
    if (count == 0)
        return result;
    MotionEquations equations;
    equations.size = structure.size;
    const GivesByPlace byPlace(structure, gives);
    addLinks(equations, structure, byPlace, equilibrium);
    addFeet(equations, structure, byPlace, equilibrium);

    const auto rows = static_cast<Eigen::Index>(equations.right.size());
    const auto unknowns = 6 * static_cast<Eigen::Index>(count);
    Eigen::SparseMatrix<double> matrix(rows, unknowns);
    matrix.setFromTriplets(equations.entries.begin(), equations.entries.end());
    const Eigen::Map<const Eigen::VectorXd> right(equations.right.data(), rows);
    const Eigen::Map<const Eigen::VectorXd> weights(equations.weights.data(), rows);
    const Eigen::SparseMatrix<double> weighted = weights.asDiagonal() * matrix;
    Eigen::SparseMatrix<double> normal = weighted.transpose() * weighted;
    for (Eigen::Index i = 0; i < unknowns; ++i)
        normal.coeffRef(i, i) += kAtRest * kAtRest;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(normal);
    if (factor.info() != Eigen::Success)
        return result;
    const Eigen::VectorXd wanted = weights.asDiagonal() * right;
    Eigen::VectorXd motion = factor.solve(weighted.transpose() * wanted);
    // The squares cost half of the digits; a second look gives them back.
    motion += factor.solve(weighted.transpose() * (wanted - weighted * motion));
    if (!motion.allFinite())
        return result;
    const Eigen::VectorXd gaps = matrix * motion - right;
    for (Eigen::Index i = 0; i < rows; ++i)
        if (weights[i] == 1.0)
            result.worstGap = std::max(result.worstGap, std::abs(gaps[i]));
    for (std::size_t i = 0; i < count; ++i) {
        const auto at = 6 * static_cast<Eigen::Index>(i);
        result.members[i] = {motion.segment<3>(at), motion.segment<3>(at + 3) / structure.size};
    }
    return result;
}

} // namespace fff
