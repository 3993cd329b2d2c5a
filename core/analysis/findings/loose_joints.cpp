#include "core/analysis/findings/loose_joints.h"

#include "core/analysis/findings/ending_before.h"
#include "core/analysis/findings/moving_slits.h"
#include "core/analysis/findings/touching_pairs.h"

#include "core/base/tolerances.h"

#include <set>

namespace fff {

namespace {

bool isOneAxis(const Axis &a, const Axis &b)
{
    const Vec3 between = b.point - a.point;
    return a.direction.cross(b.direction).norm() <= kPracticallyParallel &&
           a.direction.cross(between).norm() <= kTouchingDepth;
}

/// The sections that the section and its joints along the axis hold together. O(their slits).
std::set<int> heldAlong(const Axis &axis, int section, const Analysis &analysis)
{
    std::set<int> held{section};
    for (std::vector<int> open{section}; !open.empty();) {
        const int at = open.back();
        open.pop_back();
        for (const Slit &slit : analysis.assembly.slits[static_cast<std::size_t>(at)]) {
            const Joint &joint = analysis.assembly.joints[static_cast<std::size_t>(slit.joint - 1)];
            if (joint.crossing && !held.contains(slit.guest) &&
                isOneAxis(axis, joint.crossing->axis) && !analysis.grips.of(joint).held.empty()) {
                held.insert(slit.guest);
                open.push_back(slit.guest);
            }
        }
    }
    return held;
}

/// Of sections that all cross in one axis most pairs hold nothing, and need not: each is held by
/// the one whose stretch of the axis is beside its own.
bool areHeldByOthers(const Joint &joint, const Analysis &analysis)
{
    return joint.crossing && heldAlong(joint.crossing->axis, joint.a, analysis).contains(joint.b);
}

Message looseJointSentence(const Finding &finding, const Model &model)
{
    const LooseJoint &loose = *finding.details<LooseJoint>();
    const Named host = nameAt(finding, model, 0), guest = nameAt(finding, model, 1);
    switch (loose.slit.why) {
    case NoGrip::OneWall:
        //: %1 and %2 are names of sections
        return {FFF_TEXT("Checks", "%1 does not hold %2: its slit runs along its edge and has "
                                   "material on one side only."),
                {host, guest}};
    case NoGrip::CutThrough:
        //: %1 and %2 are names of sections
        return {FFF_TEXT("Checks", "%1 does not hold %2: its slits cut it right through there."),
                {host, guest}};
    case NoGrip::Shallow:
        //: %1 and %2 are names of sections, %3 is a length
        return {FFF_TEXT("Checks", "%1 does not hold %2: its slit is less than %3 deep."),
                {host, guest, lengthOf(loose.slit.needed)}};
    case NoGrip::NoWall:
        //: %1 and %2 are names of sections
        return {FFF_TEXT("Checks", "%1 does not hold %2: its slit leaves no material on either "
                                   "side."),
                {host, guest}};
    case NoGrip::Empty:
        break;
    }
    //: %1 and %2 are names of sections
    return {FFF_TEXT("Checks", "%1 does not hold %2: other slits take away what would be in its "
                               "slit."),
            {host, guest}};
}

/// At an edge it is moved away from that; where something else takes its walls, one of the two ends
/// before the other.
bool isAtEdge(NoGrip why)
{
    return why == NoGrip::OneWall || why == NoGrip::Shallow || why == NoGrip::NoWall;
}

std::vector<FindingAction> moveIn(const Finding &finding, const Analysis &)
{
    if (isAtEdge(finding.details<LooseJoint>()->slit.why))
        return {{&kMoveIn}};
    return {{&kEndBefore}};
}

Text looseAdvice(const Finding &finding)
{
    if (isAtEdge(finding.details<LooseJoint>()->slit.why))
        return FFF_TEXT("Checks", "Move the slit in from the edge.");
    return FFF_TEXT("Checks", "Let one of the sections that cross there end before the others, or "
                              "move it aside.");
}

} // namespace

const FindingKind kLooseJoint{.name = "looseJoint",
                              .subject = Subject::Joints,
                              .title = FFF_TEXT("Checks", "Slit holds nothing"),
                              .sentence = looseJointSentence,
                              .actions = moveIn,
                              .advised = looseAdvice};

void findLooseJoints(const Looked &at, std::vector<Finding> &found)
{
    const Analysis &analysis = at.analysis;
    for (const Joint &joint : analysis.assembly.joints) {
        const std::optional<LooseSlit> &loose = analysis.grips.of(joint).loose;
        if (!loose || onlyTouch(joint, at.rules) || areHeldByOthers(joint, analysis))
            continue;
        const bool isInA = loose->isInA;
        Finding finding = makeFinding(kLooseJoint, Severity::Warning, LooseJoint{*loose});
        finding.sections = analysis.model.refs(isInA ? std::vector{joint.a, joint.b}
                                                     : std::vector{joint.b, joint.a});
        finding.joint = JointRef(finding.sections[0], finding.sections[1]);
        const auto host = static_cast<std::size_t>(isInA ? joint.a : joint.b);
        const auto slits = slitsOfJoint(analysis.assembly.slits[host], joint.id);
        if (static_cast<std::size_t>(loose->slit) < slits.size())
            finding.at = analysis.model.section(host)->frame.toWorld(
                slits[static_cast<std::size_t>(loose->slit)].inner);
        found.push_back(std::move(finding));
    }
}

} // namespace fff
