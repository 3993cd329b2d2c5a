#include "tests/core/physics/reference_comparison.h"

#include <algorithm>
#include <limits>

namespace fff::test {

namespace {

const char *word(Balance balance)
{
    switch (balance) {
    case Balance::Stands:
        return "stands";
    case Balance::Topples:
        return "topples";
    case Balance::LineSupport:
        return "line support";
    case Balance::Floating:
        return "floating";
    case Balance::NoContact:
        return "no contact";
    case Balance::Slides:
        return "slides";
    case Balance::Mechanism:
        return "mechanism";
    }
    return "?"; // not reached: every one is above
}

/// Ids of sections, in order, joined.
std::string joined(std::vector<std::string> ids, const char *by)
{
    std::sort(ids.begin(), ids.end());
    std::string all;
    for (const std::string &id : ids)
        all += (all.empty() ? "" : by) + id;
    return all;
}

std::string told(const std::vector<std::vector<std::string>> &groups)
{
    std::vector<std::string> names;
    for (const std::vector<std::string> &group : groups)
        names.push_back(joined(group, "+"));
    return joined(names, " ");
}

void compareMasses(const Comparison &comparison)
{
    const auto &[given, tolerances, report] = comparison;
    MassProperties all;
    for (const ReferenceSection &section : given.sections)
        all += section.mass;
    if (given.truth.mass)
        report.number("mass kg", *given.truth.mass, all.mass, tolerances.mass * *given.truth.mass);
    if (given.truth.centre)
        report.vector("centre mm", *given.truth.centre, all.centre, tolerances.centre);
}

void compareVerdicts(const Comparison &comparison, const Equilibrium &ours)
{
    const auto &[given, tolerances, report] = comparison;
    const ReferenceTruth &truth = given.truth;
    const Balance expected =
        truth.balance.value_or(given.structure.feet.empty() ? Balance::NoContact : Balance::Stands);
    report.claim("verdict", word(expected), word(ours.balance()));
    std::vector<std::vector<std::string>> components, unsupported;
    double least = std::numeric_limits<double>::infinity();
    Vec3 resultant = Vec3::Zero();
    for (const ComponentState &component : ours.components) {
        std::vector<std::string> ids;
        for (int member : component.parts.members)
            ids.push_back(given.sections[static_cast<std::size_t>(member)].id);
        if (component.balance == Balance::Floating || component.balance == Balance::NoContact)
            unsupported.push_back(ids);
        else if (component.body.margin < least) {
            least = component.body.margin;
            resultant = component.body.onGround;
        }
        components.push_back(std::move(ids));
    }
    if (!truth.components.empty())
        report.claim("components", told(truth.components), told(components));
    if (!truth.unsupported.empty())
        report.claim("unsupported", told(truth.unsupported), told(unsupported));
    if (truth.margin)
        report.number("margin mm", *truth.margin, least, tolerances.resultant);
    if (truth.resultant)
        report.vector("resultant mm", *truth.resultant, resultant, tolerances.resultant);
}

/// What there is of each component that stands is carried, and nothing else.
void compareSums(const Comparison &comparison, const Equilibrium &ours)
{
    const auto &[given, tolerances, report] = comparison;
    const Structure &structure = given.structure;
    Vec3 sum = Vec3::Zero(), load = Vec3::Zero();
    for (const ComponentState &component : ours.components) {
        if (!component.hasForces)
            continue;
        for (int foot : component.parts.feet)
            sum += ours.feet[static_cast<std::size_t>(foot)].force;
        for (int member : component.parts.members)
            load += structure.members[static_cast<std::size_t>(member)].mass * structure.gravity;
        for (int acting : component.parts.loads)
            load += structure.loads[static_cast<std::size_t>(acting)].force;
    }
    report.number("residual", 0.0, ours.worstResidual, tolerances.equilibrium);
    report.vector("sum of reactions N", -load, sum, tolerances.equilibrium * load.norm());
}

void compareForces(const Comparison &comparison, const Equilibrium &ours)
{
    const auto &[given, tolerances, report] = comparison;
    const Structure &structure = given.structure;
    compareSums(comparison, ours);
    const bool isOpen = ours.indeterminacy() > 0;
    if (tolerances.isDeterminate || tolerances.isIndeterminate)
        report.claim("indeterminate", tolerances.isIndeterminate ? "yes" : "no",
                     isOpen ? "yes" : "no");
    const Judging judging = isOpen ? Judging::Told : Judging::Judged;
    // A foot that carries little is judged by what the others carry.
    double largest = 0.0, leverage = 0.0;
    for (const Vec3 &reaction : given.truth.reactions)
        largest = std::max(largest, reaction.norm());
    for (std::size_t i = 0; i < given.truth.reactions.size() && i < ours.feet.size(); ++i)
        report.vector("foot " + std::to_string(i) + " N", given.truth.reactions[i],
                      ours.feet[i].force, tolerances.reaction * largest, judging);
    for (const auto &[id, wrench] : given.truth.joints) {
        largest = std::max(largest, wrench.force.norm());
        leverage =
            std::max({leverage, wrench.moment.norm(), wrench.force.norm() * structure.thickness});
    }
    for (std::size_t i = 0; i < given.joints.size(); ++i) {
        const auto truth = given.truth.joints.find(given.joints[i]);
        if (truth == given.truth.joints.end())
            continue;
        const Wrench &wrench = ours.links[i].onA;
        report.vector(given.joints[i] + " force N", truth->second.force, wrench.force,
                      tolerances.wrench * largest, judging);
        report.vector(given.joints[i] + " moment Nmm", truth->second.moment, wrench.moment,
                      tolerances.wrench * leverage, judging);
    }
}

} // namespace

std::optional<Equilibrium> compareRigid(const Comparison &comparison)
{
    const ReferenceCase &given = comparison.given;
    compareMasses(comparison);
    if (!given.clamps.empty())
        return {};
    Support support;
    support.friction = given.friction;
    Equilibrium ours = solveEquilibrium(given.structure, support);
    compareVerdicts(comparison, ours);
    const bool hasForces =
        std::any_of(ours.components.begin(), ours.components.end(),
                    [](const ComponentState &component) { return component.hasForces; });
    if (hasForces)
        compareForces(comparison, ours);
    else if (!given.truth.reactions.empty())
        comparison.report.claim("forces", "some", "none");
    return ours;
}

bool isDeterminate(const std::optional<Equilibrium> &rigid)
{
    return rigid && rigid->balance() == Balance::Stands && rigid->indeterminacy() == 0;
}

} // namespace fff::test
