// Commands for the joint that is selected: "joint.reset" and so on.
#pragma once

#include "core/interaction/commands.h"
#include "core/interaction/interaction.h"
#include "core/session/session.h"

namespace fff {

/// joint.select  a, b: names of its two sections
/// joint.kind    kind: crossLap, extendedCrossLap, mortise, none
/// joint.flip    its slits open to the other side
/// joint.share   percent: of the slit of the section that was drawn later, 5 … 95; overlap: 1 … n,
///               the first one unless it is said
/// joint.reset   all of it is as by itself again
/// The session and the interaction outlive the registry.
void registerJointCommands(CommandRegistry &registry, Session &session, Interaction &interaction);

} // namespace fff
