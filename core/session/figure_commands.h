// Commands for shapes by numbers.
#pragma once

#include "core/interaction/commands.h"
#include "core/interaction/interaction.h"
#include "core/session/session.h"

namespace fff {

/// section.addCircle, section.addEllipse, section.addRectangle, section.addPolygon,
/// section.addStar, section.addSlot
///     the kind's numbers by their keys (core/geometry/figure.h); turn: degrees. With a section
///     selected, a hole in it: x, y: where, in its coordinates, else as near to its middle as it
///     fits. With none, a section of its own. as: section, hole or contour (in place of the
///     selected one's), where it is not to be so.
/// section.figure
///     other numbers of a boundary of the selected section: boundary (0, the contour, without it),
///     numbers, x, y and turn
/// section.addShape
///     picks up the tool that draws them; figure: the kind. While it is held, the commands above
///     without parameters say which kind it draws.
/// The session and the interaction outlive the registry.
void registerFigureCommands(CommandRegistry &registry, Session &session, Interaction &interaction);

} // namespace fff
