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
    if (m_hand.drag())
        return;
    std::vector<SectionRef> sections = sectionsInFocus(context.model, context.selection);
    if (sections != m_sections) {
        m_hand.dropTyped();
        m_copies.reset();
    }
    take(std::move(sections), context);
}

void TransformTool::take(std::vector<SectionRef> sections, const GestureContext &context)
{
    m_sections = std::move(sections);
    m_refusal = whyNotEdited(context.model, m_sections);
    m_hand.setGizmo(m_refusal ? Gizmo()
                              : gizmoOf(context.model, m_sections, context.settings.movesInSpace,
                                        context.camera.orientation));
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

bool TransformTool::takes(const PointerEvent &press, GestureContext &context) const
{
    return m_hand.partAt(press, context) != GizmoPart::None || sectionAt(press.position, context);
}

bool TransformTool::takesControl(const PointerEvent &press, GestureContext &context) const
{
    return m_hand.partAt(press, context) != GizmoPart::None;
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
    if (const auto &typed = m_hand.typed())
        return typed->copies > 0 ? Hint(Message{hints::kTransformCopies, {}, typed->copies})
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
    if (!hasCursor && !m_hand.drag())
        m_hand.setHovered(GizmoPart::None);
    if (!m_hand.drag())
        m_hint = hintFor(m_hand.hovered(), context);
    if (m_hand.isEmpty())
        return;
    GizmoMarks marks = m_hand.marks();
    if (m_hand.drag())
        marks.copies = m_leavesCopy ? 1 : 0;
    else if (m_hand.typed())
        marks.copies = m_hand.typed()->copies;
    context.overlay.held.add(std::move(marks));
}

void TransformTool::beginDrag(const PointerEvent &event, GestureContext &context,
                              GestureReply &reply)
{
    GizmoPart part = m_hand.partAt(*m_hand.pressed(), context);
    if (part == GizmoPart::None) {
        const std::optional<SectionRef> over = sectionAt(m_hand.pressed()->position, context);
        if (!over)
            return;
        if (std::find(m_sections.begin(), m_sections.end(), *over) == m_sections.end()) {
            take({*over}, context);
            reply.select = m_sections;
        }
        part = GizmoPart::MoveFree;
    }
    if (m_refusal || !m_hand.gizmo().has(part)) {
        reply.note = m_refusal;
        m_hand.letGo();
        return;
    }
    m_copies.reset();
    std::optional<Alignment> snaps;
    if (context.settings.snaps) {
        const std::set<SectionRef> moved(m_sections.begin(), m_sections.end());
        snaps.emplace(context.model, context.view, moved,
                      movingWith(context.model, m_sections, context.settings.takesChildren));
    }
    m_hand.begin(part, context, snaps);
    m_leavesCopy = event.modifiers.control;
}

SectionEdit TransformTool::editOf(const Transform &transform, int copies,
                                  const GestureContext &context)
{
    const Model &model = context.model;
    if (copies == 0)
        return transformed(model, m_sections, transform, m_hand.gizmo().frame,
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
    m_hand.press(event, context);
    return m_hand.typed() ? dropNumbers(context) : GestureReply();
}

GestureReply TransformTool::drag(const PointerEvent &event, GestureContext &context)
{
    GestureReply reply;
    if (m_hand.pressed()) {
        if (!m_hand.becomesDrag(event, context))
            return reply;
        beginDrag(event, context, reply);
    }
    if (!m_hand.drag())
        return reply;
    m_leavesCopy = event.modifiers.control;
    m_hand.drag()->moveTo(event.position, event.modifiers.shift, context);
    m_hint = m_leavesCopy ? hints::kLeavingCopy : hints::kTransforming;
    GestureReply next = shown(editOf(m_hand.drag()->transform(), m_leavesCopy ? 1 : 0, context));
    next.select = std::move(reply.select);
    return next;
}

GestureReply TransformTool::release(const PointerEvent &event, GestureContext &context)
{
    GestureReply reply;
    if (m_hand.pressed()) {
        // A part of the gizmo that is clicked is none of the section behind it.
        reply.isClick = m_hand.hovered() == GizmoPart::None;
        m_hand.letGo();
        return reply;
    }
    if (!m_hand.drag())
        return reply;
    m_leavesCopy = event.modifiers.control;
    m_hand.drag()->moveTo(event.position, event.modifiers.shift, context);
    const Transform transform = m_hand.drag()->transform();
    const bool moves = !transform.isNothing();
    reply = moves ? committed(editOf(transform, m_leavesCopy ? 1 : 0, context)) : GestureReply();
    m_hand.letGo();
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
    if (m_hand.pressed() || m_hand.drag())
        return drag(event, context);
    follow(context);
    m_hand.setHovered(m_hand.partAt(event, context));
    GestureReply reply;
    if (m_hand.typed()) // they stay shown while the mouse is elsewhere
        reply.preview = m_typedShown;
    return reply;
}

GestureReply TransformTool::interrupt(GestureContext &)
{
    m_hand.letGo();
    m_copies.reset();
    return {};
}

GestureReply TransformTool::cancel(GestureContext &context)
{
    if (m_hand.drag() || m_hand.pressed())
        return interrupt(context);
    if (m_hand.typed())
        return dropNumbers(context);
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    return reply;
}

/// It goes on with what is selected then.
GestureReply TransformTool::modelChanged(GestureContext &context)
{
    m_hand.dropTyped();
    interrupt(context);
    follow(context);
    return {};
}

std::vector<ToolNumber> TransformTool::numbers() const
{
    std::vector<ToolNumber> numbers = m_hand.numbers();
    if (numbers.empty())
        return numbers;
    const int typed = m_hand.typed() ? m_hand.typed()->copies : 0;
    const int copies = m_hand.drag() ? (m_leavesCopy ? 1 : 0) : typed;
    numbers.push_back({ToolNumber::Kind::Copies, double(copies)});
    return numbers;
}

GestureReply TransformTool::setNumbers(const std::vector<ToolNumber> &numbers,
                                       GestureContext &context)
{
    follow(context);
    if (m_hand.isEmpty() || m_hand.drag())
        return {};
    m_hand.type(numbers);
    const GizmoNumbers &typed = *m_hand.typed();
    GestureReply reply = shown(editOf(typed.transform(m_hand.gizmo()), typed.copies, context));
    m_typedShown = reply.preview;
    return reply;
}

GestureReply TransformTool::dropNumbers(GestureContext &)
{
    m_hand.dropTyped();
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
    return key == ToolKey::Enter && m_hand.typed();
}

GestureReply TransformTool::key(ToolKey, GestureContext &context)
{
    const Transform transform = m_hand.typed()->transform(m_hand.gizmo());
    const int copies = m_hand.typed()->copies;
    GestureReply reply =
        !transform.isNothing() ? committed(editOf(transform, copies, context)) : GestureReply();
    dropNumbers(context);
    return reply;
}

Cursor TransformTool::cursor() const
{
    if (m_hand.drag())
        return m_leavesCopy ? Cursor::ArrowWithPlus : Cursor::MoveCross;
    if (isTurn(m_hand.hovered()))
        return Cursor::TurningArrows;
    const bool moves = m_hand.hovered() != GizmoPart::None ||
                       m_hint.words.text == hints::kDragToMove ||
                       m_hint.words.text == hints::kTransformDrag;
    return moves ? Cursor::MoveCross : Cursor::Arrow;
}

} // namespace fff
