// section.pull: the selected sections pull templates ("on", "true" or "false") from so far
// ("radius", mm).
#pragma once

#include "core/interaction/commands.h"
#include "core/interaction/interaction.h"
#include "core/session/session.h"

namespace fff {

void registerMagnetCommands(CommandRegistry &registry, Session &session, Interaction &interaction);

} // namespace fff
