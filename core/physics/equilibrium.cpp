#include "core/physics/equilibrium.h"

#include "core/physics/component_net.h"
#include "core/physics/indeterminacy.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace fff {

/// The net as it was asked for, and its solver, whose springs may have been let go since.
struct EquilibriumCache::Kept
{
    SpringNet net;
    std::optional<ContactSearch> search;
};

namespace {

/// A pull beyond the grip by less than this share of all forces is rounding (no unit).
constexpr double kPullRounding = 1e-9;
/// Members that move by less than this share of the farthest do not (no unit).
constexpr double kStandsStill = 1e-3;
/// Feet that are held horizontally while they press: so many times it is looked which do.
constexpr int kMostHoldings = 8;
constexpr double kThickest = 1e6; // mm
/// Of the ground, on which what has hinges must not fold: 3°, as a tangent. A sheet of 3 mm that
/// stands on its own edge falls at less.
constexpr double kLean = 0.052;

/// The structure with everything finite; what is not sound stays out by isSound().
Structure soundCopy(Structure structure)
{
    for (Member &member : structure.members) {
        if (!isSound(member))
            member = {std::isfinite(member.mass) ? std::max(0.0, member.mass) : 0.0,
                      member.centroid.allFinite() ? member.centroid : Vec3::Zero()};
    }
    if (!structure.gravity.allFinite())
        structure.gravity.setZero();
    if (!structure.up.allFinite() || !(structure.up.norm() > 0.0))
        structure.up = Structure().up;
    if (!std::isfinite(structure.thickness))
        structure.thickness = Structure().thickness;
    if (!std::isfinite(structure.size) || !(structure.size > 0.0))
        structure.size = Structure().size;
    structure.up.normalize();
    structure.thickness = std::clamp(structure.thickness, 0.0, kThickest);
    return structure;
}

/// One component, solved in one of the ways.
class ComponentSolver
{
public:
    ComponentSolver(const Structure &structure, const Support &support, EquilibriumCache &cache,
                    ComponentState &state, Equilibrium &result)
        : m_structure(structure), m_support(support), m_cache(cache), m_state(state),
          m_result(result)
    {
    }

    void solve()
    {
        std::optional<SpringForces> forces = search(false);
        if (!forces) {
            // The rigid body test and this can differ by rounding only, unless links turn or pins
            // are lifted.
            if (m_arePinsLifted)
                m_state.balance = Balance::Slides;
            else
                m_state.balance =
                    m_support.isAxisFree || hasFingers() ? Balance::Mechanism : Balance::Topples;
            return;
        }
        write(*forces);
        if (!m_support.isGripUnlimited)
            letGo();
        if (m_state.balance != Balance::Mechanism && hasFingers() && folds()) {
            m_state.balance = Balance::Mechanism;
            m_state.openLinks.clear();
        }
    }

private:
    /// Links that are asked for more than their grip give way.
    void letGo()
    {
        for (std::size_t i = 0; i < m_state.parts.links.size(); ++i) {
            const int link = m_state.parts.links[i];
            if (m_result.links[link].pull >
                std::max(0.0, m_structure.links[link].grip) + kPullRounding * m_state.body.scale)
                m_state.openLinks.push_back(link);
        }
        if (m_state.openLinks.empty())
            return;
        for (int link : m_state.openLinks)
            m_result.links[link].isOpen = true;
        if (const std::optional<SpringForces> bounded = search(true)) {
            m_state.openLinks.clear();
            write(*bounded);
            markOpen();
        } else {
            m_state.balance = Balance::Mechanism;
        }
    }

