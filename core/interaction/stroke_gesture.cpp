#include "core/interaction/stroke_gesture.h"

#include "core/base/units.h"
#include "core/interaction/facing.h"
#include "core/model/edits.h"

namespace fff {

namespace {

/// The canvas will lie at the target's depth (see beginTurn), so pixels count there.
Stroke::Options strokeOptions(const GestureContext &context)
{
    const double scale = context.camera.millimetresPerPixel;
    Stroke::Options options;
    options.turnTime = context.settings.turnTime;
    options.deadZoneRadius = context.settings.deadZoneFraction * context.viewport.x() * scale;
    options.tolerance = context.settings.fitTolerance * scale;
    return options;
}

/// Where the ray through a screen point meets the plane, in its frame. The caller sees to it that
/// the plane is not seen on edge.
Vec2 pointOnPlane(const Frame &plane, const Vec2 &screen, const GestureContext &context)
{
    // From the target's depth rather than from the eye: fewer digits are lost.
    const Vec3 start = context.camera.pointAt(screen, context.viewport);
    const Vec3 direction = -context.camera.towardsEye(start, context.viewport);
    const double distance = -plane.height(start) / plane.normal().dot(direction);
    return plane.toLocal(start + distance * direction);
}

} // namespace

StrokeGesture::StrokeGesture(const PointerEvent &press, const GestureContext &context)
    : m_stroke(strokeOptions(context)), m_before(context.camera), m_cursor(press.position)
{
    m_canvas = {Vec3(0.0, kFirstPlaneHeight, 0.0), m_before.right(), m_before.up()};
    m_stroke.beginOnCanvas({press.time, pointOnPlane(m_canvas, press.position, context)});
}

StrokeGesture::StrokeGesture(const PointerEvent &press, const Hit &hit,
                             const GestureContext &context)
    : m_stroke(strokeOptions(context)), m_before(context.camera), m_cursor(press.position)
{
    const auto index = static_cast<std::size_t>(hit.section);
    m_ground = Ground{context.model.ref(index), context.model.section(index)};
    m_stroke.beginInSection(m_ground->section->shape, {press.time, hit.local});
}

const Frame &StrokeGesture::plane() const
{
    return m_stroke.state() == Stroke::State::Slit ? m_ground->section->frame : m_canvas;
}

GestureReply StrokeGesture::handle(const PointerEvent &event, GestureContext &context)
{
    // A turn that ended before this event ended with the cursor where it was then.
    advance(event.time, context);
    m_cursor = event.position;
    const bool wasInSection = m_stroke.state() == Stroke::State::Slit;
    m_stroke.move({event.time, pointOnPlane(plane(), event.position, context)});
    if (wasInSection && m_stroke.state() == Stroke::State::Turn)
        beginTurn(context);
    advance(event.time, context);
    if (event.type == PointerEvent::Type::Release)
        m_stroke.release();
    else if (event.isFollowed && m_stroke.state() == Stroke::State::Contour)
        return running(); // a sample; the last move of the burst shows what they make together
    return reply(context);
}

void StrokeGesture::advance(double time, GestureContext &context)
{
    if (m_stroke.state() != Stroke::State::Turn)
        return;
    m_stroke.advance(time);
    const Camera turned = interpolated(m_from, m_to, m_stroke.turnProgress(time));
    const Vec3 slitEnd = m_ground->section->frame.toWorld(m_stroke.slitTo());
    context.camera = pinned(turned, slitEnd, m_cursor, context.viewport);
    updateOverlay(context);
}

bool StrokeGesture::isAnimating() const
{
    return m_stroke.state() == Stroke::State::Turn;
}

/// The canvas holds the slit and stands at a right angle to the section: its x axis runs along the
/// slit, its y axis along the section's normal, to the side from which the canvas is looked at.
void StrokeGesture::beginTurn(GestureContext &context)
{
    const Frame &ground = m_ground->section->frame;
    const Vec2 along = (m_stroke.slitTo() - m_stroke.slitFrom()).normalized();
    const Vec3 x = ground.directionToWorld(along).normalized();
    const Vec3 y = ground.normal().normalized();
    const Eigen::Quaterniond orientation =
        facingOrientation(context.camera.orientation, x.cross(y));
    const Vec3 backward = orientation * Vec3::UnitZ();
    m_canvas = {ground.toWorld(m_stroke.slitFrom()), x,
                x.cross(y).dot(backward) > 0.0 ? y : Vec3(-y)};

    m_to = context.camera;
    m_to.orientation = orientation;
    m_to.target = ground.toWorld(m_stroke.slitTo());
    m_from = retargeted(context.camera, m_to.target, context.viewport);
    m_hasTurned = true;
}

GestureReply StrokeGesture::reply(GestureContext &context)
{
    switch (m_stroke.state()) {
    case Stroke::State::Contour:
        updateDocument(context);
        break;
    case Stroke::State::Done:
        updateDocument(context);
        return done();
    case Stroke::State::Cancelled:
        return over();
    default:
        break;
    }
    updateOverlay(context);
    return running();
}

GestureReply StrokeGesture::running() const
{
    GestureReply reply;
    reply.preview = m_document;
    return reply;
}

void StrokeGesture::updateOverlay(GestureContext &context) const
{
    Overlay overlay;
    const Stroke::State state = m_stroke.state();
    if (m_ground) {
        const Frame &frame = m_ground->section->frame;
        overlay.slit =
            Overlay::SlitLine{frame.toWorld(m_stroke.slitFrom()), frame.toWorld(m_stroke.slitTo()),
                              state != Stroke::State::Slit};
        if (state == Stroke::State::DeadZone)
            overlay.deadZone =
                Overlay::DeadZone{overlay.slit->from, overlay.slit->to,
                                  m_stroke.deadZoneRadius() / context.camera.millimetresPerPixel};
    }
    if (state == Stroke::State::Contour) {
        const StrokeContour &contour = m_stroke.contour();
        overlay.stroke =
            Overlay::Stroke{m_canvas, m_stroke.samples(), contour.fitted, contour.closing};
    }
    context.overlay = std::move(overlay);
}

/// Each time from the committed document; kept while no sample is added, so that the release
/// commits the very section that was shown.
void StrokeGesture::updateDocument(const GestureContext &context)
{
    if (m_stroke.samples().size() == m_drawnSamples)
        return;
    m_drawnSamples = m_stroke.samples().size();
    m_document.reset();
    const std::optional<Contour> &contour = m_stroke.contour().contour;
    if (!contour)
        return;
    const Result<ShapePointer> shape = Shape::make(*contour);
    if (!shape)
        return;
    NewSection section;
    section.name = freeSectionName(context.model.document, context.settings.naming);
    section.shape = *shape;
    section.frame = m_canvas;
    if (m_ground)
        section.parent = Parent{m_ground->ref, m_stroke.slitFrom(), m_stroke.slitTo()};
    Result<Document> document = addSection(context.model.document, std::move(section));
    if (document)
        m_document = std::move(*document);
}

GestureReply StrokeGesture::done()
{
    if (!m_document) {
        GestureReply failed = over();
        failed.note = Hint{Hint::Kind::Failed, {}, true};
        return failed;
    }
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    const std::string name = m_document->sections.back()->name;
    reply.commit = {{Step::Kind::DrawSection, {name}}, std::move(*m_document)};
    if (m_stroke.contour().wasCrossing)
        reply.note = Hint{Hint::Kind::CrossesItself, name, false};
    return reply;
}

/// Came to nothing: the view goes back to where it was.
GestureReply StrokeGesture::over() const
{
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    if (m_hasTurned)
        reply.returnTo = m_before;
    switch (m_stroke.refusal()) {
    case Stroke::Refusal::NeverLeft:
        reply.note = Hint{Hint::Kind::NeverLeft, m_ground->section->name, true};
        break;
    case Stroke::Refusal::TooShort:
        reply.note = Hint{Hint::Kind::TooShort, {}, true};
        break;
    case Stroke::Refusal::None:
        break;
    }
    return reply;
}

GestureReply StrokeGesture::cancel(GestureContext &)
{
    m_stroke.cancel();
    return over();
}

Hint StrokeGesture::hint() const
{
    switch (m_stroke.state()) {
    case Stroke::State::Slit:
        return {Hint::Kind::LeaveSection, m_ground->section->name, false};
    case Stroke::State::Turn:
        return {Hint::Kind::Turning, {}, false};
    case Stroke::State::DeadZone:
        return {Hint::Kind::LeaveDeadZone, {}, false};
    default:
        return {m_document ? Hint::Kind::ReleaseToMake : Hint::Kind::DrawContour, {}, false};
    }
}

Cursor StrokeGesture::cursor() const
{
    switch (m_stroke.state()) {
    case Stroke::State::Slit:
        return Cursor::PencilWithSlit;
    case Stroke::State::Turn:
        return Cursor::PencilWithClock;
    default:
        return Cursor::Pencil;
    }
}

} // namespace fff
