// Where a section is strong enough.
#pragma once

#include "core/interaction/commands.h"
#include "core/interaction/interaction.h"
#include "core/session/session.h"

namespace fff {

/// physics.whereStrong  of the section that is selected; again: of none. on: true, false
/// Session and interaction outlive the registry.
void registerBearingCommands(CommandRegistry &registry, Session &session, Interaction &interaction);

} // namespace fff