    /// The springs of `found` in balance with the loads, pinned feet held only while they press.
    std::optional<SpringForces> search(bool isBounded)
    {
        m_net =
            componentNet(m_structure, m_state.parts, m_state.body, m_support.isAxisFree, isBounded);
        EquilibriumCache::Kept &kept =
            m_cache.at(m_state.parts.members.front(), variantOf(isBounded));
        if (!kept.search || !(kept.net == m_net.net)) {
            if (!kept.search || !kept.search->replace(m_net.net))
                kept.search.emplace(m_net.net);
            kept.net = m_net.net;
        }
        ContactSearch &search = *kept.search;
        const Eigen::VectorXd load = componentLoad(m_structure, m_state.parts, m_net);
        std::vector<char> isOn(m_net.net.holding.size(), 1);
        search.hold(isOn);
        std::optional<SpringForces> forces;
        for (int i = 0; i < kMostHoldings; ++i) {
            std::optional<SpringForces> next = search.solve(load);
            m_state.passes += search.passes();
            m_state.factorisations += search.factorisations();
            if (!next) {
                // Pins that would have to hold are in the air.
                m_arePinsLifted = forces.has_value();
                if (forces)
                    m_state.body.sliding = horizontal(*forces);
                writeMotion(search.motion());
                return {};
            }
            forces = std::move(next);
            std::vector<char> pressing = holdingWhilePressing(*forces);
            if (pressing == isOn || m_net.held.empty())
                return forces;
            isOn = std::move(pressing);
            search.hold(isOn);
        }
        return forces;
    }

    bool hasFingers() const
    {
        return std::any_of(m_state.parts.links.begin(), m_state.parts.links.end(),
                           [&](int i) { return m_structure.links[i].kind == LinkKind::Fingers; });
    }

    /// Whether what turns freely only stands because nothing leans: on a ground that is a little
    /// aslant it would fold. What would fall over there as one piece is not asked; friction holds
    /// what leaning alone would draw apart.
    bool folds()
    {
        const Vec3 &ground = m_structure.feet[m_state.parts.feet.front()].point;
        double weight = 0.0;
        for (int i : m_state.parts.members) {
            const Member &member = m_structure.members[i];
            weight += member.mass * m_structure.gravity.norm();
            if (m_state.body.margin <= kLean * m_structure.up.dot(member.centroid - ground))
                return false;
        }
        Structure leaning = m_structure;
        for (int i : m_state.parts.links)
            leaning.links[i].grip = std::max(leaning.links[i].grip, kLean * weight);
        EquilibriumCache cache; // only the loads differ
        for (const Vec3 &axis : groundAxes(m_structure.up)) {
            for (const double lean : {kLean, -kLean}) {
                leaning.gravity = m_structure.gravity + lean * m_structure.gravity.norm() * axis;
                ComponentState state = m_state;
                if (ComponentSolver(leaning, m_support, cache, state, m_result)
                        .search(!m_support.isGripUnlimited))
                    continue;
                m_state.motion = std::move(state.motion);
                m_state.offenders = std::move(state.offenders);
                return true;
            }
        }
        return false;
    }

    int variantOf(bool isBounded) const
    {
        return (m_state.body.areAllHeld ? 1 : 0) + (m_support.isAxisFree ? 2 : 0) +
               (isBounded ? 4 : 0);
    }

    /// What the springs that hold feet give together, N.
    double horizontal(const SpringForces &forces) const
    {
        Vec3 sum = Vec3::Zero();
        for (std::size_t i = 0; i < forces.holding.size(); ++i)
            sum += forces.holding[i] * m_net.net.holding[i].rowA.head<3>();
        return sum.norm();
    }

    std::vector<char> holdingWhilePressing(const SpringForces &forces) const
    {
        std::vector<char> isOn(m_net.net.holding.size(), 1);
        std::size_t held = 0;
        const std::vector<int> &feet = m_state.parts.feet;
        for (std::size_t i = 0; i < feet.size() && held < m_net.held.size(); ++i) {
            if (feet[i] != m_net.held[held])
                continue;
            isOn[2 * held] = isOn[2 * held + 1] = forces.pressing[i] > 0.0;
            ++held;
        }
        return isOn;
    }

