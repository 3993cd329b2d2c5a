// What a tool that works with clicks does with drags: they turn the view about the model's middle.
#pragma once

#include "core/interaction/view_gestures.h"

#include <optional>

namespace fff {

class TurningDrag
{
public:
    /// True for a release that makes a click of what began with the press.
    bool handle(const PointerEvent &event, GestureContext &context, GestureReply &reply);
    /// The view goes back to where it was before the drag.
    GestureReply interrupt(GestureContext &context);
    /// The button is down, and the view not turned yet.
    bool isPressed() const { return m_press.has_value(); }
    bool isTurning() const { return m_orbit.has_value(); }

private:
    std::optional<PointerEvent> m_press; // not a drag yet
    std::optional<OrbitGesture> m_orbit;
};

} // namespace fff
