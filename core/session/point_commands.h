// The commands that edit control points, and remove holes.
#pragma once

#include "core/interaction/commands.h"
#include "core/interaction/interaction.h"
#include "core/session/session.h"

namespace fff {

/// point.insert (parameters "boundary", "segment" and "t"; without them at the place of the contour
/// that is under the cursor, else beside the selected points), point.delete, point.smooth,
/// point.symmetric, point.corner, point.select ("boundary", "index", "add"), section.removeHoles,
/// and nudge.left, nudge.right, nudge.up, nudge.down ("distance", mm). Session and interaction
/// outlive the registry.
void registerPointCommands(CommandRegistry &registry, Session &session, Interaction &interaction);

} // namespace fff
