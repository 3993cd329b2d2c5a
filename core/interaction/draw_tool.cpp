#include "core/interaction/draw_tool.h"

#include "core/base/tolerances.h"
#include "core/base/units.h"
#include "core/interaction/contour_words.h"
#include "core/interaction/facing.h"
#include "core/interaction/pick.h"
#include "core/interaction/section_view.h"
#include "core/interaction/snapping.h"

#include <cmath>
#include <utility>

namespace fff {

std::optional<Camera> cameraAtCanvas(const ContourTarget &target, const GestureContext &context)
{
    const Frame &canvas = target.canvas;
    const Section *section = context.model.document.find(target.section);
    if (section && isSeenFaced(*section, context.camera, context.viewport))
        return {};
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

sign::Region planeMark(const Frame &canvas, const GestureContext &context)
{
    constexpr double kMargin = 12.0; // px
    Box2 box;
    const Box3 bounds = context.model.bounds();
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 at((corner & 1) != 0 ? bounds.max.x() : bounds.min.x(),
                      (corner & 2) != 0 ? bounds.max.y() : bounds.min.y(),
                      (corner & 4) != 0 ? bounds.max.z() : bounds.min.z());
        box.extend(canvas.toLocal(at));
    }
    const double margin = kMargin * context.camera.millimetresPerPixel;
    box.min -= Vec2(margin, margin);
    box.max += Vec2(margin, margin);
    const auto corner = [&](double x, double y) { return canvas.toWorld({x, y}); };
    return {SignRole::Plane,
            {corner(box.min.x(), box.min.y()), corner(box.max.x(), box.min.y()),
             corner(box.max.x(), box.max.y()), corner(box.min.x(), box.max.y())}};
}

DrawTool::DrawTool(CanvasChoice canvas) : m_canvas(std::move(canvas)) {}

DrawTool::DrawTool(AskedCanvas asked) : m_asked(std::move(asked))
{
    m_canvas.command = m_asked->command;
}

DrawTool::~DrawTool() = default;

GestureReply DrawTool::begin(GestureContext &context, double)
{
    GestureReply reply;
    if (isAsking())
        return reply;
    m_before = context.camera;
    reply.turnTo = cameraAtCanvas(m_canvas.target, context);
    return reply;
}

bool DrawTool::takes(const PointerEvent &press, GestureContext &context) const
{
    return !isAsking() ||
           sectionUnder(context.model, context.camera.rayThrough(press.position, context.viewport),
                        context.view)
               .has_value();
}

/// It is selected, and drawn on with the same drag.
GestureReply DrawTool::pickCanvas(const PointerEvent &press, GestureContext &context)
{
    GestureReply reply;
    const std::optional<SectionRef> ref = sectionUnder(
        context.model, context.camera.rayThrough(press.position, context.viewport), context.view);
    if (!ref)
        return reply;
    tl::expected<CanvasChoice, Hint> canvas = m_asked->of(context.model, *ref);
    if (!canvas) {
        reply.note = canvas.error();
        return reply;
    }
    m_canvas = *std::move(canvas);
    m_asked.reset();
    m_isPicking = true;
    reply = draw(press, context);
    reply.note.reset(); // on edge a click turns the view
    reply.select = {{*ref}};
    return reply;
}

GestureReply DrawTool::handle(const PointerEvent &event, GestureContext &context)
{
    if (isAsking())
        return event.isPress() ? pickCanvas(event, context) : GestureReply();
    if (m_isPicking && m_stroke &&
        (event.position - m_press).norm() > context.settings.dragThreshold)
        m_isPicking = false;
    if (m_isPicking && event.type == PointerEvent::Type::Release) {
        m_isPicking = false;
        interrupt(context);
        return begin(context, event.time);
    }
    return draw(event, context);
}

GestureReply DrawTool::draw(const PointerEvent &event, GestureContext &context)
{
    if (event.isPress() &&
        !pointOnPlane(context.camera, context.viewport, m_canvas.target.canvas, event.position)) {
        GestureReply refused;
        refused.note = Hint::refusal(hints::kCanvasOnEdge);
        return refused;
    }
    if (event.isPress()) {
        context.camera =
            retargeted(context.camera, m_canvas.target.canvas.origin, context.viewport);
        m_press = event.position;
        m_stroke = std::make_unique<StrokeGesture>(event, m_canvas.target, context);
        return {};
    }
    if (!m_stroke)
        return {};
    GestureReply reply = m_stroke->handle(event, context);
    if (reply.state == GestureReply::State::Running)
        return reply;
    m_stroke.reset();
    context.overlay.drawn.clear();
    if (!reply.commit && isClickOnGuide(event, context))
        return takeGuide(context);
    if (!reply.commit) // came to nothing: once more
        reply.state = GestureReply::State::Running;
    return reply;
}

/// Those that are there whatever is drawn: a click on one of them takes it.
void DrawTool::lookAtTemplates(const GestureContext &context)
{
    if (m_templates.canvas() == m_canvas.target.canvas &&
        m_cut == context.model.document.templates && m_cutAs == context.pulled)
        return;
    m_cut = context.model.document.templates;
    m_cutAs = context.pulled;
    m_templates = TemplateGuides(context.model, context.pulled.get(), m_canvas.target.canvas);
}

bool DrawTool::isClickOnGuide(const PointerEvent &release, const GestureContext &context) const
{
    if ((release.position - m_press).norm() > context.settings.dragThreshold)
        return false;
    const auto at = pointOnPlane(context.camera, context.viewport, m_canvas.target.canvas, m_press);
    return at && m_templates.isAt(*at, kGuideClick * context.camera.millimetresPerPixel);
}

bool DrawTool::hasGuide() const
{
    if (isAsking())
        return false;
    return m_stroke ? m_stroke->hasGuide() : !m_templates.isEmpty();
}

GestureReply DrawTool::takeGuide(GestureContext &context)
{
    if (m_stroke)
        return m_stroke->takeGuide(context);
    GestureReply reply;
    const auto whole = m_templates.whole(0.0);
    if (!whole) {
        reply.note = Hint::refusal(hints::kFailed);
        return reply;
    }
    auto drawn = drawWhole(context.model.document, m_canvas.target, *whole,
                           {context.settings.cutsAtGround, context.settings.naming, {}});
    if (!drawn) {
        reply.note = drawn.error();
        return reply;
    }
    reply.state = GestureReply::State::Over;
    reply.note = std::move(drawn->note);
    reply.commit = {std::move(drawn->step), std::move(drawn->document)};
    return reply;
}

void DrawTool::advance(double time, GestureContext &context)
{
    if (m_stroke)
        m_stroke->advance(time, context);
}

GestureReply DrawTool::cancel(GestureContext &context)
{
    m_isPicking = false;
    GestureReply reply;
    if (std::exchange(m_stroke, nullptr)) {
        context.overlay.drawn.clear();
        return reply;
    }
    reply.state = GestureReply::State::Over;
    reply.returnTo = m_before;
    return reply;
}

GestureReply DrawTool::interrupt(GestureContext &context)
{
    m_isPicking = false;
    if (std::exchange(m_stroke, nullptr))
        context.overlay.drawn.clear();
    return {};
}

bool DrawTool::isSame(const Tool &other) const
{
    const auto *tool = dynamic_cast<const DrawTool *>(&other);
    return tool && command() == tool->command() &&
           m_canvas.target.section == tool->m_canvas.target.section;
}

GestureReply DrawTool::modelChanged(GestureContext &context)
{
    GestureReply reply = interrupt(context);
    ContourTarget &target = m_canvas.target;
    if (!target.section.isValid())
        return reply;
    const Section *section = context.model.document.find(target.section);
    if (section) {
        target.canvas = section->frame;
        m_canvas.name = section->name;
        return reply;
    }
    reply.state = GestureReply::State::Over;
    reply.note = Hint::refusal(hints::kCanvasGone);
    return reply;
}

void DrawTool::mark(GestureContext &context, bool)
{
    if (isAsking())
        return;
    const Vec3 &origin = m_canvas.target.canvas.origin;
    m_isOnEdge = std::abs(m_canvas.target.canvas.normal().dot(context.camera.towardsEye(
                     origin, context.viewport))) < std::sin(kMinDrawAngle);
    context.overlay.drawn.remove<sign::Rulers>(); // of the stroke: these follow the view
    context.overlay.held.add(
        sign::Rulers{ownGrid(m_canvas.target.canvas, context.camera.orientation)});
    lookAtTemplates(context);
    if (!m_stroke)
        m_templates.show(nullptr, true, context.overlay.held);
    if (m_canvas.distance && !m_stroke)
        context.overlay.held.add(planeMark(m_canvas.target.canvas, context));
}

std::vector<ToolNumber> DrawTool::numbers() const
{
    if (!m_canvas.distance || m_stroke)
        return {};
    return {{ToolNumber::Kind::Distance, *m_canvas.distance}};
}

GestureReply DrawTool::setNumbers(const std::vector<ToolNumber> &numbers, GestureContext &)
{
    for (const ToolNumber &number : numbers) {
        if (number.kind == ToolNumber::Kind::Distance && m_canvas.distance && !m_stroke)
            moveToDistance(m_canvas, number.value);
    }
    return {};
}

Hint DrawTool::hint() const
{
    if (isAsking())
        return m_asked->prompt;
    if (m_stroke)
        return m_stroke->hint();
    if (m_isOnEdge)
        return hints::kCanvasOnEdge;
    return {m_canvas.prompt, {Named{m_canvas.name}}};
}

} // namespace fff
