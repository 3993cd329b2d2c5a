// Drags that move the camera: orbit, pan and zoom.
#pragma once

#include "core/interaction/gesture.h"

namespace fff::hints {

inline constexpr Text kOrbiting = FFF_TEXT("Hint", "Move to turn the view, release to stop.");
inline constexpr Text kPanning = FFF_TEXT("Hint", "Move to shift the view, release to stop.");
inline constexpr Text kZooming =
    FFF_TEXT("Hint", "Move up to zoom in, down to zoom out; release to stop.");

} // namespace fff::hints

namespace fff {

/// Turns the view about a pivot that keeps its place on the screen.
class OrbitGesture : public Gesture
{
public:
    OrbitGesture(const PointerEvent &press, const Vec3 &pivot)
        : m_last(press.position), m_pivot(pivot)
    {
    }
    GestureReply handle(const PointerEvent &event, GestureContext &context) override;
    GestureReply cancel(GestureContext &context) override;
    bool isOfView() const override { return true; }
    Hint hint() const override { return Hint::ofView(hints::kOrbiting); }
    Cursor cursor() const override { return Cursor::TurningArrows; }

private:
    Vec2 m_last;
    Vec3 m_pivot;
    std::optional<Camera> m_before;
};

/// Moves the view so that what was pressed stays under the cursor.
class PanGesture : public Gesture
{
public:
    explicit PanGesture(const PointerEvent &press) : m_press(press.position) {}
    GestureReply handle(const PointerEvent &event, GestureContext &context) override;
    GestureReply cancel(GestureContext &context) override;
    bool isOfView() const override { return true; }
    Hint hint() const override { return Hint::ofView(hints::kPanning); }
    Cursor cursor() const override { return Cursor::Hand; }

private:
    Vec2 m_press;
    std::optional<Camera> m_before;
};

/// Up is nearer, down farther away, about what was pressed.
class ZoomGesture : public Gesture
{
public:
    explicit ZoomGesture(const PointerEvent &press) : m_press(press.position) {}
    GestureReply handle(const PointerEvent &event, GestureContext &context) override;
    GestureReply cancel(GestureContext &context) override;
    bool isOfView() const override { return true; }
    Hint hint() const override { return Hint::ofView(hints::kZooming); }
    Cursor cursor() const override { return Cursor::MoveCross; }

private:
    Vec2 m_press;
    std::optional<Camera> m_before;
};

} // namespace fff
