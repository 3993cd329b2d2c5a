#include "core/analysis/findings/pulled_joints.h"

#include "core/analysis/finding_action.h"
#include "core/analysis/straining.h"
#include "core/assembly/joint_editing.h"

#include <algorithm>
#include <functional>
#include <map>

namespace fff {

namespace {

constexpr double kLeastPull = 0.05;     // N: less is none when it is said with a digit
constexpr double kLeastFriction = 0.02; // N, the weight of 2 g: with less, whatever holds

Message pulledSentence(const Finding &finding, const Model &model)
{
    const double force = finding.details<PulledJoint>()->force;
    const bool isApart = finding.severity == Severity::Error;
    //: %3 is a number of newtons
    return {isApart
                ? FFF_TEXT("Checks", "Pulled open. The joint of %1 and %2 is pulled apart by %3 N.")
                : FFF_TEXT("Checks",
                           "Carries nothing. The joint of %1 and %2 is pulled apart by %3 N; "
                           "the others hold without it."),
            {nameAt(finding, model, 0), nameAt(finding, model, 1),
             Decimal{force, force < kLeastPull ? 3 : 1}}};
}

Message frictionSentence(const Finding &finding, const Model &model)
{
    //: %3 is a number of newtons
    return {FFF_TEXT("Checks", "Held by friction. The joint of %1 and %2 is pulled with %3 N, "
                               "which only a tight fit holds."),
            {nameAt(finding, model, 0), nameAt(finding, model, 1),
             Decimal{finding.details<PulledJoint>()->force, 2}}};
}

/// As its sentence begins, so that several in one row are not said to be worse than they are.
Message pulledTitle(const Finding &finding)
{
    return {finding.severity == Severity::Error ? FFF_TEXT("Checks", "Pulled open")
                                                : FFF_TEXT("Checks", "Carries nothing"),
            {}};
}

constexpr Text kFlipPulledText = FFF_TEXT("Checks", "Flip its slits");

std::optional<FindingEdit> slitsTurned(const FindingAction &, const Finding &finding,
                                       const Analysis &analysis, const Flips *)
{
    JointEdit edit = flipSlits(analysis.model, JointRef(finding.sections[0], finding.sections[1]));
    if (!edit || edit->document.isSame(analysis.model.document))
        return {};
    return FindingEdit{std::move(edit->step), std::move(edit->document)};
}

std::vector<FindingAction> flipPulled(const Finding &, const Analysis &)
{
    return {{&kTurnPulledSlits}};
}

/// On the joint of the link.
void placeAt(const Analysis &analysis, const Link &link, Finding &finding)
{
    for (const int body : {link.a, link.b})
        finding.sections.push_back(
            analysis.model.ref(static_cast<std::size_t>(analysis.bodies.sectionOf(body))));
    finding.at = link.point;
    finding.joint = JointRef(std::min(finding.sections[0], finding.sections[1]),
                             std::max(finding.sections[0], finding.sections[1]));
}

/// Of each joint the link that is pulled with the most, of those that are pulled at all.
/// pullOf   N; less than 0: it is not to be told of
std::map<int, std::size_t> strongestPulls(const Strength &strength,
                                          const std::function<double(std::size_t)> &pullOf)
{
    std::map<int, std::size_t> strongest;
    for (std::size_t i = 0; i < strength.equilibrium().links.size(); ++i) {
        if (pullOf(i) < 0.0)
            continue;
        const auto [known, isNew] = strongest.emplace(strength.made.links[i].joint, i);
        if (!isNew && pullOf(i) > pullOf(known->second))
            known->second = i;
    }
    return strongest;
}

void tell(const Analysis &analysis, const Strength &strength, std::size_t link,
          const FindingKind &kind, Severity severity, double force, std::vector<Finding> &found)
{
    Finding finding = makeFinding(kind, severity, PulledJoint{force});
    placeAt(analysis, strength.made.structure.links[link], finding);
    found.push_back(std::move(finding));
}

/// Links that are pulled apart.
void findPulled(const Analysis &analysis, const Strength &strength, std::vector<Finding> &found)
{
    const std::vector<LinkForce> &links = strength.equilibrium().links;
    const bool isApart = strength.verdict == HoldVerdict::PullsOut;
    const std::map<int, std::size_t> strongest = strongestPulls(
        strength, [&](std::size_t i) { return links[i].isOpen ? links[i].asked : -1.0; });
    const bool isAnyStrong = std::any_of(strongest.begin(), strongest.end(), [&](const auto &of) {
        return links[of.second].asked >= kLeastPull;
    });
    for (const auto &[joint, link] : strongest)
        // What is pulled with nothing is said where nothing else tells why it comes apart.
        if (links[link].asked >= kLeastPull || (!isAnyStrong && isApart))
            // Where all of it stands without the joint, that is for whoever wants to know.
            tell(analysis, strength, link, kPulledOpen, isApart ? Severity::Error : Severity::Note,
                 links[link].asked, found);
}

/// It would stand in slits that hold nothing against being pulled apart: of several ways to share
/// the load one does without.
bool standsWithoutGrip(const Strength &strength, const StrengthRules &rules)
{
    Structure slack = strength.made.structure;
    for (Link &link : slack.links)
        link.grip = 0.0;
    return solveEquilibrium(slack, supportOf(slack, rules)).balance() == Balance::Stands;
}

/// What hangs in slits that are not made for it, and would come out of looser ones.
void findHeldByFriction(const Analysis &analysis, const Strength &strength,
                        const StrengthRules &rules, std::vector<Finding> &found)
{
    const std::vector<LinkForce> &links = strength.equilibrium().links;
    const auto pullOf = [&](std::size_t i) {
        const bool isHeld = !links[i].isOpen && links[i].pull >= kLeastFriction &&
                            strength.made.structure.links[i].grip > 0.0;
        return isHeld ? links[i].pull : -1.0;
    };
    const std::map<int, std::size_t> pulled = strongestPulls(strength, pullOf);
    if (pulled.empty() || standsWithoutGrip(strength, rules))
        return;
    for (const auto &[joint, link] : pulled)
        tell(analysis, strength, link, kHeldByFriction, Severity::Note, links[link].pull, found);
}

} // namespace

const ActionKind kTurnPulledSlits{plainWords<kFlipPulledText>, slitsTurned};

const FindingKind kPulledOpen{"pulledOpen",   Subject::Strength, FFF_TEXT("Checks", "Pulled open"),
                              pulledSentence, flipPulled,        nullptr,
                              nullptr,        nullptr,           FFF_TEXT("Checks", "Glue it."),
                              pulledTitle};
const FindingKind kHeldByFriction{"heldByFriction", Subject::Strength,
                                  FFF_TEXT("Checks", "Held by friction"), frictionSentence,
                                  flipPulled};

void findPulledJoints(const Analysis &analysis, const Strength &strength,
                      const StrengthRules &rules, std::vector<Finding> &found)
{
    findPulled(analysis, strength, found);
    findHeldByFriction(analysis, strength, rules, found);
}

} // namespace fff
