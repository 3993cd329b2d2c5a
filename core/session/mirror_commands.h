// Commands of the mirror in the hand (core/interaction/mirror_tool.h).
//
//   edit.mirror      picks it up: a copy of what is selected, else the whole model from now on
//   mirror.x, mirror.y, mirror.z, mirror.section    across which plane
//   mirror.copy      an image of the selected sections
//   mirror.always    an operation: what is on one side stands on the other side, too
//   mirror.once      the same, as drawn sections
//   mirror.apply     does what is shown
#pragma once

#include "core/interaction/commands.h"
#include "core/interaction/interaction.h"
#include "core/interaction/section_edit.h"
#include "core/session/session.h"

namespace fff {

void registerMirrorCommands(CommandRegistry &registry, Session &session, Interaction &interaction);

/// What a mirror, which is none of the document's, would make of the model, as drawn sections.
/// Refused where that is nothing.
SectionEdit madeSymmetric(const Model &model, Operation mirror);

} // namespace fff
