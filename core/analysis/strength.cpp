#include "core/analysis/strength.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace fff {

namespace {

constexpr double kCubicMetre = 1e9; // mm³
/// Of several ways to bear a load those are refined whose stresses by the grid are within this
/// share of the worst: refining adds less.
constexpr double kNearlyWorst = 0.8;
constexpr double kMassAccuracy = 1e-4; // share of a mass that is looked for
constexpr double kLeastStep = 1e-3;    // share of the bracket that a step of it takes off
constexpr int kMostSteps = 40;         // of that search

/// A wrench about a point of the world, in a body's frame.
AppliedForce appliedIn(const Frame &frame, ForceKind kind, const Vec2 &at, const Vec3 &point,
                       const Vec3 &force, const Vec3 &moment)
{
    AppliedForce applied;
    applied.kind = kind;
    applied.at = at;
    applied.force = inFrame(frame, force);
    applied.moment = inFrame(frame, moment + (point - frame.toWorld(at)).cross(force));
    return applied;
}

/// What acts on each body.
using ForcesOnBodies = std::vector<std::vector<AppliedForce>>;
ForcesOnBodies forcesOn(const Bodies &bodies, const ModelStructure &made, const Structure &loaded,
                        const Equilibrium &equilibrium)
{
    ForcesOnBodies forces(bodies.size());
    const auto add = [&](int body, ForceKind kind, const Vec2 &at, const Vec3 &point,
                         const Vec3 &force, const Vec3 &moment) -> AppliedForce & {
        auto &list = forces[static_cast<std::size_t>(body)];
        list.push_back(appliedIn(bodies.at(body).frame(), kind, at, point, force, moment));
        return list.back();
    };
    for (std::size_t i = 0; i < loaded.links.size(); ++i) {
        const Link &link = loaded.links[i];
        const LinkPlace &place = made.links[i];
        const Wrench &onA = equilibrium.links[i].onA;
        add(link.a, ForceKind::Link, place.slits[0].root, link.point, onA.force, onA.moment).slit =
            place.slits[0];
        add(link.b, ForceKind::Link, place.slits[1].root, link.point, -onA.force, -onA.moment)
            .slit = place.slits[1];
    }
    for (std::size_t i = 0; i < loaded.feet.size(); ++i) {
        const Foot &foot = loaded.feet[i];
        add(foot.member, ForceKind::Foot, bodies.at(foot.member).frame().toLocal(foot.point),
            foot.point, equilibrium.feet[i].force, Vec3::Zero());
    }
    for (const Load &load : loaded.loads)
        add(load.member, ForceKind::Load, bodies.at(load.member).frame().toLocal(load.point),
            load.point, load.force, load.moment);
    return forces;
}

/// A structure, the solutions that count, and the bodies' stresses under them.
class Straining
{
public:
    Straining(const Analysis &analysis, const StrengthRules &rules, StrengthCaches &caches)
        : m_analysis(analysis), m_rules(rules), m_caches(caches)
    {
    }

    /// Under its own weight and so much of the loads.
    void strain(double scale, Strength &strength) const
    {
        balance(scale, strength);
        stress(scale, strength);
    }

    void balance(double scale, Strength &strength) const
    {
        const Structure loaded = loadedBy(scale, strength);
        strength.envelope = solveEnvelope(loaded, m_rules.support, m_caches.equilibria);
        if (m_rules.isElastic && strength.equilibrium().indeterminacy() > 0 &&
            strength.equilibrium().balance() == Balance::Stands)
            bend(scale, loaded, strength);
    }

    void stress(double scale, Strength &strength) const
    {
        const Structure loaded = loadedBy(scale, strength);
        const Bodies &bodies = m_analysis.bodies;
        strength.bodies.assign(bodies.size(), {});
        std::vector<std::vector<char>> hasForces;
        std::vector<ForcesOnBodies> forces;
        for (const Equilibrium &equilibrium : strength.envelope) {
            hasForces.push_back(bodiesWithForces(equilibrium));
            forces.push_back(forcesOn(bodies, strength.made, loaded, equilibrium));
        }
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            BodyStrength &body = strength.bodies[i];
            body.strength = strengthOf(stockOf(static_cast<int>(i)));
            body.isWorkedOut = hasForces.front()[i];
            std::vector<const std::vector<AppliedForce> *> cases;
            for (std::size_t k = 0; k < forces.size(); ++k)
                if (hasForces[k][i])
                    cases.push_back(&forces[k][i]);
            if (!cases.empty())
                findWorst(static_cast<int>(i), cases, body);
        }
        strength.worst = -1;
        strength.neckUse = strength.cornerUse = 0.0;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            const BodyStrength &body = strength.bodies[i];
            strength.neckUse = std::max(strength.neckUse, body.neckUse);
            if (body.cornerUse > strength.cornerUse) {
                strength.cornerUse = body.cornerUse;
                strength.worst = static_cast<int>(i);
            }
        }
    }

