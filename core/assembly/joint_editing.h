// Edits of joints as a person asks for them, with what the history says of them, or why they cannot
// be had. The commands, the drag in the view and the Properties dock share them.
#pragma once

#include "core/assembly/joint_state.h"
#include "core/model/hint.h"
#include "core/model/step.h"

#include <tl/expected.hpp>

namespace fff {

struct EditedJoint
{
    Document document; // the same when it was so already
    Step step;
};
using JointEdit = tl::expected<EditedJoint, Hint>;

JointEdit setKind(const Model &model, const JointRef &joint, JointKind kind);
JointEdit flipSlits(const Model &model, const JointRef &joint);
/// share: of the slit of the joint's a.
JointEdit moveMeetingPoint(const Model &model, const JointRef &joint, int overlap, double share);
/// All places where slits of the joint meet by so much along its axis, mm, as far as they can go.
/// Several such steps are one.
JointEdit nudgeMeetingPoints(const Model &model, const JointRef &joint, double by);
/// As setKind() for tabs, also of sections that have no joint because one only ends on the other.
JointEdit joinWithTabs(const Model &model, const JointRef &joint);
/// Cuts a section back to the faces of another one that it is in; only a drawn one.
JointEdit trimTo(const Model &model, const SectionRef &section, const SectionRef &to);
/// Of two that are in each other the one that loses less when it is trimmed to the other; none when
/// neither can be.
std::optional<SectionRef> easierTrimmed(const Model &model, const JointRef &joint);
/// Nothing is wanted of it any more, also of what is dormant now.
JointEdit resetJoint(const Model &model, const JointRef &joint);

} // namespace fff
