// Dragging the plane that cuts the view open along its normal.
#pragma once

#include "core/interaction/gesture.h"

namespace fff::hints {

inline constexpr Text kMovingCut = FFF_TEXT(
    "Hint", "Move to shift the cut, release to leave it there. <kbd>Esc</kbd> puts it back.");

} // namespace fff::hints

namespace fff {

/// Where the plane is taken hold of: in it, before the middle of the model.
Vec3 clipHandle(const ClipPlane &plane, const Box3 &bounds);
/// How near the cursor must come to it, px.
inline constexpr double kHandleReach = 10.0;

class ClipGesture : public Gesture
{
public:
    /// A view must be cut open.
    ClipGesture(const PointerEvent &press, const GestureContext &context);

    GestureReply handle(const PointerEvent &event, GestureContext &context) override;
    GestureReply cancel(GestureContext &context) override;
    Hint hint() const override { return hints::kMovingCut; }
    Cursor cursor() const override { return Cursor::MoveCross; }

private:
    Vec2 m_press; // px
    ClipPlane m_before;
    Vec2 m_perMillimetre;   // px that a drag has for 1 mm along the normal
    double m_least, m_most; // mm that the plane may go along its normal
};

} // namespace fff
