#include "tests/core/physics/reference_comparison.h"
#include "tests/core/physics/reference_plates.h"

#include <algorithm>
#include <cmath>

namespace fff::test {

namespace {

enum class Fit { Glued, Tight, Loose };

std::optional<ElasticEquilibrium> solved(const ReferenceCase &given, Fit fit,
                                         const std::vector<ReferencePlate> &plates)
{
    Structure structure = given.structure;
    for (Link &link : structure.links) {
        if (fit != Fit::Glued && !std::isfinite(link.grip))
            link.grip = 0.0; // faces that only press hold nothing
        link.isTight = link.isTight && fit != Fit::Loose;
    }
    const auto found = elasticEquilibrium(structure, flexibilitiesOf(given, plates));
    if (!found || !found->isBalanced())
        return {};
    return *found;
}

double largestOf(const std::vector<Vec3> &forces)
{
    double largest = 0.0;
    for (const Vec3 &force : forces)
        largest = std::max(largest, force.norm());
    return largest;
}

void compareSum(const Comparison &comparison, const std::string &kind,
                const ElasticEquilibrium &ours)
{
    const auto &[given, tolerances, report] = comparison;
    Vec3 sum = Vec3::Zero(), load = Vec3::Zero();
    for (const Vec3 &foot : ours.feet)
        sum += foot;
    for (const Member &member : given.structure.members)
        load += member.mass * given.structure.gravity;
    for (const MemberLoad &acting : given.structure.loads)
        load += acting.force;
    report.vector(kind + "sum of reactions N", -load, sum, tolerances.equilibrium * load.norm());
}

void compareJoints(const Comparison &comparison, const std::string &kind,
                   const ReferenceTruth &truth, const ElasticEquilibrium &ours, double share,
                   Judging judging)
{
    const auto &[given, tolerances, report] = comparison;
    double largest = largestOf(truth.reactions), leverage = 0.0;
    for (const auto &[id, wrench] : truth.joints) {
        largest = std::max(largest, wrench.force.norm());
        leverage = std::max(leverage, wrench.moment.norm());
    }
    // A moment is judged as the forces are that make it at the ends of the slits.
    for (const Link &link : given.structure.links)
        leverage = std::max(leverage, largest * std::max(link.depthA, link.depthB));
    for (std::size_t j = 0; j < given.joints.size(); ++j) {
        const auto wrench = truth.joints.find(given.joints[j]);
        if (wrench == truth.joints.end())
            continue;
        report.vector(kind + given.joints[j] + " force N", wrench->second.force,
                      ours.links[j].head<3>(), share * largest, judging);
        report.vector(kind + given.joints[j] + " moment Nmm", wrench->second.moment,
                      ours.links[j].tail<3>(), share * leverage, judging);
    }
}

/// With slits that press: the largest foot by its share, every foot by newtons where those are
/// said, else by the same share of the largest.
void comparePressed(const Comparison &comparison, const std::string &kind,
                    const ReferenceTruth &truth, const ElasticEquilibrium &ours, Judging judging)
{
    const auto &[given, tolerances, report] = comparison;
    const double largest = largestOf(truth.reactions), share = tolerances.elastic * largest;
    for (std::size_t k = 0; k < truth.reactions.size() && k < ours.feet.size(); ++k)
        report.vector(kind + "foot " + std::to_string(k) + " N", truth.reactions[k], ours.feet[k],
                      tolerances.elasticNewton.value_or(share), judging);
    if (tolerances.elasticNewton)
        report.number(kind + "largest foot N", largest, largestOf(ours.feet), share, judging);
    compareJoints(comparison, kind, truth, ours, tolerances.elastic, Judging::Told);
}

/// Slits that press, as a truth of its own has them.
void compareContact(const Comparison &comparison, const std::string &kind, Fit fit,
                    const ReferenceTruth &truth, bool isJudged,
                    const std::vector<ReferencePlate> &plates)
{
    if (!truth.isThere())
        return;
    if (const auto ours = solved(comparison.given, fit, plates)) {
        compareSum(comparison, kind, *ours);
        comparePressed(comparison, kind, truth, *ours, isJudged ? Judging::Judged : Judging::Told);
    } else
        comparison.report.claim(kind + "bending sections", "balanced", "not balanced",
                                isJudged ? Judging::Judged : Judging::Told);
    if (const auto carried = forcesOf(comparison.given, truth))
        comparePlateCuts(comparison, kind, plates, *carried, truth, false);
}

/// Judged where there is one way to share the load, whatever the slits are like, or where the index
/// says how near it has to come all the same.
void compareGlued(const Comparison &comparison, bool isShared,
                  const std::vector<ReferencePlate> &plates)
{
    const auto &[given, tolerances, report] = comparison;
    const bool isNamed =
        tolerances.isElasticNamed && !given.contact.isThere() && !given.contactWithPlay.isThere();
    const Judging judging = isShared ? Judging::Judged : Judging::Told;
    const std::string kind = "bending ";
    const auto ours = solved(given, Fit::Glued, plates);
    if (!ours) {
        report.claim(kind + "sections", "balanced", "not balanced",
                     isNamed ? Judging::Judged : judging);
        return;
    }
    compareSum(comparison, kind, *ours);
    if (isNamed)
        comparePressed(comparison, kind, given.truth, *ours, Judging::Judged);
    else {
        const double largest = largestOf(given.truth.reactions);
        for (std::size_t k = 0; k < given.truth.reactions.size() && k < ours->feet.size(); ++k)
            report.vector(kind + "foot " + std::to_string(k) + " N", given.truth.reactions[k],
                          ours->feet[k], tolerances.plate * largest, judging);
        compareJoints(comparison, kind, given.truth, *ours, tolerances.plate, judging);
    }
    const auto carried = forcesOf(given, given.truth);
    if (isShared)
        comparePlateCuts(comparison, "", plates, forcesOf(*ours), given.truth, true);
    else if (carried)
        comparePlateCuts(comparison, "", plates, *carried, given.truth, true);
}

} // namespace

void comparePlates(const Comparison &comparison, const std::optional<Equilibrium> &rigid)
{
    const auto &[given, tolerances, report] = comparison;
    const bool stands = rigid && rigid->balance() == Balance::Stands;
    const bool hasTruth =
        given.truth.isThere() || given.contact.isThere() || given.contactWithPlay.isThere();
    if (!hasTruth || (given.clamps.empty() && !stands))
        return;
    const auto plates = platesOf(given);
    if (!plates) {
        report.claim("plates", "made", "not made");
        return;
    }
    if (!given.clamps.empty()) {
        if (const auto carried = forcesOf(given, given.truth))
            comparePlateCuts(comparison, "", *plates, *carried, given.truth, true);
        return;
    }
    if (given.friction > 0.0)
        return; // bending sections know feet that slide and those that are pinned
    if (given.truth.isThere())
        compareGlued(comparison, isDeterminate(rigid) || tolerances.isSymmetric, *plates);
    const bool hasPlay = given.contactWithPlay.isThere();
    compareContact(comparison, "contact ", Fit::Tight, given.contact,
                   tolerances.isElasticOfContact || !hasPlay, *plates);
    compareContact(comparison, "play ", Fit::Loose, given.contactWithPlay,
                   tolerances.isElasticOfPlay || !tolerances.isElasticOfContact, *plates);
}

} // namespace fff::test
