// A frame pulled over sections to select those that lie in it.
#pragma once

#include "core/interaction/gesture.h"

namespace fff {

/// Selects the sections that are wholly inside: sections run through each other, so that a band
/// that took what it touches would hardly ever leave the body of a model out. Hidden ones and
/// ghosts are passed over.
class RubberBandGesture : public Gesture
{
public:
    explicit RubberBandGesture(const PointerEvent &press) : m_press(press.position) {}
    GestureReply handle(const PointerEvent &event, GestureContext &context) override;
    GestureReply cancel(GestureContext &context) override;
    Hint hint() const override { return {Hint::Kind::RubberBand, {}, false}; }
    Cursor cursor() const override { return Cursor::Arrow; }

private:
    Vec2 m_press;
    std::optional<std::vector<SectionRef>> m_before; // selected
};

/// Whether all of the section's region is seen within the box (px).
bool isSeenWithin(const Section &section, const Box2 &box, const Camera &camera,
                  const Vec2 &viewport);

} // namespace fff