private:
    static Structure loadedBy(double scale, const Strength &strength)
    {
        Structure loaded = strength.made.structure;
        for (Load &load : loaded.loads) {
            load.force *= scale;
            load.moment *= scale;
        }
        return loaded;
    }

    /// The forces of bodies that bend in place of those of rigid ones, where there are such.
    void bend(double scale, const Structure &loaded, Strength &strength) const
    {
        const auto bending = BendingBodies::of(m_analysis, strength.made, m_caches.bending);
        if (!bending)
            return; // nobody stops it
        strength.stiff = bending->stiff();
        const std::vector<MemberFlexibility> members = bending->under(scale);
        std::vector<Equilibrium> bent;
        for (const FootHold hold : {FootHold::Frictionless, FootHold::Pinned}) {
            const auto solved = elasticEquilibrium(loaded, members, hold);
            if (solved && solved->isBalanced())
                bent.push_back(bentBy(*solved, loaded, strength.equilibrium()));
            else if (hold == FootHold::Frictionless) {
                strength.isBendingLost = true;
                return;
            }
        }
        strength.envelope = std::move(bent);
        strength.isElastic = true;
    }

    static Equilibrium bentBy(const ElasticEquilibrium &solved, const Structure &loaded,
                              Equilibrium rigid)
    {
        for (std::size_t i = 0; i < loaded.links.size(); ++i) {
            LinkForce &force = rigid.links[i];
            force.onA = {solved.links[i].head<3>(), solved.links[i].tail<3>()};
            force.pull = force.onA.force.dot(loaded.links[i].axis);
            force.isOpen = solved.isParted[i];
            force.asked = std::max(0.0, force.pull);
        }
        for (std::size_t i = 0; i < loaded.feet.size(); ++i)
            rigid.feet[i] = {solved.feet[i], !solved.isLifted[i]};
        rigid.residuals = solved.residual;
        rigid.worstResidual = solved.worstResidual;
        return rigid;
    }

    /// In equilibrium, whether or not all the rest is.
    std::vector<char> bodiesWithForces(const Equilibrium &equilibrium) const
    {
        std::vector<char> has(m_analysis.bodies.size(), 0);
        for (const ComponentState &state : equilibrium.components)
            for (const int member : state.parts.members)
                has[static_cast<std::size_t>(member)] =
                    state.hasForces && state.balance == Balance::Stands;
        return has;
    }

    const Stock &stockOf(int body) const
    {
        return m_analysis.model.stockOf(
            static_cast<std::size_t>(m_analysis.bodies.sectionOf(body)));
    }

    const SectionCuts &cutsOf(int body) const
    {
        auto &kept = m_caches.cuts[m_analysis.bodies.pointer(body)];
        if (!kept)
            kept = std::make_shared<const SectionCuts>(
                PieceShape(m_analysis.bodies.at(body).outline().region, slitsOf(m_analysis, body)));
        return *kept;
    }

    SheetMaterial sheetOf(int body) const
    {
        const Stock &stock = stockOf(body);
        const Frame &frame = m_analysis.bodies.at(body).frame();
        const Vec3 weight = stock.density / kCubicMetre * stock.thickness * Structure().gravity;
        SheetMaterial sheet;
        sheet.thickness = stock.thickness;
        sheet.arealWeight = inFrame(frame, weight);
        sheet.strength =
            strengthOf(stock).value_or(1.0); // unknown: uses are MPa, and not looked at
        if (stock.modulus)
            sheet.modulus = *stock.modulus;
        return sheet;
    }

    /// Of the cases, which act in the same places, those are looked at closely that may be worst.
    void findWorst(int index, const std::vector<const std::vector<AppliedForce> *> &cases,
                   BodyStrength &body) const
    {
        const SectionCuts &cuts = cutsOf(index);
        const SheetMaterial sheet = sheetOf(index);
        const CutShares shares = cutShares(cuts, *cases.front(), sheet.thickness);
        const auto stressed = [&](std::size_t k, int refined) {
            return stressOf(cuts, shares, *cases[k], sheet, {m_rules.notch, refined});
        };
        std::vector<double> neck(cases.size(), 0.0), corner(cases.size(), 0.0);
        for (std::size_t k = 0; cases.size() > 1 && k < cases.size(); ++k) {
            const SectionStress stress = stressed(k, 0);
            body.isWorkedOut = body.isWorkedOut && stress.isWorkedOut;
            neck[k] = useOf(stress, stress.worstNeck, &NeckStress::neckUse);
            corner[k] = useOf(stress, stress.worstCorner, &NeckStress::cornerUse);
        }
        const double worstNeck = *std::max_element(neck.begin(), neck.end());
        const double worstCorner = *std::max_element(corner.begin(), corner.end());
        for (std::size_t k = 0; k < cases.size(); ++k) {
            if (neck[k] < kNearlyWorst * worstNeck && corner[k] < kNearlyWorst * worstCorner)
                continue;
            const SectionStress stress = stressed(k, StressOptions().refined);
            body.isWorkedOut = body.isWorkedOut && stress.isWorkedOut;
            keepWorse(stress, stress.worstNeck, &NeckStress::neckUse, body.neck);
            keepWorse(stress, stress.worstCorner, &NeckStress::cornerUse, body.corner);
        }
        if (body.strength) {
            body.neckUse = body.neck ? body.neck->neckUse : 0.0;
            body.cornerUse = body.corner ? body.corner->cornerUse : 0.0;
        }
    }

    static double useOf(const SectionStress &stress, int neck, double NeckStress::*use)
    {
        return neck < 0 ? 0.0 : stress.necks[static_cast<std::size_t>(neck)].*use;
    }
    static void keepWorse(const SectionStress &stress, int neck, double NeckStress::*use,
                          std::optional<NeckStress> &worst)
    {
        if (neck >= 0 && (!worst || useOf(stress, neck, use) > (*worst).*use))
            worst = stress.necks[static_cast<std::size_t>(neck)];
    }

    const Analysis &m_analysis;
    const StrengthRules &m_rules;
    StrengthCaches &m_caches;
};

