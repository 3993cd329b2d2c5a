// What a mouse, a trackpad or a recorded script does over the view, free of any window.
#pragma once

#include "core/geometry/vector.h"

namespace fff {

enum class Button { None, Left, Middle, Right };

/// What the hand points with: the coarser, the farther marks reach.
enum class Pointer { Mouse, Pen, Finger };

struct Modifiers
{
    bool shift = false, control = false, space = false;
    bool operator==(const Modifiers &) const = default;
};

struct PointerEvent
{
    /// Modifiers: a key was pressed or let go, the cursor stays where it is.
    enum class Type {
        Press,
        Move,
        Release,
        Wheel,
        Zoom,
        Scroll,
        Twist,
        DoubleClick,
        Leave,
        Modifiers
    };
    Type type = Type::Move;
    Vec2 position = Vec2::Zero(); // px
    Button button = Button::None; // that was pressed or released
    Modifiers modifiers;
    Pointer pointer = Pointer::Mouse;
    double wheelSteps = 0.0;    // notches, positive away from the person
    double zoomFactor = 1.0;    // Zoom: two fingers apart; above 1 is nearer
    Vec2 scroll = Vec2::Zero(); // Scroll: px that two fingers push the picture
    double angle = 0.0;         // Twist: radians that two fingers turn the picture, clockwise
    double time = 0.0;          // ms, the only clock
    /// More moves are at hand and follow at once: this one is taken in, nothing is shown for it.
    bool isFollowed = false;

    /// The second press of two quick ones comes as a double click.
    bool isPress() const { return type == Type::Press || type == Type::DoubleClick; }
};

/// Keys that a tool may use besides the buttons.
enum class ToolKey { Enter, Backspace };

} // namespace fff