    void write(const SpringForces &forces)
    {
        const Component &parts = m_state.parts;
        const std::array<Vec3, 2> axes = groundAxes(m_structure.up);
        m_state.hasForces = true;
        for (std::size_t i = 0; i < parts.members.size(); ++i) {
            const Vec6 moved = forces.displacements.segment<6>(6 * i);
            m_result.members[parts.members[i]] = {moved.head<3>(),
                                                  moved.tail<3>() / m_structure.size};
        }
        for (std::size_t i = 0; i < parts.feet.size(); ++i)
            m_result.feet[parts.feet[i]] = {forces.pressing[i] * m_structure.up,
                                            forces.pressing[i] > 0.0};
        for (std::size_t i = 0; i < m_net.held.size(); ++i) {
            for (std::size_t k = 0; k < 2; ++k)
                m_result.feet[m_net.held[i]].force += forces.holding[2 * i + k] * axes[k];
        }
        for (std::size_t i = 0; i < m_net.anchors.size(); ++i) {
            const std::size_t at = 2 * m_net.held.size() + i;
            m_result.feet[m_net.anchors[i]].force +=
                forces.holding[at] * m_net.net.holding[at].rowA.head<3>();
        }
        for (std::size_t i = 0; i < parts.links.size(); ++i)
            m_result.links[parts.links[i]].onA = {forces.joints[i].head<3>(),
                                                  forces.joints[i].tail<3>()};
        for (std::size_t i = 0; i < m_net.bounded.size(); ++i) {
            const int place = m_net.bounded[i];
            const int link = parts.links[place];
            const double along = m_net.grips[place] - forces.pressing[parts.feet.size() + i];
            m_result.links[link].onA.force += along * m_structure.links[link].axis.normalized();
        }
        for (int i : parts.links) {
            LinkForce &link = m_result.links[i];
            link.pull = link.onA.force.dot(m_structure.links[i].axis.normalized());
            if (m_net.bounded.empty())
                link.asked = link.pull;
        }
        writeResiduals();
    }

    /// Links that give way: at their grip, and as far as it goes.
    void markOpen()
    {
        for (int i : m_state.parts.links) {
            LinkForce &link = m_result.links[i];
            const double grip = std::max(0.0, m_structure.links[i].grip);
            link.isOpen = link.pull >= grip - kPullRounding * m_state.body.scale &&
                          opening(m_structure.links[i]) > 0.0;
            if (link.isOpen)
                m_state.openLinks.push_back(i);
        }
    }

    /// By how much more a has moved along the axis than b, mm.
    double opening(const Link &link) const
    {
        const auto movedAt = [&](int member) {
            const RigidMotion &motion = m_result.members[member];
            return Vec3(motion.translation +
                        motion.rotation.cross(link.point - m_structure.members[member].centroid));
        };
        return link.axis.normalized().dot(movedAt(link.b) - movedAt(link.a));
    }

    /// From the forces as they are given, by none of what they were found with.
    void writeResiduals()
    {
        const Component &parts = m_state.parts;
        const double size = m_structure.size;
        std::map<int, Wrench> sums;
        double largest = 0.0;
        const auto add = [&](int member, const Vec3 &point, const Vec3 &force, const Vec3 &moment) {
            const Vec3 about = moment + (point - m_structure.members[member].centroid).cross(force);
            sums[member].force += force;
            sums[member].moment += about;
            largest = std::max({largest, force.norm(), about.norm() / size});
        };
        for (int i : parts.members) {
            const Member &member = m_structure.members[i];
            add(i, member.centroid, member.mass * m_structure.gravity, Vec3::Zero());
        }
        for (int i : parts.loads) {
            const MemberLoad &load = m_structure.loads[i];
            add(load.member, load.point, load.force, load.moment);
        }
        for (int i : parts.feet)
            add(m_structure.feet[i].member, m_structure.feet[i].point, m_result.feet[i].force,
                Vec3::Zero());
        for (int i : parts.links) {
            const Link &link = m_structure.links[i];
            const Wrench &onA = m_result.links[i].onA;
            add(link.a, link.point, onA.force, onA.moment);
            add(link.b, link.point, -onA.force, -onA.moment);
        }
        for (int i : parts.members) {
            const double left = std::max(sums[i].force.norm(), sums[i].moment.norm() / size);
            m_result.residuals[i] = largest > 0.0 ? left / largest : 0.0;
        }
    }

