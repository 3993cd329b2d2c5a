// The commands that pick up tools and say how strokes are drawn.
#pragma once

#include "core/interaction/commands.h"
#include "core/interaction/interaction.h"
#include "core/session/session.h"

namespace fff {

/// section.redraw (of the selected section), section.addHole (of the selected one, else of the one
/// that the first drag begins on), section.planeGround,
/// section.planeFront, section.planeSide, section.planeParallel (to the selected section; parameter
/// "distance", mm along its normal), section.dropToGround, and the switches section.symmetry and
/// section.ground, which take the parameter "on" as those of the view do; and those of
/// pen_commands.h. Session and interaction outlive the registry.
void registerToolCommands(CommandRegistry &registry, Session &session, Interaction &interaction);

} // namespace fff
