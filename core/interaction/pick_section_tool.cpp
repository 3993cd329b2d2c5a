#include "core/interaction/pick_section_tool.h"

#include "core/interaction/pick.h"

namespace fff {

GestureReply PickSectionTool::handle(const PointerEvent &event, GestureContext &context)
{
    GestureReply reply;
    const bool isClick = m_drag.handle(event, context, reply);
    if (m_drag.isTurning() || m_drag.isPressed())
        return reply;
    const std::vector<Hit> hits = fff::pick(
        context.model, context.camera.rayThrough(event.position, context.viewport), context.view);
    if (hits.empty()) {
        m_over.reset();
        m_shown.reset();
        return reply;
    }
    const SectionRef over = context.model.ref(static_cast<std::size_t>(hits.front().section));
    if (!isClick) { // over one section all the way it is one document
        if (m_over != over) {
            SectionEdit edit = m_edit(context.model, over);
            m_shown = edit ? std::optional(std::move(edit->document)) : std::nullopt;
            m_over = over;
        }
        reply.preview = m_shown;
        return reply;
    }
    SectionEdit edit = m_edit(context.model, over);
    reply.state = GestureReply::State::Over;
    if (!edit) {
        reply.note = edit.error();
        return reply;
    }
    reply.note = edit->note;
    reply.select = std::move(edit->select);
    if (!edit->document.isSame(context.model.document))
        reply.commit = GestureReply::Commit{std::move(edit->step), std::move(edit->document)};
    return reply;
}

GestureReply PickSectionTool::cancel(GestureContext &context)
{
    if (m_drag.isTurning())
        return m_drag.interrupt(context);
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    return reply;
}

} // namespace fff
