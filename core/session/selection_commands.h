// Commands that select sections.
#pragma once

#include "core/interaction/commands.h"
#include "core/interaction/interaction.h"
#include "core/session/session.h"

namespace fff {

/// edit.selectAll        all that are not hidden
/// edit.selectConnected  all that hang together with those that are selected, by joints that hold
/// edit.selectParallel   all whose planes are parallel to one that is selected
/// edit.selectSameStock  all of the stocks of those that are selected
/// edit.select           section: a name, or several, one on a line; by them alone
/// The session and the interaction outlive the registry.
void registerSelectionCommands(CommandRegistry &registry, Session &session,
                               Interaction &interaction);

} // namespace fff
