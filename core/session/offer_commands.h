// Commands for what is offered once something was drawn.
#pragma once

#include "core/interaction/commands.h"
#include "core/interaction/interaction.h"

namespace fff {

/// section.takeOffer
///     makes of what was just drawn what the chip beside it says; a step of its own.
/// The interaction outlives the registry.
void registerOfferCommands(CommandRegistry &registry, Interaction &interaction);

} // namespace fff
