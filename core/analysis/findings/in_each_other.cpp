#include "core/analysis/findings/in_each_other.h"

#include "core/analysis/findings/joining.h"
#include "core/analysis/findings/touching_pairs.h"
#include "core/analysis/findings/turning_square.h"
#include "core/assembly/found_joint.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace fff {

namespace {

/// Why there is no slit and what to do about it.
Text whyText(NoSlit why)
{
    switch (why) {
    case NoSlit::Wanted:
        return FFF_TEXT("Checks", "Their joint is set to “None”.");
    case NoSlit::NoWidth:
        return FFF_TEXT("Checks", "No slit lets them slide together: the negative clearance leaves "
                                  "it no width. Make the clearance larger.");
    case NoSlit::OppositeWays:
        return FFF_TEXT("Checks",
                        "No slits let them slide together: in one place they could only slide one "
                        "way, in another only the other way. Shorten one of them.");
    case NoSlit::NothingHolds:
        return FFF_TEXT("Checks",
                        "Nothing would hold them: holes are where slits would begin. Make the "
                        "holes smaller, or let one of them end inside the other.");
    case NoSlit::Enclosed:
        return FFF_TEXT("Checks", "No slit lets them slide together: neither of them reaches the "
                                  "edge. Open a hole to the outside, or let one of them pass "
                                  "through.");
    }
    return {}; // not reached: every reason is above
}

Message noSlitSentence(const Finding &finding, const Model &model)
{
    const MissingSlit &missing = *finding.details<MissingSlit>();
    return {FFF_TEXT("Checks", "%1 and %2 overlap, %3 long. %4"),
            {nameAt(finding, model, 0), nameAt(finding, model, 1), lengthOf(missing.overlap),
             whyText(missing.why)}};
}

std::vector<FindingAction> noSlitActions(const Finding &finding, const Analysis &analysis)
{
    std::vector<FindingAction> all = joinAgain(finding, analysis.model.document);
    const std::vector<FindingAction> mends = mendsOfPair(finding, analysis);
    all.insert(all.end(), mends.begin(), mends.end());
    return all;
}

Message interferenceSentence(const Finding &finding, const Model &model)
{
    constexpr double kSmall = 0.1; // mm
    const Interference &how = *finding.details<Interference>();
    const Message deep = how.depth < kSmall
                             ? Message{FFF_TEXT("Checks", "less than %1"), {lengthOf(kSmall)}}
                             : Message{{nullptr, "%1"}, {lengthOf(how.depth)}};
    return {how.isJoined ? FFF_TEXT("Checks", "%1 and %2 overlap by %3, outside their slits.")
                         : FFF_TEXT("Checks", "%1 and %2 overlap by %3, but are not joined."),
            {nameAt(finding, model, 0), nameAt(finding, model, 1), deep}};
}

/// What is filed away is told apart from what cannot be made, where both are in a list.
Message interferenceTitle(const Finding &finding)
{
    return {finding.severity == Severity::Warning ? FFF_TEXT("Checks", "Sections overlap slightly")
                                                  : kInterference.title,
            {}};
}

Message shallowSentence(const Finding &finding, const Model &model)
{
    const ShallowAngle &how = *finding.details<ShallowAngle>();
    const bool isTooShallow = how.angle < kMinJointAngle;
    return {isTooShallow ? FFF_TEXT("Checks", "%1 and %2 almost lie in one plane: they meet at %3, "
                                              "and below %4 no slit can hold them.")
                         : FFF_TEXT("Checks", "%1 and %2 meet at %3; slits get wide below %4."),
            {nameAt(finding, model, 0), nameAt(finding, model, 1), angleOf(how.angle),
             angleOf(isTooShallow ? kMinJointAngle : how.least)}};
}

/// Between the planes of two sections, 0 … π/2.
double angleBetween(const Model &model, const std::pair<int, int> &sections)
{
    const Vec3 a = model.section(static_cast<std::size_t>(sections.first))->frame.normal();
    const Vec3 b = model.section(static_cast<std::size_t>(sections.second))->frame.normal();
    return std::atan2(a.cross(b).norm(), std::abs(a.dot(b)));
}

/// mm that a hand files away; more of one part in another cannot be put together.
constexpr double kFiledAway = 1.0;

/// What is so deep in another one cannot be made; a little is filed away. What ends in the middle
/// of the other's thickness does so but for rounding.
Severity severityOf(double depth, const Model &model, const std::pair<int, int> &sections)
{
    const double thinner =
        std::min(model.stockOf(static_cast<std::size_t>(sections.first)).thickness,
                 model.stockOf(static_cast<std::size_t>(sections.second)).thickness);
    const bool isFiled = depth <= std::min(0.5 * thinner, kFiledAway) + kTouchingDepth;
    return isFiled ? Severity::Warning : Severity::Error;
}

/// Of all pieces of two sections the deepest.
std::map<std::pair<int, int>, const Interpenetration *> deepestOf(const ModelPlan &plan)
{
    std::map<std::pair<int, int>, const Interpenetration *> deepest;
    for (const PartOverlap &overlap : plan.overlaps) {
        const int a = plan.bodies.sectionOf(overlap.a);
        const int b = plan.bodies.sectionOf(overlap.b);
        const Interpenetration *&known = deepest[{a, b}];
        if (!known || overlap.how.depth > known->depth)
            known = &overlap.how;
    }
    return deepest;
}

constexpr Text kMakeRoom =
    FFF_TEXT("Checks", "Move one of them aside, or let it end before the other.");

} // namespace

