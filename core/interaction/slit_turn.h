// From a press in a section to the canvas of a new one across it, for tools that draw with clicks:
// follows the slit until it leaves the section, then turns the view about the slit's end, which
// stays under the cursor, and moves it to where there is room. Whether the button is still pressed
// does not matter from the turn on.
#pragma once

#include "core/interaction/canvas_turn.h"
#include "core/interaction/contour_target.h"
#include "core/interaction/gesture.h"
#include "core/interaction/slit_guides.h"
#include "core/stroke/stroke.h"

namespace fff {

class SlitTurn
{
public:
    enum class State { Slit, Turn, Room, Over };

    SlitTurn(const PointerEvent &press, const Hit &hit, const GestureContext &context);

    void move(const PointerEvent &event, GestureContext &context);
    void advance(double time, GestureContext &context);
    /// To the view that it ends with, at once.
    void finish(GestureContext &context);

    State state() const { return m_state; }
    /// The slit left the section, but has no length to speak of: there is no canvas.
    bool isTooShort() const { return m_stroke.state() == Stroke::State::Cancelled; }
    bool isTurned() const { return m_turn.has_value(); }
    const std::string &sectionName() const { return m_section->name; }
    /// What is drawn on the canvas; once it has turned.
    const ContourTarget &target() const { return m_target; }
    /// The view before.
    const Camera &before() const { return m_before; }
    /// The slit, and the guide that it goes along until the view has turned.
    void show(const GestureContext &context, Signs &signs) const;

private:
    void beginTurn(GestureContext &context);

    SectionRef m_ref;
    SectionPointer m_section;
    Stroke m_stroke;
    SlitGuides m_guides;
    std::optional<SlitGuide> m_guide; // that it goes along
    State m_state = State::Slit;
    Camera m_before;
    ContourTarget m_target;
    std::optional<CanvasTurn> m_turn;
    RoomPan m_room;
    Vec2 m_cursor;      // px
    double m_now = 0.0; // ms
};

} // namespace fff
