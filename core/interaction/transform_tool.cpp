#include "core/interaction/transform_tool.h"

#include "core/interaction/pick.h"
#include "core/interaction/point_sight.h"
#include "core/model/edit_words.h"

#include <algorithm>
#include <cmath>

namespace fff {

/// What is selected, and the gizmo of it.
void TransformTool::follow(const GestureContext &context)
{
    if (m_drag)
        return;
    std::vector<SectionRef> sections = sectionsInFocus(context.model, context.selection);
    if (sections != m_sections) {
        m_typed.reset();
        m_copies.reset();
    }
    take(std::move(sections), context);
}

void TransformTool::take(std::vector<SectionRef> sections, const GestureContext &context)
{
    m_sections = std::move(sections);
    m_refusal = whyNotEdited(context.model, m_sections);
    m_gizmo = m_refusal ? Gizmo()
                        : gizmoOf(context.model, m_sections, context.settings.movesInSpace,
                                  context.camera.orientation);
}

std::optional<SectionRef> TransformTool::sectionAt(const Vec2 &position,
                                                   const GestureContext &context) const
{
    const std::vector<Hit> hits = fff::pick(
        context.model, context.camera.rayThrough(position, context.viewport), context.view);
    if (hits.empty())
        return std::nullopt;
    // What is selected is dragged through what lies before it.
    for (const Hit &hit : hits) {
        const SectionRef ref = context.model.ref(static_cast<std::size_t>(hit.section));
        if (std::find(m_sections.begin(), m_sections.end(), ref) != m_sections.end())
            return ref;
    }
    return context.model.ref(static_cast<std::size_t>(hits.front().section));
}

GizmoPart TransformTool::partAt(const PointerEvent &event, const GestureContext &context) const
{
    if (m_gizmo.parts.empty())
        return GizmoPart::None;
    return GizmoLook(m_gizmo, context.camera, context.viewport)
        .partAt(event.position, reachOf(event.pointer));
}

bool TransformTool::takes(const PointerEvent &press, GestureContext &context) const
{
    return partAt(press, context) != GizmoPart::None || sectionAt(press.position, context);
}

bool TransformTool::takesControl(const PointerEvent &press, GestureContext &context) const
{
    return partAt(press, context) != GizmoPart::None;
}

GestureReply TransformTool::begin(GestureContext &context, double)
{
    follow(context);
    m_hint = hintFor(GizmoPart::None, context);
    return {};
}

Hint TransformTool::hintFor(GizmoPart part, const GestureContext &context) const
{
    if (m_refusal)
        return *m_refusal;
    if (m_typed)
        return m_typed->copies > 0 ? Hint(Message{hints::kTransformCopies, {}, m_typed->copies})
                                   : Hint(hints::kTransformNumbers);
    if (isTurn(part))
        return hints::kDragToTurn;
    if (isScale(part))
        return hints::kDragToScale;
    if (part != GizmoPart::None)
        return hints::kDragToMove;
    const std::optional<SectionRef> over = sectionAt(m_position, context);
    const bool isSelected =
        over && std::find(m_sections.begin(), m_sections.end(), *over) != m_sections.end();
    if (isSelected)
        return hints::kDragToMove;
    if (over)
        return {hints::kTransformDrag, {Named{context.model.nameOf(*over)}}};
    if (m_sections.empty())
        return hints::kTransformPick;
    return hints::kTransform;
}

/// Of the bare gizmo also when the view is moved.
void TransformTool::mark(GestureContext &context, bool hasCursor)
{
    follow(context);
    if (!hasCursor && !m_drag)
        m_hovered = GizmoPart::None;
    if (!m_drag)
        m_hint = hintFor(m_hovered, context);
    if (m_gizmo.parts.empty())
        return;
    GizmoMarks marks{m_gizmo, m_hovered};
    if (m_drag) {
        const Transform &transform = m_drag->transform();
        marks.lit = m_drag->part();
        marks.value = GizmoMarks::Value{m_drag->value()};
        marks.guides = m_drag->guides();
        marks.copies = m_leavesCopy ? 1 : 0;
        marks.gizmo.frame = placed(m_gizmo.frame, transform.times(1));
        marks.gizmo.parts = {m_drag->part()};
    } else if (m_typed) {
        marks.gizmo.frame = placed(m_gizmo.frame, typedTransform().times(1));
        marks.copies = m_typed->copies;
    }
    context.overlay.held.add(std::move(marks));
}

void TransformTool::beginDrag(const PointerEvent &event, GestureContext &context,
                              GestureReply &reply)
{
    GizmoPart part = partAt(*m_press, context);
    if (part == GizmoPart::None) {
        const std::optional<SectionRef> over = sectionAt(m_press->position, context);
        if (!over)
            return;
        if (std::find(m_sections.begin(), m_sections.end(), *over) == m_sections.end()) {
            take({*over}, context);
            reply.select = m_sections;
        }
        part = GizmoPart::MoveFree;
    }
    if (m_refusal || !m_gizmo.has(part)) {
        reply.note = m_refusal;
        m_press.reset();
        return;
    }
    m_typed.reset();
    m_copies.reset();
    std::optional<Alignment> snaps;
    if (context.settings.snaps) {
        const std::set<SectionRef> moved(m_sections.begin(), m_sections.end());
        snaps.emplace(context.model, context.view, moved,
                      movingWith(context.model, m_sections, context.settings.takesChildren));
    }
    m_drag.emplace(m_gizmo, part, m_press->position, context, snaps);
    m_leavesCopy = event.modifiers.control;
    m_press.reset();
}

SectionEdit TransformTool::editOf(const Transform &transform, int copies,
                                  const GestureContext &context)
{
    const Model &model = context.model;
    if (copies == 0)
        return transformed(model, m_sections, transform, m_gizmo.frame,
                           context.settings.takesChildren);
    if (!m_copies || std::ssize(m_copies->drawn) != copies)
        m_copies = copied(model, m_sections, copies);
    return transformedCopies(*m_copies, model, m_sections, transform);
}

GestureReply TransformTool::shown(SectionEdit edit) const
{
    GestureReply reply;
    if (edit)
        reply.preview = std::move(edit->document);
    else
        reply.note = edit.error();
    return reply;
}

GestureReply TransformTool::committed(SectionEdit edit) const
{
    GestureReply reply;
    if (!edit) {
        reply.note = edit.error();
        return reply;
    }
    reply.note = edit->note;
    reply.select = std::move(edit->select);
    reply.commit = GestureReply::Commit{std::move(edit->step), std::move(edit->document)};
    return reply;
}

GestureReply TransformTool::press(const PointerEvent &event, GestureContext &context)
{
    follow(context);
    m_press = event;
    m_hovered = partAt(event, context);
    return m_typed ? dropNumbers(context) : GestureReply();
}

GestureReply TransformTool::drag(const PointerEvent &event, GestureContext &context)
{
    GestureReply reply;
    if (m_press) {
        if ((event.position - m_press->position).norm() <= context.settings.dragThreshold)
            return reply;
        beginDrag(event, context, reply);
    }
    if (!m_drag)
        return reply;
    m_leavesCopy = event.modifiers.control;
    m_drag->moveTo(event.position, event.modifiers.shift, context);
    m_hint = m_leavesCopy ? hints::kLeavingCopy : hints::kTransforming;
    GestureReply next = shown(editOf(m_drag->transform(), m_leavesCopy ? 1 : 0, context));
    next.select = std::move(reply.select);
    return next;
}

GestureReply TransformTool::release(const PointerEvent &event, GestureContext &context)
{
    GestureReply reply;
    if (m_press) {
        // A part of the gizmo that is clicked is none of the section behind it.
        reply.isClick = m_hovered == GizmoPart::None;
        m_press.reset();
        return reply;
    }
    if (!m_drag)
        return reply;
    m_leavesCopy = event.modifiers.control;
    m_drag->moveTo(event.position, event.modifiers.shift, context);
    const Transform transform = m_drag->transform();
    const bool moves = !transform.isNothing();
    reply = moves ? committed(editOf(transform, m_leavesCopy ? 1 : 0, context)) : GestureReply();
    m_drag.reset();
    m_copies.reset();
    m_leavesCopy = false;
    return reply;
}

GestureReply TransformTool::handle(const PointerEvent &event, GestureContext &context)
{
    m_position = event.position;
    m_pointer = event.pointer;
    switch (event.type) {
    case PointerEvent::Type::Press:
    case PointerEvent::Type::DoubleClick:
        return press(event, context);
    case PointerEvent::Type::Release:
        return release(event, context);
    default:
        break;
    }
    if (m_press || m_drag)
        return drag(event, context);
    follow(context);
    m_hovered = partAt(event, context);
    GestureReply reply;
    if (m_typed) // they stay shown while the mouse is elsewhere
        reply.preview = m_typedShown;
    return reply;
}

GestureReply TransformTool::interrupt(GestureContext &)
{
    m_press.reset();
    m_drag.reset();
    m_copies.reset();
    return {};
}

GestureReply TransformTool::cancel(GestureContext &context)
{
    if (m_drag || m_press)
        return interrupt(context);
    if (m_typed)
        return dropNumbers(context);
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    return reply;
}

/// It goes on with what is selected then.
GestureReply TransformTool::modelChanged(GestureContext &context)
{
    m_typed.reset();
    interrupt(context);
    follow(context);
    return {};
}

Transform TransformTool::typedTransform() const
{
    Transform transform;
    transform.pivot = m_gizmo.frame.origin;
    for (int axis : {0, 1, 2})
        transform.way += m_typed->way[axis] * m_gizmo.axis(axis);
    transform.axis = m_gizmo.axis(m_gizmo.isInSpace ? 1 : 2);
    transform.angle = m_typed->angle;
    transform.factor = m_typed->factor;
    return transform;
}

std::vector<ToolNumber> TransformTool::numbers() const
{
    using Kind = ToolNumber::Kind;
    if (m_gizmo.parts.empty())
        return {};
    Typed typed = m_typed.value_or(Typed());
    if (m_drag) { // what the hand does
        const Transform &transform = m_drag->transform();
        for (int axis : {0, 1, 2})
            typed.way[axis] = transform.way.dot(m_gizmo.axis(axis));
        typed.angle = transform.angle;
        typed.factor = isScale(m_drag->part()) ? m_drag->value() : 1.0;
        typed.copies = m_leavesCopy ? 1 : 0;
    }
    const bool isInSpace = m_gizmo.isInSpace;
    return {{isInSpace ? Kind::MoveX : Kind::MoveRight, typed.way.x()},
            {isInSpace ? Kind::MoveY : Kind::MoveUp, typed.way.y()},
            {isInSpace ? Kind::MoveZ : Kind::MoveOut, typed.way.z()},
            {Kind::Turn, typed.angle},
            {Kind::Size, typed.factor},
            {Kind::Copies, double(typed.copies)}};
}

GestureReply TransformTool::setNumbers(const std::vector<ToolNumber> &numbers,
                                       GestureContext &context)
{
    follow(context);
    if (m_gizmo.parts.empty() || m_drag)
        return {};
    Typed typed = m_typed.value_or(Typed());
    for (const ToolNumber &number : numbers) {
        switch (number.kind) {
        case ToolNumber::Kind::MoveX:
        case ToolNumber::Kind::MoveRight:
            typed.way.x() = number.value;
            break;
        case ToolNumber::Kind::MoveY:
        case ToolNumber::Kind::MoveUp:
            typed.way.y() = number.value;
            break;
        case ToolNumber::Kind::MoveZ:
        case ToolNumber::Kind::MoveOut:
            typed.way.z() = number.value;
            break;
        case ToolNumber::Kind::Turn:
            typed.angle = number.value;
            break;
        case ToolNumber::Kind::Size:
            typed.factor = number.value;
            break;
        case ToolNumber::Kind::Copies:
            typed.copies = static_cast<int>(std::clamp(number.value, 0.0, kMostCopies));
            break;
        default:
            break;
        }
    }
    m_typed = typed;
    GestureReply reply = shown(editOf(typedTransform(), typed.copies, context));
    m_typedShown = reply.preview;
    return reply;
}

GestureReply TransformTool::dropNumbers(GestureContext &)
{
    m_typed.reset();
    m_copies.reset();
    return {};
}

std::vector<std::string_view> TransformTool::commands() const
{
    if (m_refusal && m_refusal->words.text == hints::kMadeByOperation)
        return {"operation.editSource", "operation.detach"};
    return {"transform.inSpace", "transform.withChildren"};
}

bool TransformTool::wants(ToolKey key) const
{
    return key == ToolKey::Enter && m_typed;
}

GestureReply TransformTool::key(ToolKey, GestureContext &context)
{
    const Transform transform = typedTransform();
    const int copies = m_typed->copies;
    GestureReply reply =
        !transform.isNothing() ? committed(editOf(transform, copies, context)) : GestureReply();
    dropNumbers(context);
    return reply;
}

Cursor TransformTool::cursor() const
{
    if (m_drag)
        return m_leavesCopy ? Cursor::ArrowWithPlus : Cursor::MoveCross;
    if (isTurn(m_hovered))
        return Cursor::TurningArrows;
    const bool moves = m_hovered != GizmoPart::None || m_hint.words.text == hints::kDragToMove ||
                       m_hint.words.text == hints::kTransformDrag;
    return moves ? Cursor::MoveCross : Cursor::Arrow;
}

} // namespace fff
