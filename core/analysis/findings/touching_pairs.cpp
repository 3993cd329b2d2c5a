#include "core/analysis/findings/touching_pairs.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace fff {

namespace {

Message touchingSentence(const Finding &finding, const Model &model)
{
    const Touching &touching = *finding.details<Touching>();
    if (touching.pairs == 1)
        //: %1 and %2 are names of sections, %3 is a length
        return {FFF_TEXT("Checks", "%1 and %2 only touch: they overlap by less than %3."),
                {nameAt(finding, model, 0), nameAt(finding, model, 1), lengthOf(touching.least)}};
    //: %1 is a length
    return {FFF_TEXT_OF_MANY("Checks",
                             "%n pairs of sections only touch: they overlap by less than %1."),
            {lengthOf(touching.least)},
            touching.pairs};
}

/// Of its first overlap.
Vec3 middleOf(const Joint &joint)
{
    const Crossing &crossing = *joint.crossing;
    const Overlap &first = crossing.overlaps.front();
    return crossing.axis.at(0.5 * (first.from + first.to));
}

} // namespace

const FindingKind kTouching{"touching", Subject::Joints, FFF_TEXT("Checks", "Only touch"),
                            touchingSentence};

bool onlyTouch(const Joint &joint, const CheckRules &rules)
{
    const auto &overlaps = joint.crossing->overlaps;
    return joint.kind != JointKind::Tabs &&
           std::all_of(overlaps.begin(), overlaps.end(), [&](const Overlap &overlap) {
               return overlap.to - overlap.from < rules.touching;
           });
}

void findTouching(const LookedAtPlan &at, std::vector<Finding> &found)
{
    const Analysis &analysis = at.analysis;
    std::map<std::pair<int, int>, Vec3> pairs; // and where
    for (const Joint &joint : analysis.assembly.joints)
        if (onlyTouch(joint, at.rules))
            pairs.emplace(std::pair(joint.a, joint.b), middleOf(joint));
    for (const PartOverlap &overlap : at.plan.overlaps) {
        const std::pair pair{at.plan.bodies.sectionOf(overlap.a),
                             at.plan.bodies.sectionOf(overlap.b)};
        const Joint *joint = analysis.assembly.joints.find(pair.first, pair.second);
        if (overlap.how.depth < at.rules.touching && (!joint || onlyTouch(*joint, at.rules)))
            pairs.emplace(pair, overlap.how.at);
    }
    if (pairs.empty())
        return;
    Finding finding = makeFinding(kTouching, Severity::Note,
                                  Touching{static_cast<int>(pairs.size()), at.rules.touching});
    std::set<int> sections;
    for (const auto &[pair, where] : pairs)
        sections.insert({pair.first, pair.second});
    if (pairs.size() == 1)
        finding.at = pairs.begin()->second;
    finding.sections = analysis.model.refs({sections.begin(), sections.end()});
    found.push_back(std::move(finding));
}

} // namespace fff
