// physics.addWeight, addPush, pull, setLoad, removeLoad, selectLoad, heavier and lighter: what acts
// on sections.
#pragma once

#include "core/interaction/commands.h"
#include "core/interaction/interaction.h"
#include "core/session/session.h"

namespace fff {

/// addWeight, addPush and pull take up their tools; with "section" (its name) the first two put one
/// there. The others take "load", its place in the list (without it: the selected one, else the
/// first); heavier and lighter "by", how much to add or take off (kg or N; without it a step of the
/// keys), the rest what setLoad takes: "x" and "y" (mm, the section's frame), "mass", "filled"
/// (kg), "height" (mm), "force" (N), "dx", "dy" and "dz" (the push's direction in the world),
/// "spread", "width" (mm), "repeated", "preset" and "name". Session and interaction outlive the
/// registry.
void registerLoadCommands(CommandRegistry &registry, Session &session, Interaction &interaction);

} // namespace fff
