// The single stroke in the view: feeds the stroke's state machine with points on planes, turns the
// camera and shows the section that a release would make.
#pragma once

#include "core/interaction/gesture.h"
#include "core/stroke/stroke.h"

namespace fff {

class StrokeGesture : public Gesture
{
public:
    // The camera's target lies at the depth of what was pressed, so that pixels count there.
    /// The first section: on the plane through (0, kFirstPlaneHeight, 0) that faces the camera.
    StrokeGesture(const PointerEvent &press, const GestureContext &context);
    /// On a section, from the point that was hit.
    StrokeGesture(const PointerEvent &press, const Hit &hit, const GestureContext &context);

    GestureReply handle(const PointerEvent &event, GestureContext &context) override;
    void advance(double time, GestureContext &context) override;
    bool isAnimating() const override;
    GestureReply cancel(GestureContext &context) override;
    Hint hint() const override;
    Cursor cursor() const override;

private:
    struct Ground // the section that the stroke began on
    {
        SectionRef ref;
        SectionPointer section;
    };

    const Frame &plane() const; // that the cursor is on
    void beginTurn(GestureContext &context);
    void updateOverlay(GestureContext &context) const;
    void updateDocument(const GestureContext &context);
    GestureReply reply(GestureContext &context);
    GestureReply running() const;
    GestureReply over() const;
    GestureReply done();

    Stroke m_stroke;
    std::optional<Ground> m_ground;
    Frame m_canvas;
    Camera m_before;     // of the stroke: where Esc returns to
    Camera m_from, m_to; // of the turn
    Vec2 m_cursor;       // px
    bool m_hasTurned = false;
    std::size_t m_drawnSamples = 0;     // that m_document belongs to
    std::optional<Document> m_document; // with the new section
};

} // namespace fff
