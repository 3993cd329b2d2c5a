// physics.addWeight, setWeight, removeWeight, selectWeight, heavier and lighter: weights that hang
// on sections.
#pragma once

#include "core/interaction/commands.h"
#include "core/interaction/interaction.h"
#include "core/session/session.h"

namespace fff {

/// addWeight takes up the tool; with "section" (its name), "mass" (kg) and perhaps "x" and "y" (mm,
/// its frame) it hangs one there. The others take "weight", its place in the list (without it: the
/// selected one, else the first); setWeight "mass", "x", "y" and "name", heavier and lighter the
/// "mass" to add or take off (10 g without it). Session and interaction outlive the registry.
void registerWeightCommands(CommandRegistry &registry, Session &session, Interaction &interaction);

} // namespace fff
