// Runs a script of what a person does: the same state machines that the window feeds, on the clock
// that the script carries.
//
//     { "viewport": [1280, 800],
//       "events": [
//         {"type": "view", "name": "front"},                    at once; any named view, or "fit"
//         {"type": "press", "x": 640, "y": 400, "button": "left", "modifiers": ["shift"], "t": 0},
//         {"type": "move", "x": 660, "y": 380},
//         {"type": "release", "x": 640, "y": 400},
//         {"type": "wheel", "x": 640, "y": 400, "steps": 1},     away from the person is positive
//         {"type": "wait", "ms": 1000},
//         {"type": "command", "name": "edit.undo", "parameters": {}},
//         {"type": "key", "key": "Escape", "modifiers": []} ] }
//
// Pixels have their origin at the top left. "t" is ms since the script's start and never goes back;
// without it an event comes 8 ms after the one before, the first at 0 (and after "wait" when that
// is over). Keys are those that run commands, Escape, and Enter and Backspace for the tool in hand.
// "button" is left, middle or right, of a press left by default, of a release the one that is
// pressed. Modifiers are shift, control and space.
#pragma once

#include "core/interaction/commands.h"
#include "core/interaction/interaction.h"
#include "core/session/replay_script.h"
#include "core/session/session.h"

#include <QByteArray>

#include <functional>

namespace fff {

/// Runs the script with the session's own commands. The viewport that the script names is set
/// first; the model is told to the interaction whether or not a host does so.
/// Errors  BadSyntax (JSON that cannot be read), BadValue (place: "viewport", "events"), and for an
///         event that makes no sense there BadEvent, place "events[7]", args: what, what was
///         expected. Events before a wrong one have happened by then.
Result<void> replay(const QByteArray &script, Session &session, Interaction &interaction);
/// The same with these commands; `afterEach` is called after each event that went well.
Result<void> replay(const QByteArray &text, Session &session, Interaction &interaction,
                    const CommandRegistry &commands,
                    const std::function<void(const ReplayEvent &)> &afterEach = {});

} // namespace fff
