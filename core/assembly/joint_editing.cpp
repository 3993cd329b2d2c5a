#include "core/assembly/joint_editing.h"

#include "core/assembly/found_joint.h"
#include "core/assembly/joint_words.h"
#include "core/assembly/trim.h"
#include "core/model/edit_words.h"
#include "core/model/edits.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fff {

namespace {

//: %1 and %2 are the names of two sections
constexpr Text kFlipSlits = FFF_TEXT("Step", "%1 · %2: flip the slits");
//: %1 and %2 are the names of two sections, %3 a number
constexpr Text kMoveMeetingPoint = FFF_TEXT("Step", "%1 · %2: meeting point → %3\u202f%");
//: %1 and %2 are the names of two sections
constexpr Text kResetJoint = FFF_TEXT("Step", "%1 · %2: restore automatic settings");

Text kindText(JointKind kind)
{
    switch (kind) {
    case JointKind::CrossLap:
        //: %1 and %2 are the names of two sections
        return FFF_TEXT("Step", "%1 · %2: kind → cross lap");
    case JointKind::ExtendedCrossLap:
        //: %1 and %2 are the names of two sections
        return FFF_TEXT("Step", "%1 · %2: kind → extended cross lap");
    case JointKind::Mortise:
        //: %1 and %2 are the names of two sections
        return FFF_TEXT("Step", "%1 · %2: kind → mortise");
    case JointKind::Tabs:
        //: %1 and %2 are the names of two sections
        return FFF_TEXT("Step", "%1 · %2: kind → tabs");
    case JointKind::None:
        break;
    }
    //: %1 and %2 are the names of two sections
    return FFF_TEXT("Step", "%1 · %2: kind → none");
}

std::vector<Argument> namesOf(const Model &model, const JointRef &joint)
{
    return {Named{model.nameOf(joint.a)}, Named{model.nameOf(joint.b)}};
}

/// In percent of the second section's slit. share: of the first one's.
Step movedTo(const Model &model, const JointRef &joint, double share)
{
    std::vector<Argument> arguments = namesOf(model, joint);
    arguments.emplace_back(static_cast<int>(std::lround(100.0 * (1.0 - share))));
    return {kMoveMeetingPoint, std::move(arguments)};
}

/// Nothing for a section that is not drawn, or not in the other.
std::optional<ShapePointer> trimmedShape(const Model &model, const SectionRef &section,
                                         const SectionRef &to)
{
    const int index = model.indexOf(section), other = model.indexOf(to);
    if (!section.drawn.isValid() || index < 0 || other < 0 || index == other)
        return {};
    Result<ShapePointer> shape = trimmed(sideOf(model, index), sideOf(model, other));
    return shape ? std::optional(*std::move(shape)) : std::nullopt;
}

JointEdit edited(const Model &model, JointOverride wanted, Step step)
{
    const JointRef joint(wanted.a, wanted.b);
    Result<Document> next = setJointOverride(model.document, std::move(wanted));
    if (!next)
        return refused(hints::kEditFailed);
    return EditedJoint{*std::move(next), std::move(step)};
}

} // namespace

JointEdit setKind(const Model &model, const JointRef &joint, JointKind kind)
{
    const std::optional<JointState> state = jointState(model, joint);
    if (!state || state->obstacleTo(kind) != JointObstacle::None)
        return refused(hints::kJointCannotBe, namesOf(model, joint));
    return edited(model, withKind(model, *state, kind), {kindText(kind), namesOf(model, joint)});
}

JointEdit flipSlits(const Model &model, const JointRef &joint)
{
    const std::optional<JointState> state = jointState(model, joint);
    if (!state || !state->canFlip)
        return refused(hints::kJointCannotFlip, namesOf(model, joint));
    return edited(model, flipped(model, *state), {kFlipSlits, namesOf(model, joint)});
}

JointEdit moveMeetingPoint(const Model &model, const JointRef &joint, int overlap, double share)
{
    const std::optional<JointState> state = jointState(model, joint);
    if (!state || overlap < 0 || overlap >= static_cast<int>(state->shares.size()) ||
        !state->shares[static_cast<std::size_t>(overlap)])
        return refused(hints::kNoMeetingPoint, namesOf(model, joint));
    JointOverride wanted = withShare(model, *state, overlap, share);
    if (std::abs(*state->shares[static_cast<std::size_t>(overlap)] - share) < kSameShare)
        wanted = state->wanted; // else its place alone would be another one
    return edited(model, std::move(wanted), movedTo(model, joint, share));
}

JointEdit nudgeMeetingPoints(const Model &model, const JointRef &joint, double by)
{
    std::optional<JointState> state = jointState(model, joint);
    Step step;
    bool moves = false;
    for (std::size_t i = 0; state && i < state->shares.size(); ++i) {
        if (!state->shares[i])
            continue;
        const Overlap &o = state->crossing.overlaps[i];
        const double share = std::clamp(*state->shares[i] - state->sign * by / (o.to - o.from),
                                        kLeastShare, 1.0 - kLeastShare);
        if (!moves)
            step = movedTo(model, joint, share);
        if (std::abs(share - *state->shares[i]) >= kSameShare)
            state->wanted = withShare(model, *state, static_cast<int>(i), share);
        moves = true;
    }
    if (!moves)
        return refused(hints::kNoMeetingPoint, namesOf(model, joint));
    step.merges = "meeting point";
    for (const SectionRef &section : {joint.a, joint.b})
        step.merges.append(" ").append(std::to_string(model.indexOf(section)));
    return edited(model, std::move(state->wanted), std::move(step));
}

JointEdit joinWithTabs(const Model &model, const JointRef &joint)
{
    const int a = model.indexOf(joint.a), b = model.indexOf(joint.b);
    if (a < 0 || b < 0 || a == b || !tabsOf(model, std::min(a, b), std::max(a, b)))
        return refused(hints::kJointCannotBe, namesOf(model, joint));
    JointOverride wanted;
    if (const JointOverride *before = model.document.jointOverride(joint.a, joint.b))
        wanted = *before;
    wanted.a = joint.a;
    wanted.b = joint.b;
    wanted.kind = JointKind::Tabs;
    return edited(model, std::move(wanted), {kindText(JointKind::Tabs), namesOf(model, joint)});
}

JointEdit trimTo(const Model &model, const SectionRef &section, const SectionRef &to)
{
    const std::vector<Argument> names{Named{model.nameOf(section)}, Named{model.nameOf(to)}};
    const auto shape = trimmedShape(model, section, to);
    if (!shape)
        return refused(hints::kCannotTrim, names);
    Result<Document> next = setShape(model.document, section.drawn, *shape);
    if (!next)
        return refused(hints::kCannotTrim, names);
    return EditedJoint{*std::move(next), {steps::kTrimSection, names}};
}

std::optional<SectionRef> easierTrimmed(const Model &model, const JointRef &joint)
{
    std::optional<SectionRef> easier;
    double least = 0.0; // mm² lost
    for (const auto &[section, to] : {std::pair(&joint.a, &joint.b), {&joint.b, &joint.a}}) {
        const auto shape = trimmedShape(model, *section, *to);
        if (!shape)
            continue;
        const double lost = model.document.find(section->drawn)->shape->area() - (*shape)->area();
        if (!easier || lost < least) {
            easier = *section;
            least = lost;
        }
    }
    return easier;
}

JointEdit resetJoint(const Model &model, const JointRef &joint)
{
    JointOverride none;
    none.a = joint.a;
    none.b = joint.b;
    return edited(model, std::move(none), {kResetJoint, namesOf(model, joint)});
}

} // namespace fff
