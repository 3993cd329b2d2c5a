// A frame pulled over sections, or over the points of one, to select those that lie in it.
#pragma once

#include "core/interaction/gesture.h"

namespace fff::hints {

inline constexpr Text kRubberBand = FFF_TEXT(
    "Hint", "Release to select everything that is completely inside. <kbd>Esc</kbd> cancels.");
inline constexpr Text kPointBand =
    FFF_TEXT("Hint", "Release to select the points inside. <kbd>Esc</kbd> cancels.");

} // namespace fff::hints

namespace fff {

/// The frame itself; what it selects is the subclasses' matter.
class BandGesture : public Gesture
{
public:
    GestureReply handle(const PointerEvent &event, GestureContext &context) final;
    GestureReply cancel(GestureContext &context) final;
    Cursor cursor() const final { return Cursor::Arrow; }

protected:
    explicit BandGesture(const PointerEvent &press) : m_press(press.position) {}

private:
    /// Selects what lies in the band (px).
    virtual void select(const Box2 &band, const GestureContext &context, GestureReply &reply) = 0;
    /// Selects what was before.
    virtual void restore(GestureReply &reply) = 0;

    Vec2 m_press; // px
};

/// Selects the sections that are wholly inside: sections run through each other, so that a band
/// that took what it touches would hardly ever leave the body of a model out. Hidden ones and
/// ghosts are passed over.
class RubberBandGesture : public BandGesture
{
public:
    RubberBandGesture(const PointerEvent &press, const GestureContext &context);
    Hint hint() const override { return hints::kRubberBand; }

private:
    void select(const Box2 &band, const GestureContext &context, GestureReply &reply) override;
    void restore(GestureReply &reply) override { reply.select = m_before; }

    std::vector<SectionRef> m_before; // selected
};

/// Selects points of one section.
class PointBandGesture : public BandGesture
{
public:
    bool marksPoints() const override { return true; }
    PointBandGesture(const PointerEvent &press, const Section &section,
                     const GestureContext &context);
    Hint hint() const override { return hints::kPointBand; }

private:
    void select(const Box2 &band, const GestureContext &context, GestureReply &reply) override;
    void restore(GestureReply &reply) override { reply.selectPoints = m_before; }

    ShapePointer m_shape;
    Frame m_frame;
    std::vector<PointAddress> m_before; // selected
};

} // namespace fff
