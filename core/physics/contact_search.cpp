#include "core/physics/contact_search.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// Added to each stiffness on the diagonal, as a share of it (no unit): what moves freely then has
/// a pivot, and no answer changes, as the residual is taken without it.
constexpr double kSoftness = 1e-13;
/// Of the stiffest: what has no stiffness at all is taken for this when that share is added (no
/// unit).
constexpr double kLeastStiffness = 1e-6;
/// A pass that takes the slope down to this share went far enough (no unit).
constexpr double kEnoughDescent = 0.1;
/// Forces left over, as a share of the load, below which nothing is left to do (no unit).
constexpr double kNothingLeft = 1e-14;
/// The same once the springs that press are settled: refinement does the rest (no unit).
constexpr double kLittleLeft = 1e-9;
/// Reached in each step by conjugate gradients: refinement does the rest (no unit).
constexpr double kGradientError = 1e-8;
/// Factors that cost more than so many solutions are kept as long as they serve (no unit).
constexpr double kWorthGradients = 20.0;
constexpr int kMostPasses = 300;
constexpr int kPassesByGuess = 40; // after so many, every pass goes to the least along its way
constexpr int kMostRefinements = 8;

Eigen::Matrix3d crossMatrix(const Vec3 &v)
{
    Eigen::Matrix3d matrix;
    matrix << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
    return matrix;
}

std::vector<std::pair<int, int>> coupledPairs(const SpringNet &net)
{
    std::vector<std::pair<int, int>> pairs;
    for (const SpringNet::Joint &joint : net.joints)
        pairs.emplace_back(joint.a, joint.b);
    for (const auto *springs : {&net.holding, &net.pressing}) {
        for (const SpringNet::Spring &spring : *springs) {
            if (spring.b >= 0)
                pairs.emplace_back(spring.a, spring.b);
        }
    }
    return pairs;
}

void addSpring(const SpringNet::Spring &spring, BlockSystem &system)
{
    system.addDiagonal(spring.a, spring.stiffness * spring.rowA * spring.rowA.transpose());
    if (spring.b < 0)
        return;
    system.addDiagonal(spring.b, spring.stiffness * spring.rowB * spring.rowB.transpose());
    system.addCoupling(spring.a, spring.b,
                       spring.stiffness * spring.rowA * spring.rowB.transpose());
}

} // namespace

Block6 SpringNet::atPoint(const Vec3 &arm) const
{
    Block6 block = Block6::Zero();
    block.topLeftCorner<3, 3>().setIdentity();
    block.topRightCorner<3, 3>() = crossMatrix(-arm / size);
    block.bottomRightCorner<3, 3>().diagonal().setConstant(1.0 / size);
    return block;
}

Vec6 SpringNet::row(const Vec3 &arm, const Vec3 &direction) const
{
    Vec6 row;
    row << direction, arm.cross(direction) / size;
    return row;
}

ContactSearch::ContactSearch(SpringNet net)
    : m_net(std::move(net)), m_system(m_net.members, coupledPairs(m_net)),
      m_displacements(Eigen::VectorXd::Zero(m_system.size()))
{
    writeBase();
}

void ContactSearch::writeBase()
{
    m_system.clear();
    for (const SpringNet::Joint &joint : m_net.joints) {
        const Block6 toA = m_net.atPoint(joint.armA), toB = m_net.atPoint(joint.armB);
        const Block6 onA = toA.transpose() * joint.stiffness;
        m_system.addDiagonal(joint.a, onA * toA);
        m_system.addDiagonal(joint.b, toB.transpose() * joint.stiffness * toB);
        m_system.addCoupling(joint.a, joint.b, -onA * toB);
    }
    for (const SpringNet::Spring &spring : m_net.holding) {
        if (spring.isOn)
            addSpring(spring, m_system);
    }
    m_base = m_system.values();
    // As soft as the springs would make it all together, so that it hangs on no set of them.
    for (const SpringNet::Spring &spring : m_net.pressing)
        addSpring(spring, m_system);
    const Eigen::VectorXd diagonal = m_system.diagonal();
    m_soft = kSoftness * diagonal.cwiseMax(kLeastStiffness * diagonal.maxCoeff());
    m_system.setValues(m_base);
    m_system.addToDiagonal(m_soft);
    m_base = m_system.values();
    m_isWritten = m_hasFactors = false;
}

bool ContactSearch::replace(const SpringNet &net)
{
    if (net.members != m_net.members || net.pressing.size() != m_net.pressing.size() ||
        coupledPairs(net) != coupledPairs(m_net))
        return false;
    m_net = net;
    m_displacements.setZero();
    writeBase();
    return true;
}

