// The skin over the model, as the view shows it.
#pragma once

#include "core/interaction/commands.h"
#include "core/session/session.h"

namespace fff {

/// view.skin  on: true, false. Worked out while it is on, of the view and not of the document: a
/// document that comes in has none. Off again stops it. The session outlives the registry.
void registerSkinCommands(CommandRegistry &registry, Session &session);

} // namespace fff
