#include "core/interaction/draw_tool.h"

#include "core/base/units.h"
#include "core/interaction/facing.h"

#include <utility>

namespace fff {

Camera cameraAtCanvas(const ContourTarget &target, const GestureContext &context)
{
    const Frame &canvas = target.canvas;
    const Section *section = context.model.document.find(target.section);
    Vec3 middle = canvas.origin;
    if (section)
        middle = section->frame.toWorld(section->shape->bounds().center());
    else if (const Box3 bounds = context.model.bounds(); !bounds.isEmpty())
        middle = bounds.center() - canvas.height(bounds.center()) * canvas.normal();
    Camera camera =
        turned(context.camera, facingOrientation(context.camera.orientation, canvas.normal()),
               middle, context.viewport);
    return pinned(camera, middle, 0.5 * context.viewport, context.viewport);
}

DrawTool::DrawTool(ContourTarget target, std::string command, std::string name)
    : m_target(std::move(target)), m_command(std::move(command)), m_name(std::move(name))
{
}

DrawTool::~DrawTool() = default;

GestureReply DrawTool::begin(GestureContext &context, double)
{
    m_before = context.camera;
    GestureReply reply;
    reply.turnTo = cameraAtCanvas(m_target, context);
    return reply;
}

GestureReply DrawTool::handle(const PointerEvent &event, GestureContext &context)
{
    const bool presses =
        event.type == PointerEvent::Type::Press || event.type == PointerEvent::Type::DoubleClick;
    if (presses) {
        context.camera = retargeted(context.camera, m_target.canvas.origin, context.viewport);
        m_stroke = std::make_unique<StrokeGesture>(event, m_target, context);
        return {};
    }
    if (!m_stroke)
        return {};
    GestureReply reply = m_stroke->handle(event, context);
    if (reply.state == GestureReply::State::Running)
        return reply;
    m_stroke.reset();
    context.overlay = {};
    if (!reply.commit) // came to nothing: once more
        reply.state = GestureReply::State::Running;
    return reply;
}

void DrawTool::advance(double time, GestureContext &context)
{
    if (m_stroke)
        m_stroke->advance(time, context);
}

GestureReply DrawTool::cancel(GestureContext &context)
{
    GestureReply reply;
    if (std::exchange(m_stroke, nullptr)) {
        context.overlay = {};
        return reply;
    }
    reply.state = GestureReply::State::Over;
    reply.returnTo = m_before;
    return reply;
}

Hint DrawTool::hint() const
{
    if (m_stroke)
        return m_stroke->hint();
    switch (m_target.purpose) {
    case ContourTarget::Purpose::Redraw:
        return {Hint::Kind::DrawNewContour, m_name, false};
    case ContourTarget::Purpose::Hole:
        return {Hint::Kind::DrawHole, m_name, false};
    case ContourTarget::Purpose::NewSection:
        break;
    }
    return {m_command == "section.planeParallel" ? Hint::Kind::DrawParallel
                                                 : Hint::Kind::DrawOnPlane,
            m_name, false};
}

} // namespace fff