void ContactSearch::hold(const std::vector<char> &isOn)
{
    bool isChanged = false;
    for (std::size_t i = 0; i < isOn.size(); ++i) {
        isChanged = isChanged || m_net.holding[i].isOn != static_cast<bool>(isOn[i]);
        m_net.holding[i].isOn = isOn[i];
    }
    if (isChanged)
        writeBase();
}

double ContactSearch::length(const SpringNet::Spring &spring,
                             const Eigen::VectorXd &displacements) const
{
    double sum = spring.rowA.dot(displacements.segment<6>(6 * spring.a));
    if (spring.b >= 0)
        sum += spring.rowB.dot(displacements.segment<6>(6 * spring.b));
    return sum;
}

std::vector<char> ContactSearch::pressingAt(const Eigen::VectorXd &displacements) const
{
    std::vector<char> active(m_net.pressing.size());
    for (std::size_t i = 0; i < active.size(); ++i)
        active[i] = length(m_net.pressing[i], displacements) <= m_net.pressing[i].start;
    return active;
}

/// The matrix is that of these springs; the factors too, or near enough. False when it has none.
bool ContactSearch::use(const std::vector<char> &active)
{
    if (!m_isWritten || m_active != active) {
        m_isWritten = true;
        m_active = active;
        m_system.setValues(m_base);
        for (std::size_t i = 0; i < active.size(); ++i) {
            if (active[i])
                addSpring(m_net.pressing[i], m_system);
        }
    }
    if (m_hasFactors && (m_factorised == m_active ||
                         m_system.factorisingWork() > kWorthGradients * m_system.solvingWork()))
        return true;
    return factorise();
}

bool ContactSearch::factorise()
{
    m_factorised = m_active;
    ++m_factorisations;
    m_hasFactors = m_system.factorise();
    return m_hasFactors;
}

Eigen::VectorXd ContactSearch::step(const Eigen::VectorXd &residual)
{
    if (m_factorised == m_active)
        return m_system.solved(residual);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(residual.size()), left = residual;
    Eigen::VectorXd z = m_system.solved(left), way = z;
    double size = left.dot(z);
    const double enough = kGradientError * residual.norm();
    const int most = static_cast<int>(m_system.factorisingWork() / m_system.solvingWork());
    for (int i = 0; i < most; ++i) {
        const Eigen::VectorXd image = m_system.times(way);
        const double share = size / way.dot(image);
        if (!(share > 0.0) || !std::isfinite(share))
            break;
        x += share * way;
        left -= share * image;
        if (left.norm() <= enough)
            return x;
        z = m_system.solved(left);
        const double next = left.dot(z);
        way = z + next / size * way;
        size = next;
    }
    factorise();
    return m_system.solved(residual);
}

/// What the forces of these springs change by with the displacements.
void ContactSearch::addForces(const Eigen::VectorXd &by, const std::vector<char> &active,
                              SpringForces &forces) const
{
    for (std::size_t i = 0; i < m_net.joints.size(); ++i) {
        const SpringNet::Joint &joint = m_net.joints[i];
        const Vec6 apart = m_net.atPoint(joint.armA) * by.segment<6>(6 * joint.a) -
                           m_net.atPoint(joint.armB) * by.segment<6>(6 * joint.b);
        forces.joints[i] -= joint.stiffness * apart;
    }
    for (std::size_t i = 0; i < m_net.holding.size(); ++i) {
        if (m_net.holding[i].isOn)
            forces.holding[i] -= m_net.holding[i].stiffness * length(m_net.holding[i], by);
    }
    for (std::size_t i = 0; i < m_net.pressing.size(); ++i) {
        if (active[i])
            forces.pressing[i] -= m_net.pressing[i].stiffness * length(m_net.pressing[i], by);
    }
}

SpringForces ContactSearch::forcesAt(const Eigen::VectorXd &displacements) const
{
    SpringForces forces{std::vector<Vec6>(m_net.joints.size(), Vec6::Zero()),
                        std::vector<double>(m_net.holding.size(), 0.0),
                        std::vector<double>(m_net.pressing.size(), 0.0), displacements, 0.0};
    const std::vector<char> active = pressingAt(displacements);
    for (std::size_t i = 0; i < active.size(); ++i) {
        if (active[i])
            forces.pressing[i] = m_net.pressing[i].stiffness * m_net.pressing[i].start;
    }
    addForces(displacements, active, forces);
    return forces;
}