    void writeMotion(const Eigen::VectorXd &motion)
    {
        const double size = m_structure.size;
        double most = 0.0;
        for (Eigen::Index i = 0; i < motion.size(); i += 3)
            most = std::max(most, motion.segment<3>(i).norm());
        for (std::size_t i = 0; i < m_state.parts.members.size() && most > 0.0; ++i) {
            const Vec6 moved = motion.segment<6>(6 * i) / most;
            m_state.motion.push_back({moved.head<3>(), moved.tail<3>() / size});
            if (std::max(moved.head<3>().norm(), moved.tail<3>().norm()) > kStandsStill)
                m_state.offenders.push_back(m_state.parts.members[i]);
        }
    }

    const Structure &m_structure;
    const Support &m_support;
    EquilibriumCache &m_cache;
    ComponentState &m_state;
    Equilibrium &m_result;
    ComponentNet m_net;
    bool m_arePinsLifted = false; // those that would have to hold
};

int severity(Balance balance)
{
    switch (balance) {
    case Balance::Stands:
        return 0;
    case Balance::Mechanism:
        return 1;
    case Balance::Slides:
        return 2;
    case Balance::Topples:
        return 3;
    case Balance::LineSupport:
        return 4;
    case Balance::Floating:
        return 5;
    case Balance::NoContact:
        return 6;
    }
    return 0; // not reached: every one is above
}

} // namespace

Balance Equilibrium::balance() const
{
    Balance worst = components.empty() ? Balance::NoContact : Balance::Stands;
    for (const ComponentState &component : components) {
        if (severity(component.balance) > severity(worst))
            worst = component.balance;
    }
    return worst;
}

int Equilibrium::indeterminacy() const
{
    int most = 0;
    for (const ComponentState &component : components)
        most = std::max(most, component.indeterminacy);
    return most;
}

EquilibriumCache::EquilibriumCache() = default;
EquilibriumCache::~EquilibriumCache() = default;
EquilibriumCache::EquilibriumCache(EquilibriumCache &&) noexcept = default;
EquilibriumCache &EquilibriumCache::operator=(EquilibriumCache &&) noexcept = default;

EquilibriumCache::Kept &EquilibriumCache::at(int firstMember, int variant)
{
    std::unique_ptr<Kept> &kept = m_kept[{firstMember, variant}];
    if (!kept)
        kept = std::make_unique<Kept>();
    return *kept;
}

void EquilibriumCache::clear()
{
    m_kept.clear();
}

Equilibrium solveEquilibrium(const Structure &given, const Support &support,
                             EquilibriumCache &cache)
{
    const Structure structure = soundCopy(given);
    Equilibrium result;
    result.links.resize(structure.links.size());
    result.feet.resize(structure.feet.size());
    result.members.resize(structure.members.size());
    result.residuals.resize(structure.members.size(), 0.0);
    result.isSound = isSound(given);
    const std::vector<Component> found = components(structure);
    for (const Component &component : found) {
        ComponentState &state = result.components.emplace_back();
        state.parts = component;
        state.body = bodyBalance(structure, component, support, found.size() == 1);
        state.balance = state.body.balance;
        state.indeterminacy = indeterminacy(structure, component, state.body.areAllHeld);
        if (state.body.canCarry)
            ComponentSolver(structure, support, cache, state, result).solve();
        if (state.balance != Balance::Stands && state.offenders.empty())
            state.offenders = component.members;
    }
    for (double residual : result.residuals)
        result.worstResidual = std::max(result.worstResidual, residual);
    if (!result.isSound)
        result.worstResidual = 1.0;
    return result;
}

Equilibrium solveEquilibrium(const Structure &structure, const Support &support)
{
    EquilibriumCache cache;
    return solveEquilibrium(structure, support, cache);
}

std::vector<Equilibrium> solveEnvelope(const Structure &structure, const Support &support,
                                       EquilibriumCache &cache)
{
    std::vector<Equilibrium> solutions{solveEquilibrium(structure, support, cache)};
    if (solutions.front().indeterminacy() <= 0)
        return solutions;
    for (bool isPinned : {false, true}) {
        for (bool isAxisFree : {false, true}) {
            Support other = support;
            other.arePinned = isPinned;
            other.isAxisFree = isAxisFree;
            if (other == support)
                continue;
            Equilibrium solution = solveEquilibrium(structure, other, cache);
            if (solution.balance() == solutions.front().balance())
                solutions.push_back(std::move(solution));
        }
    }
    return solutions;
}

} // namespace fff
