#include "core/analysis/findings/rings.h"

#include "core/assembly/cycles.h"

#include <algorithm>
#include <set>

namespace fff {

namespace {

Message ringsSentence(const Finding &finding, const Model &model)
{
    const Rings &rings = *finding.details<Rings>();
    if (rings.count == 1)
        return {rings.hasSteps
                    ? FFF_TEXT("Checks", "%1 are joined in a ring: put them together in the order "
                                         "of the steps.")
                    : FFF_TEXT("Checks", "%1 are joined in a ring: whichever goes in last has to "
                                         "slide onto two others at once."),
                {namesOf(model, finding.sections)}};
    return {rings.hasSteps
                ? FFF_TEXT_OF_MANY("Checks",
                                   "Sections are joined in %n rings: put them together in "
                                   "the order of the steps.")
                : FFF_TEXT_OF_MANY("Checks", "Sections are joined in %n rings: whichever of a ring "
                                             "goes in last has to slide onto two others at once."),
            {},
            rings.count};
}

Message ringsTitle(const Finding &finding)
{
    return {finding.details<Rings>()->count == 1 ? FFF_TEXT("Checks", "Joined in a ring")
                                                 : FFF_TEXT("Checks", "Joined in rings"),
            {}};
}

ProblemLook ringsLook(const Finding &finding)
{
    ProblemLook look;
    look.links = finding.details<Rings>()->links;
    return look;
}

} // namespace

const FindingKind kRings{.name = "cycle",
                         .subject = Subject::Joints,
                         .title = FFF_TEXT("Checks", "Joined in a ring"),
                         .sentence = ringsSentence,
                         .look = ringsLook,
                         .titled = ringsTitle};

void findRings(const LookedAtPlan &at, std::vector<Finding> &found)
{
    const Model &model = at.analysis.model;
    const auto cycles = cyclesOf(model.sectionCount(), at.analysis.assembly.joints);
    std::set<int> sections;
    for (const std::vector<int> &cycle : cycles)
        sections.insert(cycle.begin(), cycle.end());
    const std::vector<int> locked = sectionsOf(at.plan.plan.locked, at.plan);
    if (std::includes(locked.begin(), locked.end(), sections.begin(), sections.end()))
        return;
    Rings rings{static_cast<int>(cycles.size()),
                at.plan.plan.verdict == AssemblyPlan::Verdict::Possible,
                {}};
    std::set<std::pair<int, int>> linked; // a joint may be of several rings
    for (const std::vector<int> &cycle : cycles) {
        for (std::size_t i = 0, k = cycle.size() - 1; i < cycle.size(); k = i++) {
            const auto [a, b] = std::minmax(cycle[i], cycle[k]);
            const Joint *joint = at.analysis.assembly.joints.find(a, b);
            if (joint && linked.emplace(a, b).second)
                rings.links.push_back(linkOf(model, *joint));
        }
    }
    Finding finding = makeFinding(kRings, Severity::Note);
    finding.sections = model.refs(
        cycles.size() == 1 ? cycles.front() : std::vector<int>(sections.begin(), sections.end()));
    if (!rings.links.empty())
        finding.at = rings.links.front().at;
    finding.setDetails(std::move(rings));
    found.push_back(std::move(finding));
}

} // namespace fff
