// The commands that need no window.
#pragma once

#include "core/interaction/commands.h"
#include "core/interaction/interaction.h"
#include "core/session/session.h"

namespace fff::hints {

inline constexpr Text kJointNotDeleted =
    FFF_TEXT("Hint", "Nothing deleted: a joint is where two sections meet. Delete one of them, or "
                     "choose the kind \u201cNone\u201d.");

} // namespace fff::hints

namespace fff {

/// file.new, edit.undo, edit.redo, edit.delete, and those of the other *_commands.h here. What is
/// copied stays in the registry, unless the window gives it another clipboard (copy_commands.h).
/// Session and interaction outlive the registry.
void registerSessionCommands(CommandRegistry &registry, Session &session, Interaction &interaction);

} // namespace fff