/// Of the load, what the forces do not balance.
Eigen::VectorXd ContactSearch::leftOver(const Eigen::VectorXd &load,
                                        const SpringForces &forces) const
{
    Eigen::VectorXd left = load;
    for (std::size_t i = 0; i < m_net.joints.size(); ++i) {
        const SpringNet::Joint &joint = m_net.joints[i];
        left.segment<6>(6 * joint.a) += m_net.atPoint(joint.armA).transpose() * forces.joints[i];
        left.segment<6>(6 * joint.b) -= m_net.atPoint(joint.armB).transpose() * forces.joints[i];
    }
    const auto addAll = [&left](const std::vector<SpringNet::Spring> &springs,
                                const std::vector<double> &values) {
        for (std::size_t i = 0; i < springs.size(); ++i) {
            left.segment<6>(6 * springs[i].a) += values[i] * springs[i].rowA;
            if (springs[i].b >= 0)
                left.segment<6>(6 * springs[i].b) += values[i] * springs[i].rowB;
        }
    };
    addAll(m_net.holding, forces.holding);
    addAll(m_net.pressing, forces.pressing);
    return left;
}

/// How many times `way` to go from where it is to the least; `slope` is that of the start,
/// negative. Nothing when it goes down for ever.
std::optional<double> ContactSearch::leastAlong(const Eigen::VectorXd &way, double slope) const
{
    // The slope's own slope, and where springs begin or end to press.
    struct Turn
    {
        double at, change;
    };
    const double soft = m_soft.dot(way.cwiseAbs2());
    double bend = way.dot(m_system.times(way)) - soft;
    std::vector<Turn> turns;
    for (const SpringNet::Spring &spring : m_net.pressing) {
        const double rate = length(spring, way);
        const double stiff = spring.stiffness * rate * rate;
        const double gap = length(spring, m_displacements) - spring.start;
        if (rate != 0.0 && -gap / rate > 0.0)
            turns.push_back({-gap / rate, gap <= 0.0 ? -stiff : stiff});
    }
    std::sort(turns.begin(), turns.end(), [](const Turn &a, const Turn &b) { return a.at < b.at; });
    double at = 0.0;
    for (const Turn &turn : turns) {
        const double next = slope + bend * (turn.at - at);
        if (next >= 0.0)
            break;
        slope = next;
        at = turn.at;
        bend += turn.change;
    }
    if (bend <= 2.0 * soft)
        return {};
    return at - slope / bend;
}

/// Adds to the forces, not to the displacements: these may be so large that forces made from them
/// have lost their last digits.
void ContactSearch::refine(const Eigen::VectorXd &load, SpringForces &forces)
{
    const double scale = load.lpNorm<Eigen::Infinity>();
    Eigen::VectorXd left = leftOver(load, forces);
    forces.residual = left.lpNorm<Eigen::Infinity>();
    for (int i = 0; i < kMostRefinements && forces.residual > kNothingLeft * scale; ++i) {
        SpringForces better = forces;
        const Eigen::VectorXd by = step(left);
        addForces(by, m_active, better);
        for (double &force : better.pressing)
            force = std::max(0.0, force);
        better.displacements += by;
        left = leftOver(load, better);
        better.residual = left.lpNorm<Eigen::Infinity>();
        if (!(better.residual < forces.residual))
            break;
        forces = std::move(better);
    }
}

std::optional<SpringForces> ContactSearch::solve(const Eigen::VectorXd &load)
{
    m_factorisations = 0;
    const double scale = load.lpNorm<Eigen::Infinity>();
    std::vector<char> active = pressingAt(m_displacements);
    bool isSettled = false;
    for (m_passes = 1; m_passes <= kMostPasses; ++m_passes) {
        if (!use(active))
            break;
        const Eigen::VectorXd left = leftOver(load, forcesAt(m_displacements));
        const double remaining = left.lpNorm<Eigen::Infinity>();
        if (remaining <= (isSettled ? kLittleLeft : kNothingLeft) * scale)
            break;
        const Eigen::VectorXd way = step(left);
        const double slope = -left.dot(way);
        double share = 1.0;
        const double after = -leftOver(load, forcesAt(m_displacements + way)).dot(way);
        if (std::abs(after) > kEnoughDescent * std::abs(slope) || m_passes > kPassesByGuess) {
            const std::optional<double> least = leastAlong(way, slope);
            if (!least) {
                m_motion = way.normalized();
                m_displacements.setZero();
                return {};
            }
            share = *least;
        }
        m_displacements += share * way;
        std::vector<char> next = pressingAt(m_displacements);
        isSettled = next == active;
        active = std::move(next);
        if (isSettled && share == 1.0)
            break;
    }
    SpringForces forces = forcesAt(m_displacements);
    refine(load, forces);
    return forces;
}

} // namespace fff
