// The commands of the pen.
#pragma once

#include "core/interaction/commands.h"
#include "core/interaction/interaction.h"

namespace fff {

/// section.pen (with the parameter "on" as the switches have it), section.snap ("on" as well) and
/// section.penPoint, which sets the pen's next point: parameters "x" and "y", mm in the canvas'
/// grid (snapping.h), or from the last point "dx" and "dy", mm, or "length", mm, and "angle",
/// degrees counter-clockwise from the grid's x. What is not given stays as it is where the cursor
/// is. The interaction outlives the registry.
void registerPenCommands(CommandRegistry &registry, Interaction &interaction);

} // namespace fff
