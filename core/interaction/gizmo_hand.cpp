#include "core/interaction/gizmo_hand.h"

#include "core/interaction/joint_marks.h"
#include "core/operations/copies.h"

#include <algorithm>

namespace fff {

Transform GizmoNumbers::transform(const Gizmo &gizmo) const
{
    Transform transform;
    transform.pivot = gizmo.frame.origin;
    for (int index : {0, 1, 2})
        transform.way += way[index] * gizmo.axis(index);
    transform.axis = gizmo.axis(gizmo.isInSpace ? 1 : 2);
    transform.angle = angle;
    transform.factor = factor;
    return transform;
}

void GizmoNumbers::take(const std::vector<ToolNumber> &numbers)
{
    for (const ToolNumber &number : numbers) {
        switch (number.kind) {
        case ToolNumber::Kind::MoveX:
        case ToolNumber::Kind::MoveRight:
            way.x() = number.value;
            break;
        case ToolNumber::Kind::MoveY:
        case ToolNumber::Kind::MoveUp:
            way.y() = number.value;
            break;
        case ToolNumber::Kind::MoveZ:
        case ToolNumber::Kind::MoveOut:
            way.z() = number.value;
            break;
        case ToolNumber::Kind::Turn:
            angle = number.value;
            break;
        case ToolNumber::Kind::Size:
            factor = number.value;
            break;
        case ToolNumber::Kind::Copies:
            copies = static_cast<int>(std::clamp(number.value, 0.0, kMostCopies));
            break;
        default:
            break;
        }
    }
}

GizmoPart GizmoHand::partAt(const PointerEvent &event, const GestureContext &context) const
{
    if (isEmpty())
        return GizmoPart::None;
    return GizmoLook(m_gizmo, context.camera, context.viewport)
        .partAt(event.position, reachOf(event.pointer));
}

void GizmoHand::press(const PointerEvent &event, const GestureContext &context)
{
    m_press = event;
    m_hovered = partAt(event, context);
}

bool GizmoHand::becomesDrag(const PointerEvent &event, const GestureContext &context) const
{
    return m_press && (event.position - m_press->position).norm() > context.settings.dragThreshold;
}

void GizmoHand::begin(GizmoPart part, const GestureContext &context,
                      const std::optional<Alignment> &snaps)
{
    dropTyped();
    m_drag.emplace(m_gizmo, part, m_press->position, context, snaps);
    m_press.reset();
}

void GizmoHand::letGo()
{
    m_press.reset();
    m_drag.reset();
}

void GizmoHand::type(const std::vector<ToolNumber> &numbers)
{
    GizmoNumbers typed = m_typed.value_or(GizmoNumbers());
    typed.take(numbers);
    m_typed = typed;
}

std::vector<ToolNumber> GizmoHand::numbers() const
{
    using Kind = ToolNumber::Kind;
    if (isEmpty())
        return {};
    GizmoNumbers now = m_typed.value_or(GizmoNumbers());
    if (m_drag) {
        const Transform &transform = m_drag->transform();
        for (int axis : {0, 1, 2})
            now.way[axis] = transform.way.dot(m_gizmo.axis(axis));
        now.angle = transform.angle;
        now.factor = isScale(m_drag->part()) ? m_drag->value() : 1.0;
    }
    const bool isInSpace = m_gizmo.isInSpace;
    std::vector<ToolNumber> numbers{{isInSpace ? Kind::MoveX : Kind::MoveRight, now.way.x()},
                                    {isInSpace ? Kind::MoveY : Kind::MoveUp, now.way.y()}};
    if (m_gizmo.has(GizmoPart::MoveZ))
        numbers.push_back({isInSpace ? Kind::MoveZ : Kind::MoveOut, now.way.z()});
    numbers.push_back({Kind::Turn, now.angle});
    numbers.push_back({Kind::Size, now.factor});
    return numbers;
}

GizmoMarks GizmoHand::marks() const
{
    GizmoMarks marks{m_gizmo, m_hovered};
    if (m_drag) {
        marks.lit = m_drag->part();
        marks.value = GizmoMarks::Value{m_drag->value()};
        marks.guides = m_drag->guides();
        marks.gizmo.frame = placed(m_gizmo.frame, m_drag->transform().times(1));
        marks.gizmo.parts = {m_drag->part()};
    } else if (m_typed) {
        marks.gizmo.frame = placed(m_gizmo.frame, m_typed->transform(m_gizmo).times(1));
    }
    return marks;
}

} // namespace fff
