#include "core/interaction/load_gesture.h"

#include "core/interaction/load_words.h"
#include "core/model/edit_words.h"

namespace fff {

LoadGesture::LoadGesture(const LoadAt &at, const GestureContext &context)
    : m_drag(at, *context.model.document.find(at.id))
{
    const Section *section = context.model.find(m_drag.load().section);
    if (section && section->isLocked)
        m_lockedBy = section->name;
}

GestureReply LoadGesture::handle(const PointerEvent &event, GestureContext &context)
{
    GestureReply reply;
    const bool isOver = event.type == PointerEvent::Type::Release;
    reply.state = isOver ? GestureReply::State::Over : GestureReply::State::Running;
    if (!m_lockedBy.empty()) {
        if (isOver)
            reply.note = Hint::refusal(hints::kLocked, {Named{m_lockedBy}});
        return reply;
    }
    if (!isOver)
        m_drag.follow(event.position, context.settings.snaps && !event.modifiers.control, context);
    context.hovered.load = m_drag.load().id;
    Result<Document> next = m_drag.document(context.model.document);
    if (!next || !m_drag.hasMoved())
        return reply;
    if (isOver)
        reply.commit = {m_drag.step(context.model), *std::move(next)};
    else
        reply.preview = *std::move(next);
    return reply;
}

GestureReply LoadGesture::cancel(GestureContext &)
{
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    return reply;
}

Hint LoadGesture::hint() const
{
    return m_drag.load().isPush() ? hints::kMovingPush : hints::kMovingWeight;
}

} // namespace fff
