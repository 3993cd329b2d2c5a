// The contract of tools: what a person asks for besides the strokes that need no asking (redraw, a
// hole, a plane to draw on, the pen). While a tool is held it has the left button and a few keys;
// the view is still turned, moved and zoomed as ever. Esc, or asking for it again, lays it down.
#pragma once

#include "core/interaction/contour_target.h"
#include "core/interaction/gesture.h"

#include <string_view>
#include <vector>

namespace fff {

/// A number that can be typed while a tool is held, in place of pointing. Lengths are mm, angles
/// radians. Points are counted in the canvas' grid (snapping.h), or from the last one.
struct ToolNumber
{
    enum class Kind {
        X,
        Y,
        DeltaX,
        DeltaY,
        Length,
        Angle,
        Distance,
        // How far what is selected goes: along the world's axes, or as its plane lies.
        MoveX,
        MoveY,
        MoveZ,
        MoveRight,
        MoveUp,
        MoveOut,
        Turn,
        Size,   // a factor
        Copies, // a count
        Wanted  // length of a dimension
    };
    Kind kind = Kind::X;
    double value = 0.0;

    bool operator==(const ToolNumber &) const = default;
};

/// Commands of a tool that belong together, and what is said before their buttons.
struct CommandGroup
{
    Text title = {}; // empty: nothing
    std::vector<std::string_view> commands;

    bool operator==(const CommandGroup &) const = default;
};

/// handle() gets every left press, the moves (also without a button), the releases and double
/// clicks as they come, none while the view is moved. A reply that is Over lays it down; one that
/// is Running may carry a commit all the same (the pen stays in the hand).
class Tool : public Gesture
{
public:
    /// The id of the command that picks it up; its action is checked while it is held.
    virtual std::string_view command() const = 0;
    /// Asked for again with the same command: whether that is to lay it down.
    virtual bool isSame(const Tool &other) const { return command() == other.command(); }
    /// Once, when it is picked up: may turn the view (GestureReply::turnTo).
    virtual GestureReply begin(GestureContext & /*context*/, double /*time*/) { return {}; }
    /// Once, when it is laid down, whatever for: what it has switched on for itself goes with it.
    virtual void end(GestureContext & /*context*/) {}
    /// Whether it has a use for a left press; one that it has none for does what it does without a
    /// tool.
    virtual bool takes(const PointerEvent & /*press*/, GestureContext & /*context*/) const
    {
        return true;
    }
    /// It has a use for the press also while Ctrl is held, with which drags turn the view.
    virtual bool takesControl(const PointerEvent & /*press*/, GestureContext & /*context*/) const
    {
        return false;
    }
    /// Arrow keys move what is selected, as without it.
    virtual bool leavesArrows() const { return false; }
    /// It works with clicks: also with those while Ctrl is held, whose drags turn the view.
    virtual bool takesClicks() const { return false; }
    /// What is begun in the view with a press that it has no use for lays it down, unless that
    /// moves the view alone.
    virtual bool givesWay() const { return false; }
    /// Of one that asks for an input of an operation that there is: of which, and its role.
    struct Asked
    {
        OperationId operation;
        std::string role;
        bool operator==(const Asked &) const = default;
    };
    virtual Asked asksFor() const { return {}; }
    /// The section under the cursor is marked as without a tool.
    virtual bool marksSections() const { return false; }
    /// Adds what it has in hand to overlay.held, which is empty then: after each event, also while
    /// the view is moved. hasCursor: the cursor is its own, and not over something else.
    virtual void mark(GestureContext & /*context*/, bool /*hasCursor*/) {}
    /// What the pressed button does ends here, since the view or the document becomes another one;
    /// its release does not come any more.
    virtual GestureReply interrupt(GestureContext & /*context*/) { return {}; }
    /// The view is about to be moved by other means: an animation of its own ends at once.
    virtual void finish(GestureContext & /*context*/) {}

    /// Steps of its own; Undo and Redo go through them first.
    virtual bool canUndo() const { return false; }
    virtual bool canRedo() const { return false; }
    virtual GestureReply undo(GestureContext & /*context*/) { return {}; }
    virtual GestureReply redo(GestureContext & /*context*/) { return {}; }

    /// A canvas was picked while it is held. None: it does not draw on canvases.
    virtual std::optional<GestureReply> useCanvas(CanvasChoice /*canvas*/,
                                                  GestureContext & /*context*/)
    {
        return {};
    }

    /// The numbers that can be typed now, and what they are; a bar over the view has a field for
    /// each.
    virtual std::vector<ToolNumber> numbers() const { return {}; }
    /// These are to be so: shown as if the cursor were there, done by Enter, or dropped.
    virtual GestureReply setNumbers(const std::vector<ToolNumber> & /*numbers*/,
                                    GestureContext & /*context*/)
    {
        return {};
    }
    virtual GestureReply dropNumbers(GestureContext & /*context*/) { return {}; }

    /// Commands that go with it: the bar over the view has a button for each.
    virtual std::vector<std::string_view> commands() const { return {}; }
    /// The same by what belongs together.
    virtual std::vector<CommandGroup> commandGroups() const { return {{{}, commands()}}; }
    /// That of them which does what the tool is for, and stands out; empty: none does.
    virtual std::string_view mainCommand() const { return {}; }

    /// A key that it has a use for; what it has none for does what it does elsewhere.
    virtual bool wants(ToolKey /*key*/) const { return false; }
    virtual GestureReply key(ToolKey /*key*/, GestureContext & /*context*/) { return {}; }
    /// The document changed, not by this tool (undo, an edit in a dock). By default it is laid
    /// down.
    virtual GestureReply modelChanged(GestureContext &context) { return cancel(context); }
};

} // namespace fff
