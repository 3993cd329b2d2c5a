// A gizmo in the hand: what of it is under the cursor, what its drag comes to, and the numbers that
// say the same. For the tools that move things with one.
#pragma once

#include "core/interaction/gizmo_drag.h"
#include "core/interaction/tool.h"

#include <optional>
#include <vector>

namespace fff {

/// In place of a drag.
struct GizmoNumbers
{
    Vec3 way = Vec3::Zero(); // along the gizmo's axes, mm
    double angle = 0.0;      // about its z, in space its y
    double factor = 1.0;
    int copies = 0;

    /// All about the gizmo's middle.
    Transform transform(const Gizmo &gizmo) const;
    /// Those that are named; the others stay.
    void take(const std::vector<ToolNumber> &numbers);
};

class GizmoHand
{
public:
    /// Not while it is dragged.
    void setGizmo(Gizmo gizmo) { m_gizmo = std::move(gizmo); }
    const Gizmo &gizmo() const { return m_gizmo; }
    bool isEmpty() const { return m_gizmo.parts.empty(); }

    GizmoPart partAt(const PointerEvent &event, const GestureContext &context) const;
    GizmoPart hovered() const { return m_hovered; }
    void setHovered(GizmoPart part) { m_hovered = part; }

    /// A press is a drag once the cursor has gone far enough.
    void press(const PointerEvent &event, const GestureContext &context);
    /// That is no drag yet.
    const std::optional<PointerEvent> &pressed() const { return m_press; }
    bool becomesDrag(const PointerEvent &event, const GestureContext &context) const;
    /// snaps: as GizmoDrag has them.
    void begin(GizmoPart part, const GestureContext &context,
               const std::optional<Alignment> &snaps);
    GizmoDrag *drag() { return m_drag ? &*m_drag : nullptr; }
    const GizmoDrag *drag() const { return m_drag ? &*m_drag : nullptr; }
    void letGo();

    /// None: nothing is typed.
    const std::optional<GizmoNumbers> &typed() const { return m_typed; }
    void type(const std::vector<ToolNumber> &numbers);
    void dropTyped() { m_typed.reset(); }

    /// What the hand does, or what is typed: ways, a turn and a size, but for copies. None where
    /// there is no gizmo.
    std::vector<ToolNumber> numbers() const;
    /// The same as it is seen.
    GizmoMarks marks() const;

private:
    Gizmo m_gizmo;
    GizmoPart m_hovered = GizmoPart::None;
    std::optional<PointerEvent> m_press;
    std::optional<GizmoDrag> m_drag;
    std::optional<GizmoNumbers> m_typed;
};

} // namespace fff
