// physics.addWeight, physics.setWeight and physics.removeWeight: weights that hang on sections.
#pragma once

#include "core/interaction/commands.h"
#include "core/interaction/interaction.h"
#include "core/session/session.h"

namespace fff {

/// addWeight takes up the tool; with "section" (its name), "mass" (kg) and perhaps "x" and "y" (mm,
/// its frame) it hangs one there. The others take "weight", its place in the list, and setWeight
/// "mass". Session and interaction outlive the registry.
void registerWeightCommands(CommandRegistry &registry, Session &session, Interaction &interaction);

} // namespace fff
