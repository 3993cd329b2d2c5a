// The contract of tools: what a person asks for besides the strokes that need no asking (redraw, a
// hole, a plane to draw on, the pen). While a tool is held it has the left button and a few keys;
// the view is still turned, moved and zoomed as ever. Esc, or asking for it again, lays it down.
#pragma once

#include "core/interaction/gesture.h"

#include <string_view>

namespace fff {

/// handle() gets every left press, the moves (also without a button), the releases and double
/// clicks as they come, none while the view is moved. A reply that is Over lays it down; one that
/// is Running may carry a commit all the same (the pen stays in the hand).
class Tool : public Gesture
{
public:
    /// The id of the command that picks it up; its action is checked while it is held.
    virtual std::string_view command() const = 0;
    /// Once, when it is picked up: may turn the view (GestureReply::turnTo).
    virtual GestureReply begin(GestureContext & /*context*/, double /*time*/) { return {}; }
    /// A key that it has a use for; what it has none for does what it does elsewhere.
    virtual bool wants(ToolKey /*key*/) const { return false; }
    virtual GestureReply key(ToolKey /*key*/, GestureContext & /*context*/) { return {}; }
    /// The document changed, not by this tool (undo, an edit in a dock). By default it is laid
    /// down.
    virtual GestureReply modelChanged(GestureContext &context) { return cancel(context); }
};

} // namespace fff