/// A mortise comes out to the side to which it is pulled.
void turnMortises(ModelStructure &made, const StrengthRules &rules, StrengthCaches &caches)
{
    if (std::none_of(made.links.begin(), made.links.end(),
                     [](const LinkPlace &place) { return place.isThrough; }))
        return;
    Support held = rules.support;
    held.isGripUnlimited = true;
    const Equilibrium equilibrium = solveEquilibrium(made.structure, held, caches.equilibria);
    for (std::size_t i = 0; i < made.links.size(); ++i)
        if (made.links[i].isThrough && equilibrium.links[i].pull < 0.0)
            made.structure.links[i].axis = -made.structure.links[i].axis;
}

bool isPulledOut(const Equilibrium &equilibrium)
{
    return std::any_of(equilibrium.components.begin(), equilibrium.components.end(),
                       [](const ComponentState &state) {
                           return state.balance == Balance::Mechanism && !state.openLinks.empty();
                       });
}

HoldVerdict verdictOf(const Strength &strength, double safety)
{
    const Equilibrium &equilibrium = strength.equilibrium();
    if (!equilibrium.isSound)
        return HoldVerdict::NotWorkedOut;
    if (equilibrium.balance() != Balance::Stands)
        return isPulledOut(equilibrium) ? HoldVerdict::PullsOut : HoldVerdict::Unstable;
    for (const Equilibrium &solution : strength.envelope)
        if (!(solution.worstResidual <= kTrustedResidual))
            return HoldVerdict::NotWorkedOut;
    if (strength.neckUse * safety > 1.0)
        return HoldVerdict::Breaks;
    const auto isAny = [&](auto what) {
        return std::any_of(strength.bodies.begin(), strength.bodies.end(), what);
    };
    if (isAny([](const BodyStrength &body) { return !body.isWorkedOut; }))
        return HoldVerdict::NotWorkedOut;
    if (isAny([](const BodyStrength &body) { return !body.strength; }))
        return HoldVerdict::NotRated;
    return strength.cornerUse * safety > 1.0 ? HoldVerdict::BarelyHolds : HoldVerdict::Holds;
}

