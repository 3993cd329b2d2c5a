#include "core/interaction/template_tool.h"

#include "core/interaction/transform_words.h"
#include "core/model/template_edits.h"
#include "core/templates/flat_template.h"
#include "core/templates/moved_template.h"

namespace fff {

bool TemplateTool::isSame(const Tool &other) const
{
    const auto *tool = dynamic_cast<const TemplateTool *>(&other);
    return tool && tool->m_of == m_of;
}

bool TemplateTool::follow(const GestureContext &context)
{
    if (m_hand.drag())
        return true;
    const Template *one = context.model.document.find(m_of);
    const bool isHeld = one && !one->isLocked && !one->isHidden;
    m_hand.setGizmo(isHeld ? gizmoOf(context.model, *one, context.camera.orientation) : Gizmo());
    return !m_hand.isEmpty();
}

/// There is nothing to hold; why, as far as it is known.
GestureReply TemplateTool::over(const GestureContext &context) const
{
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    const Template *one = context.model.document.find(m_of);
    if (one && one->isLocked)
        reply.note = Hint::refusal(hints::kTemplateLocked, {Named{one->name}});
    return reply;
}

GestureReply TemplateTool::begin(GestureContext &context, double)
{
    if (!follow(context))
        return over(context);
    m_hint = hintFor(GizmoPart::None, context);
    return {};
}

bool TemplateTool::takes(const PointerEvent &press, GestureContext &context) const
{
    return m_hand.partAt(press, context) != GizmoPart::None;
}

Hint TemplateTool::hintFor(GizmoPart part, const GestureContext &context) const
{
    if (m_hand.typed())
        return hints::kTransformNumbers;
    if (isTurn(part))
        return hints::kTemplateTurn;
    if (isScale(part))
        return hints::kTemplateScale;
    if (part != GizmoPart::None)
        return hints::kTemplateMove;
    const Template *one = context.model.document.find(m_of);
    return {hints::kTemplateHandles, {Named{one ? one->name : std::string()}}};
}

/// Of the bare gizmo also when the view is moved.
void TemplateTool::mark(GestureContext &context, bool hasCursor)
{
    follow(context);
    if (!hasCursor && !m_hand.drag())
        m_hand.setHovered(GizmoPart::None);
    m_hint = m_hand.drag() ? Hint(hints::kTemplateInHand) : hintFor(m_hand.hovered(), context);
    if (!m_hand.isEmpty())
        context.overlay.held.add(m_hand.marks());
}

SectionEdit TemplateTool::editOf(const Transform &transform, const GestureContext &context) const
{
    const Document &document = context.model.document;
    const Template *one = document.find(m_of);
    if (!one)
        return refused(hints::kTemplateNotMoved, {Named{}});
    Transform whole = transform;
    whole.factor *= whole.stretch.x(); // both ways alike
    // Seen on its edge what lies on a section is dragged before the view: it stays on it.
    if (one->on != SectionRef())
        whole.way -= whole.way.dot(m_hand.gizmo().axis(2)) * m_hand.gizmo().axis(2);
    const Result<Template> moved = movedBy(*one, whole.times(1), context.model);
    Result<Document> next = moved ? setTemplate(document, *moved) : tl::unexpected(moved.error());
    if (!next)
        return refused(hints::kTemplateNotMoved, {Named{one->name}});
    const bool isMove = whole.angle == 0.0 && whole.factor == 1.0;
    const bool isTurned = whole.angle != 0.0 && whole.factor == 1.0;
    const Text step = isMove     ? steps::kMoveTemplate
                      : isTurned ? steps::kTurnTemplate
                                 : steps::kSizeTemplate;
    return EditedSections{*std::move(next), {step, {Named{one->name}}}};
}

GestureReply TemplateTool::shown(SectionEdit edit) const
{
    GestureReply reply;
    if (edit)
        reply.preview = std::move(edit->document);
    else
        reply.note = edit.error();
    return reply;
}

GestureReply TemplateTool::committed(SectionEdit edit) const
{
    GestureReply reply;
    if (edit)
        reply.commit = GestureReply::Commit{std::move(edit->step), std::move(edit->document)};
    else
        reply.note = edit.error();
    return reply;
}

GestureReply TemplateTool::drag(const PointerEvent &event, GestureContext &context)
{
    if (m_hand.pressed()) {
        if (!m_hand.becomesDrag(event, context))
            return {};
        std::optional<Alignment> snaps;
        const Template *one = context.model.document.find(m_of);
        if (context.settings.snaps && one)
            snaps.emplace(context.model, context.view, alignedPointsOf(*one, context.model));
        m_hand.begin(m_hand.hovered(), context, snaps);
    }
    m_hand.drag()->moveTo(event.position, event.modifiers.shift, context);
    return shown(editOf(m_hand.drag()->transform(), context));
}

GestureReply TemplateTool::release(const PointerEvent &event, GestureContext &context)
{
    GestureReply reply;
    if (m_hand.pressed()) {
        // Beside the gizmo: whoever clicks there is done with it.
        reply.isClick = m_hand.hovered() == GizmoPart::None;
        if (reply.isClick)
            reply.state = GestureReply::State::Over;
        m_hand.letGo();
        return reply;
    }
    if (!m_hand.drag())
        return reply;
    m_hand.drag()->moveTo(event.position, event.modifiers.shift, context);
    const Transform transform = m_hand.drag()->transform();
    if (!transform.isNothing())
        reply = committed(editOf(transform, context));
    m_hand.letGo();
    return reply;
}

GestureReply TemplateTool::handle(const PointerEvent &event, GestureContext &context)
{
    if (event.isPress()) {
        follow(context);
        m_hand.press(event, context);
        return m_hand.typed() ? dropNumbers(context) : GestureReply();
    }
    if (event.type == PointerEvent::Type::Release)
        return release(event, context);
    if (m_hand.drag() || (m_hand.pressed() && m_hand.hovered() != GizmoPart::None))
        return drag(event, context);
    follow(context);
    m_hand.setHovered(m_hand.partAt(event, context));
    GestureReply reply;
    if (m_hand.typed()) // they stay shown while the mouse is elsewhere
        reply.preview = m_typedShown;
    return reply;
}

GestureReply TemplateTool::interrupt(GestureContext &)
{
    m_hand.letGo();
    return {};
}

GestureReply TemplateTool::cancel(GestureContext &context)
{
    if (m_hand.drag() || m_hand.pressed())
        return interrupt(context);
    if (m_hand.typed())
        return dropNumbers(context);
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    return reply;
}

GestureReply TemplateTool::modelChanged(GestureContext &context)
{
    m_hand.dropTyped();
    m_hand.letGo();
    return follow(context) ? GestureReply() : over(context);
}

GestureReply TemplateTool::setNumbers(const std::vector<ToolNumber> &numbers,
                                      GestureContext &context)
{
    follow(context);
    if (m_hand.isEmpty() || m_hand.drag())
        return {};
    m_hand.type(numbers);
    GestureReply reply = shown(editOf(m_hand.typed()->transform(m_hand.gizmo()), context));
    m_typedShown = reply.preview;
    return reply;
}

GestureReply TemplateTool::dropNumbers(GestureContext &)
{
    m_hand.dropTyped();
    return {};
}

bool TemplateTool::wants(ToolKey key) const
{
    return key == ToolKey::Enter && m_hand.typed();
}

GestureReply TemplateTool::key(ToolKey, GestureContext &context)
{
    const Transform transform = m_hand.typed()->transform(m_hand.gizmo());
    GestureReply reply =
        !transform.isNothing() ? committed(editOf(transform, context)) : GestureReply();
    dropNumbers(context);
    return reply;
}

Cursor TemplateTool::cursor() const
{
    if (m_hand.drag())
        return Cursor::MoveCross;
    if (isTurn(m_hand.hovered()))
        return Cursor::TurningArrows;
    return m_hand.hovered() != GizmoPart::None ? Cursor::MoveCross : Cursor::Arrow;
}

} // namespace fff
