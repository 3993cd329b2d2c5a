// How far the selected section pulls templates, in the view: a line through its middle, along its
// normal, with a handle.
#pragma once

#include "core/interaction/gesture.h"

#include <optional>

namespace fff {

struct MagnetHandle
{
    SectionRef section;
    Vec3 middle = Vec3::Zero(); // of its contour, world, mm
    Vec3 way = Vec3::UnitZ();   // unit, its normal, to the side that is seen
    double radius = 0.0;        // mm

    Vec3 at() const { return middle + radius * way; }
    bool operator==(const MagnetHandle &) const = default;
};

/// Of the one section that is selected; nothing where it pulls nothing, or is seen so straight that
/// the handle would lie on it.
std::optional<MagnetHandle> magnetHandle(const Model &model, const Selection &selection,
                                         const Camera &camera);
bool isOnMagnet(const MagnetHandle &handle, const GestureContext &context, const Vec2 &position,
                double reach);
/// isInHand: with its length.
void addMagnetSigns(const MagnetHandle &handle, bool isInHand, Signs &signs);
void removeMagnetSigns(Signs &signs);

class MagnetGesture : public Gesture
{
public:
    MagnetGesture(const MagnetHandle &handle, const PointerEvent &press,
                  const GestureContext &context);

    GestureReply handle(const PointerEvent &event, GestureContext &context) override;
    GestureReply cancel(GestureContext &context) override;
    Hint hint() const override;
    Cursor cursor() const override { return Cursor::MoveCross; }

private:
    double radiusAt(const Vec2 &position, const GestureContext &context) const;

    MagnetHandle m_handle;
    const std::string m_name; // of its section
    const double m_before;
    double m_grip = 0.0; // mm, from the handle to where it is held
};

} // namespace fff
