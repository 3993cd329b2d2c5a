#include "core/interaction/joint_editing.h"

#include "core/model/edits.h"

#include <cmath>
#include <utility>

namespace fff {

namespace {

/// Shares that differ by less are one.
constexpr double kSameShare = 1e-9;

std::string nameOf(const Model &model, const SectionRef &ref)
{
    const int index = model.indexOf(ref);
    return index < 0 ? std::string() : model.section(static_cast<std::size_t>(index))->name;
}

tl::unexpected<Hint> refused(Hint::Kind kind, const Model &model, const JointRef &joint)
{
    return tl::unexpected<Hint>(Hint{kind, nameOf(model, joint.a), true, nameOf(model, joint.b)});
}

JointEdit edited(const Model &model, JointOverride wanted, Step step)
{
    const JointRef joint(wanted.a, wanted.b);
    step.names = {nameOf(model, joint.a), nameOf(model, joint.b)};
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

JointEdit resetJoint(const Model &model, const JointRef &joint)
{
    JointOverride none;
    none.a = joint.a;
    none.b = joint.b;
    return edited(model, std::move(none), stepOf(Step::Kind::ResetJoint));
}

} // namespace fff
