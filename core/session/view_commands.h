// What is seen, and from where.
#pragma once

#include "core/interaction/commands.h"
#include "core/interaction/interaction.h"
#include "core/session/session.h"

namespace fff {

/// view.front … view.left, view.iso, view.fitAll, view.fitSelection, view.faceSelection,
/// view.previous, view.hide, view.showAll, and the switches view.perspective, view.xray,
/// view.isolate, view.clip and view.shadow, which take the parameter "on" ("true", "false"; without
/// it they turn over). view.fitSelection takes "share", 0.1 to 1: the part of the view's width and
/// height that the selection may take, 1 without it. With less it stays in sight of what is round.
void registerViewCommands(CommandRegistry &registry, Session &session, Interaction &interaction);

/// The camera turned to an orientation so that the middle of what is selected, else of the model,
/// keeps its place on the screen. The view commands turn so, animated.
Camera turnedTo(const Eigen::Quaterniond &orientation, const Session &session,
                const Interaction &interaction);

} // namespace fff