const FindingKind kNoSlit{.name = "interference",
                          .subject = Subject::Joints,
                          .title = FFF_TEXT("Checks", "Sections overlap"),
                          .sentence = noSlitSentence,
                          .actions = noSlitActions,
                          .advice = kMakeRoom};
const FindingKind kInterference{.name = "interference",
                                .subject = Subject::Joints,
                                .title = FFF_TEXT("Checks", "Sections overlap"),
                                .sentence = interferenceSentence,
                                .actions = mendsOfPair,
                                .advice = kMakeRoom,
                                .titled = interferenceTitle};
const FindingKind kShallowAngle{
    "shallowAngle",  Subject::Joints, FFF_TEXT("Checks", "Angle too flat"),
    shallowSentence, turnEither,      nullptr,
    nullptr,         nullptr,         FFF_TEXT("Checks", "Turn one of them to a steeper angle.")};

void findJointFaults(const Looked &at, std::vector<Finding> &found)
{
    const Model &model = at.analysis.model;
    for (const Joint &joint : at.analysis.assembly.joints) {
        const Crossing &crossing = *joint.crossing;
        const bool collides = joint.kind == JointKind::None;
        if ((!collides && !(crossing.angle < at.rules.shallowAngle)) || onlyTouch(joint, at.rules))
            continue;
        const auto longest = std::max_element(
            crossing.overlaps.begin(), crossing.overlaps.end(),
            [](const Overlap &a, const Overlap &b) { return a.to - a.from < b.to - b.from; });
        const double length = longest->to - longest->from;
        Finding finding = collides
                              ? makeFinding(kNoSlit, severityOf(length, model, {joint.a, joint.b}),
                                            MissingSlit{length, whyNoSlit(model, joint)})
                              : makeFinding(kShallowAngle, Severity::Warning,
                                            ShallowAngle{crossing.angle, at.rules.shallowAngle});
        finding.sections = model.refs({joint.a, joint.b});
        finding.joint = JointRef(finding.sections[0], finding.sections[1]);
        finding.at = crossing.axis.at(0.5 * (longest->from + longest->to));
        found.push_back(std::move(finding));
    }
}

void findInterferences(const LookedAtPlan &at, std::vector<Finding> &found)
{
    const Model &model = at.analysis.model;
    for (const auto &[pair, how] : deepestOf(at.plan)) {
        const Joint *joint = at.analysis.assembly.joints.find(pair.first, pair.second);
        if (joint && (joint->kind == JointKind::None || onlyTouch(*joint, at.rules)))
            continue; // it is said of the joint
        if (!joint && how->depth < at.rules.touching)
            continue;
        const double angle = angleBetween(model, pair);
        const bool isTooShallow = !joint && angle > kPracticallyParallel && angle < kMinJointAngle;
        const Severity severity = severityOf(how->depth, model, pair);
        // Too shallow an angle is why there is no slit.
        Finding finding =
            isTooShallow
                ? makeFinding(kShallowAngle, Severity::Error, ShallowAngle{angle, kMinJointAngle})
                : makeFinding(kInterference, severity, Interference{how->depth, joint != nullptr});
        finding.sections = model.refs({pair.first, pair.second});
        finding.at = how->at;
        if (joint)
            finding.joint = JointRef(finding.sections[0], finding.sections[1]);
        found.push_back(std::move(finding));
    }
}

} // namespace fff