/// Where a use that rises reaches 1, as a factor on the weights; 0 when it has before any of them.
std::optional<double> scaleAtOne(const std::function<std::optional<double>(double)> &useAt)
{
    double low = 0.0, high = 1.0;
    std::optional<double> atLow = useAt(low), atHigh = useAt(high);
    if (!atLow || *atLow >= 1.0)
        return atLow ? std::optional(0.0) : std::nullopt;
    while (atHigh && *atHigh < 1.0) {
        if (high >= kMostScale)
            return {};
        low = high;
        atLow = atHigh;
        // Nearly linear: a little beyond where the line from here gets to 1.
        high =
            std::min(kMostScale, std::max(2.0 * high, *atHigh > 0.0 ? 1.05 * high / *atHigh : 0.0));
        atHigh = useAt(high);
    }
    if (!atHigh)
        return {}; // it does not stand under so much
    for (int i = 0; i < kMostSteps && high - low > kMassAccuracy * high; ++i) {
        const double share = (1.0 - *atLow) / (*atHigh - *atLow);
        // Where the line says, but never only at one end for ever.
        const double middle =
            low + std::clamp(i % 3 == 2 ? 0.5 : share, kLeastStep, 1.0 - kLeastStep) * (high - low);
        const auto at = useAt(middle);
        if (!at)
            return {};
        if (std::abs(*at - 1.0) < kMassAccuracy)
            return middle;
        (*at < 1.0 ? low : high) = middle;
        (*at < 1.0 ? atLow : atHigh) = at;
    }
    return 0.5 * (low + high);
}

} // namespace

std::optional<double> strengthOf(const Stock &stock)
{
    if (stock.tensileStrength && stock.flexuralStrength)
        return std::min(*stock.tensileStrength, *stock.flexuralStrength);
    return stock.tensileStrength ? stock.tensileStrength : stock.flexuralStrength;
}

Strength forcesIn(const Analysis &analysis, const StrengthRules &rules, StrengthCaches &caches)
{
    Strength strength;
    strength.made = structureOf(analysis);
    for (Link &link : strength.made.structure.links)
        link.grip = link.isTight ? rules.snugGrip : 0.0;
    turnMortises(strength.made, rules, caches);
    Straining(analysis, rules, caches).balance(1.0, strength);
    return strength;
}

void addStresses(const Analysis &analysis, const StrengthRules &rules, StrengthCaches &caches,
                 Strength &strength)
{
    Straining(analysis, rules, caches).stress(1.0, strength);
    strength.verdict = verdictOf(strength, rules.safety);
    std::map<BodyPointer, std::shared_ptr<const SectionCuts>> used;
    for (std::size_t i = 0; i < analysis.bodies.size(); ++i)
        if (auto found = caches.cuts.extract(analysis.bodies.pointer(static_cast<int>(i))))
            used.insert(std::move(found));
    caches.cuts = std::move(used);
}

Strength strengthOf(const Analysis &analysis, const StrengthRules &rules, StrengthCaches &caches)
{
    Strength strength = forcesIn(analysis, rules, caches);
    addStresses(analysis, rules, caches, strength);
    return strength;
}

BearableMass bearableMass(const Analysis &analysis, const Strength &strength,
                          const StrengthRules &rules, StrengthCaches &caches)
{
    const Structure &structure = strength.made.structure;
    double placed = 0.0;
    for (const Load &load : structure.loads)
        placed += load.force.norm() / structure.gravity.norm();
    if (!(placed > 0.0) || strength.equilibrium().balance() != Balance::Stands)
        return {};
    const Straining straining(analysis, rules, caches);
    std::map<double, std::optional<std::pair<double, double>>> known; // both uses, by the scale
    const auto usesAt = [&](double scale) {
        const auto found = known.find(scale);
        if (found != known.end())
            return found->second;
        Strength scaled;
        scaled.made = strength.made;
        straining.strain(scale, scaled);
        std::optional<std::pair<double, double>> uses;
        if (scaled.equilibrium().balance() == Balance::Stands)
            uses.emplace(scaled.neckUse, scaled.cornerUse);
        return known[scale] = uses;
    };
    const auto massAt = [&](auto which) -> std::optional<double> {
        const auto scale = scaleAtOne([&](double at) -> std::optional<double> {
            const auto uses = usesAt(at);
            return uses ? std::optional(which(*uses)) : std::nullopt;
        });
        return scale ? std::optional(*scale * placed) : std::nullopt;
    };
    return {massAt([](const auto &uses) { return uses.second; }),
            massAt([](const auto &uses) { return uses.first; })};
}

} // namespace fff
