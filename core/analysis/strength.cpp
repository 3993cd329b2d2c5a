#include "core/analysis/strength.h"

#include "core/analysis/straining.h"

#include <algorithm>

namespace fff {

namespace {

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

Structure withoutPushes(const ModelStructure &made)
{
    Structure bare = made.structure;
    for (const int load : made.pushLoads)
        bare.loads[static_cast<std::size_t>(load)].force.setZero();
    return bare;
}

HoldVerdict verdictOf(const Strength &strength, double safety)
{
    const Equilibrium &equilibrium = strength.equilibrium();
    if (!equilibrium.isSound)
        return HoldVerdict::NotWorkedOut;
    if (equilibrium.balance() != Balance::Stands)
        return isPulledApart(equilibrium) ? HoldVerdict::PullsOut : HoldVerdict::Unstable;
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

} // namespace

bool isPulledApart(const Equilibrium &equilibrium)
{
    return std::any_of(equilibrium.components.begin(), equilibrium.components.end(),
                       [](const ComponentState &state) {
                           return state.balance == Balance::Mechanism && !state.openLinks.empty();
                       });
}

std::optional<double> strengthOf(const Stock &stock, const StrengthRules &rules)
{
    std::optional<double> strength = stock.tensileStrength;
    if (stock.flexuralStrength)
        strength = std::min(strength.value_or(*stock.flexuralStrength), *stock.flexuralStrength);
    if (strength && rules.isLasting)
        *strength *= stock.lastingShare;
    return strength;
}

Strength forcesIn(const Analysis &analysis, const StrengthRules &rules, StrengthCaches &caches,
                  const LongWork &work)
{
    return forcesIn(analysis, structureOf(analysis), rules, caches, work);
}

Strength forcesIn(const Analysis &analysis, ModelStructure made, const StrengthRules &rules,
                  StrengthCaches &caches, const LongWork &work)
{
    Strength strength;
    strength.made = std::move(made);
    for (Link &link : strength.made.structure.links)
        link.grip = link.isTight ? rules.snugGrip : 0.0;
    turnMortises(strength.made, rules, caches);
    Straining(analysis, rules, caches, work).balance(1.0, strength);
    if (!strength.made.pushLoads.empty() && strength.equilibrium().balance() != Balance::Stands)
        strength.standsUnpushed =
            solveEquilibrium(withoutPushes(strength.made), rules.support, caches.equilibria)
                .balance() == Balance::Stands;
    return strength;
}

void addStresses(const Analysis &analysis, const StrengthRules &rules, StrengthCaches &caches,
                 Strength &strength, const LongWork &work)
{
    Straining(analysis, rules, caches, work).stress(1.0, strength);
    strength.verdict = verdictOf(strength, rules.safety);
    std::map<BodyPointer, std::shared_ptr<const SectionCuts>> used;
    for (std::size_t i = 0; i < analysis.bodies.size(); ++i)
        if (auto found = caches.cuts.extract(analysis.bodies.pointer(static_cast<int>(i))))
            used.insert(std::move(found));
    caches.cuts = std::move(used);
    keepMeshesOf(analysis.bodies, caches.meshes);
    std::erase_if(caches.shares,
                  [&](const auto &kept) { return !caches.cuts.contains(kept.first); });
    std::erase_if(caches.lastShares, [](const auto &kept) { return kept.second.use_count() == 1; });
    std::erase_if(caches.alike, [](const auto &kept) { return kept.second.use_count() == 1; });
}

Strength strengthOf(const Analysis &analysis, const StrengthRules &rules, StrengthCaches &caches,
                    const LongWork &work)
{
    Strength strength = forcesIn(analysis, rules, caches, work);
    addStresses(analysis, rules, caches, strength, work);
    return strength;
}

} // namespace fff
