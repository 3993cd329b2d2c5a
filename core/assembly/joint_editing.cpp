#include "core/assembly/joint_editing.h"

#include "core/assembly/found_joint.h"
#include "core/assembly/trim.h"
#include "core/model/edits.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fff {

namespace {

tl::unexpected<Hint> refused(Hint::Kind kind, const Model &model, const JointRef &joint)
{
    return tl::unexpected<Hint>(Hint{kind, model.nameOf(joint.a), true, model.nameOf(joint.b)});
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
    step.names = {model.nameOf(joint.a), model.nameOf(joint.b)};
    Result<Document> next = setJointOverride(model.document, std::move(wanted));
    if (!next)
        return refused(Hint::Kind::EditFailed, model, joint);
    return EditedJoint{*std::move(next), std::move(step)};
}

Step stepOf(Step::Kind kind)
{
    return {kind, {}};
}

} // namespace

JointEdit setKind(const Model &model, const JointRef &joint, JointKind kind)
{
    const std::optional<JointState> state = jointState(model, joint);
    if (!state || state->obstacleTo(kind) != JointObstacle::None)
        return refused(Hint::Kind::JointCannotBe, model, joint);
    Step step = stepOf(Step::Kind::SetJointKind);
    step.joint = kind;
    return edited(model, withKind(model, *state, kind), std::move(step));
}

JointEdit flipSlits(const Model &model, const JointRef &joint)
{
    const std::optional<JointState> state = jointState(model, joint);
    if (!state || !state->canFlip)
        return refused(Hint::Kind::JointCannotFlip, model, joint);
    return edited(model, flipped(model, *state), stepOf(Step::Kind::FlipSlits));
}

JointEdit moveMeetingPoint(const Model &model, const JointRef &joint, int overlap, double share)
{
    const std::optional<JointState> state = jointState(model, joint);
    if (!state || overlap < 0 || overlap >= static_cast<int>(state->shares.size()) ||
        !state->shares[static_cast<std::size_t>(overlap)])
        return refused(Hint::Kind::NoMeetingPoint, model, joint);
    Step step = stepOf(Step::Kind::MoveMeetingPoint);
    step.count = static_cast<int>(std::lround(100.0 * (1.0 - share)));
    JointOverride wanted = withShare(model, *state, overlap, share);
    if (std::abs(*state->shares[static_cast<std::size_t>(overlap)] - share) < kSameShare)
        wanted = state->wanted; // else its place alone would be another one
    return edited(model, std::move(wanted), std::move(step));
}

JointEdit nudgeMeetingPoints(const Model &model, const JointRef &joint, double by)
{
    std::optional<JointState> state = jointState(model, joint);
    Step step = stepOf(Step::Kind::MoveMeetingPoint);
    bool moves = false;
    for (std::size_t i = 0; state && i < state->shares.size(); ++i) {
        if (!state->shares[i])
            continue;
        const Overlap &o = state->crossing.overlaps[i];
        const double share = std::clamp(*state->shares[i] - state->sign * by / (o.to - o.from),
                                        kLeastShare, 1.0 - kLeastShare);
        if (!moves)
            step.count = static_cast<int>(std::lround(100.0 * (1.0 - share)));
        if (std::abs(share - *state->shares[i]) >= kSameShare)
            state->wanted = withShare(model, *state, static_cast<int>(i), share);
        moves = true;
    }
    if (!moves)
        return refused(Hint::Kind::NoMeetingPoint, model, joint);
    step.merges = "meeting point";
    for (const SectionRef &section : {joint.a, joint.b})
        step.merges.append(" ").append(std::to_string(model.indexOf(section)));
    return edited(model, std::move(state->wanted), std::move(step));
}

JointEdit joinWithTabs(const Model &model, const JointRef &joint)
{
    const int a = model.indexOf(joint.a), b = model.indexOf(joint.b);
    if (a < 0 || b < 0 || a == b || !tabsOf(model, std::min(a, b), std::max(a, b)))
        return refused(Hint::Kind::JointCannotBe, model, joint);
    JointOverride wanted;
    if (const JointOverride *before = model.document.jointOverride(joint.a, joint.b))
        wanted = *before;
    wanted.a = joint.a;
    wanted.b = joint.b;
    wanted.kind = JointKind::Tabs;
    Step step = stepOf(Step::Kind::SetJointKind);
    step.joint = JointKind::Tabs;
    return edited(model, std::move(wanted), std::move(step));
}

JointEdit trimTo(const Model &model, const SectionRef &section, const SectionRef &to)
{
    const Hint cannot{Hint::Kind::CannotTrim, model.nameOf(section), true, model.nameOf(to)};
    const auto shape = trimmedShape(model, section, to);
    if (!shape)
        return tl::unexpected(cannot);
    Result<Document> next = setShape(model.document, section.drawn, *shape);
    if (!next)
        return tl::unexpected(cannot);
    Step step = stepOf(Step::Kind::TrimSection);
    step.names = {model.nameOf(section), model.nameOf(to)};
    return EditedJoint{*std::move(next), std::move(step)};
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
    return edited(model, std::move(none), stepOf(Step::Kind::ResetJoint));
}

} // namespace fff
