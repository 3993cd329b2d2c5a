#include "core/interaction/steps_tool.h"

#include "core/interaction/view_gestures.h"

namespace fff {

GestureReply StepsTool::handle(const PointerEvent &event, GestureContext &context)
{
    GestureReply reply;
    m_drag.handle(event, context, reply);
    return reply;
}

GestureReply StepsTool::cancel(GestureContext &context)
{
    if (m_drag.isTurning())
        return interrupt(context);
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    return reply;
}

GestureReply StepsTool::modelChanged(GestureContext &context)
{
    interrupt(context);
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    reply.note = Hint(hints::kStepsClosed);
    return reply;
}

Hint StepsTool::hint() const
{
    return m_drag.isTurning() ? Hint::ofView(hints::kOrbiting) : Hint(hints::kShowSteps);
}

} // namespace fff
