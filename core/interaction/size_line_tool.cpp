#include "core/interaction/size_line_tool.h"

#include "core/base/tolerances.h"
#include "core/interaction/facing.h"
#include "core/interaction/pick.h"
#include "core/interaction/snapping.h"
#include "core/interaction/template_words.h"
#include "core/model/template_edits.h"
#include "core/templates/flat_template.h"
#include "core/templates/moved_template.h"
#include "core/templates/template_mesh.h"

#include <cmath>

namespace fff {

namespace {

/// A line shorter than this says nothing about the size of anything, mm.
constexpr double kShortestLine = 1e-3;
/// Beside a picture, or round a mesh, of half its size: things are drawn up to their edges.
constexpr double kBesideTemplate = 1.15;

/// Cosine between the way to the eye and a picture's normal, below which its edge is seen (about
/// 85°).
constexpr double kLeastFacing = 0.09;

Camera facingPlane(const GestureContext &context, const Frame &plane)
{
    const Eigen::Quaterniond front = facingOrientation(context.camera.orientation, plane.normal());
    const Vec2 middle = 0.5 * context.viewport;
    return pinned(turned(context.camera, front, plane.origin, context.viewport), plane.origin,
                  middle, context.viewport);
}

Result<Document> sizedDocument(const Model &model, TemplateId id, const Vec3 &from, const Vec3 &to,
                               double length)
{
    const Template *one = model.document.find(id);
    if (!one)
        return failure(ErrorCode::UnknownReference, std::to_string(id.value));
    Result<Template> sized = sizedByLine(*one, from, to, length, model);
    if (!sized)
        return tl::unexpected(std::move(sized.error()));
    return setTemplate(model.document, *std::move(sized));
}

} // namespace

bool SizeLineTool::isSame(const Tool &other) const
{
    const auto *tool = dynamic_cast<const SizeLineTool *>(&other);
    return tool && tool->m_of == m_of;
}

std::optional<Frame> SizeLineTool::plane(const GestureContext &context) const
{
    const Template *one = context.model.document.find(m_of);
    if (!one || one->isLocked || one->isHidden || !one->isRead())
        return std::nullopt;
    std::optional<Frame> plane = worldFrame(*one, context.model);
    if (plane && !one->isFlat()) {
        const Vec3 eye = context.camera.towardsEye(plane->origin, context.viewport);
        const Vec3 x = context.camera.up().cross(eye).normalized();
        plane = Frame{plane->origin, x, eye.cross(x)};
    }
    return plane;
}

bool SizeLineTool::isEdgeOn(const GestureContext &context) const
{
    const std::optional<Frame> on = plane(context);
    return on &&
           std::abs(context.camera.towardsEye(on->origin, context.viewport).dot(on->normal())) <
               kLeastFacing;
}

std::optional<Vec3> SizeLineTool::placeAt(const Vec2 &position, const GestureContext &context) const
{
    const std::optional<Frame> on = plane(context);
    if (!on)
        return std::nullopt;
    const auto local = pointOnPlane(context.camera, context.viewport, *on, position);
    return local ? std::optional(on->toWorld(*local)) : std::nullopt;
}

bool SizeLineTool::isOver(const Vec3 &place, const GestureContext &context) const
{
    const Template &one = *context.model.document.find(m_of);
    const Frame on = *plane(context);
    const Vec2 local = on.toLocal(place).cwiseAbs();
    if (one.mesh)
        return local.norm() <= 0.5 * kBesideTemplate * worldBounds(one, *one.mesh).size().norm();
    const Vec2 half = 0.5 * kBesideTemplate * flatSize(one);
    return local.x() <= half.x() && local.y() <= half.y();
}

bool SizeLineTool::takes(const PointerEvent &press, GestureContext &context) const
{
    if (!m_from && isEdgeOn(context))
        return true; // no stroke begins where nobody sees the picture
    const std::optional<Vec3> place = placeAt(press.position, context);
    return place && (m_from || isOver(*place, context));
}

GestureReply SizeLineTool::over(const GestureContext &context) const
{
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    const Template *one = context.model.document.find(m_of);
    if (one && one->isLocked)
        reply.note = Hint::refusal(hints::kTemplateLocked, {Named{one->name}});
    return reply;
}

GestureReply SizeLineTool::begin(GestureContext &context, double)
{
    if (!plane(context))
        return over(context);
    const Template &one = *context.model.document.find(m_of);
    m_name = one.name;
    GestureReply reply;
    if (one.isFlat() && isEdgeOn(context))
        reply.turnTo = facingPlane(context, *plane(context));
    return reply;
}

void SizeLineTool::endLine()
{
    if (m_from && m_place && (*m_place - *m_from).norm() >= kShortestLine)
        m_line = Ends{*m_from, *m_place};
    m_from.reset();
}

void SizeLineTool::press(const PointerEvent &event)
{
    m_wanted.reset();
    if (m_from) { // the second of two clicks
        endLine();
        return;
    }
    m_line.reset();
    m_from = m_place;
    m_press = event.position;
    m_isDrag = false;
}

GestureReply SizeLineTool::handle(const PointerEvent &event, GestureContext &context)
{
    m_place = isEdgeOn(context) ? std::nullopt : placeAt(event.position, context);
    m_isOver = m_place && isOver(*m_place, context);
    if (m_place && m_from && event.modifiers.shift) {
        const Frame on = *plane(context);
        const SnapTargets none(on, ownGrid(on, context.camera.orientation));
        const double scale = context.camera.scaleAt(*m_from, context.viewport);
        m_place =
            on.toWorld(held(on.toLocal(*m_place), on.toLocal(*m_from), none, scale, false).point);
    }
    if (event.isPress()) {
        press(event);
        return shown();
    }
    if (m_press && !m_isDrag)
        m_isDrag = (event.position - *m_press).norm() > context.settings.dragThreshold;
    if (event.type == PointerEvent::Type::Release && m_press) {
        m_press.reset();
        if (m_isDrag)
            endLine();
    }
    return shown();
}

GestureReply SizeLineTool::shown() const
{
    GestureReply reply;
    if (m_wanted && m_wanted->sized)
        reply.preview = *m_wanted->sized;
    return reply;
}

void SizeLineTool::mark(GestureContext &context, bool hasCursor)
{
    Signs &signs = context.overlay.held;
    const auto show = [&](const Vec3 &from, const Vec3 &to) {
        signs.add(sign::Line{SignRole::Measured, {from, to}, true});
        signs.add(sign::Label{SignRole::Measured, {from, to}, sign::Way{to - from, true}});
    };
    if (m_from && m_place)
        show(*m_from, *m_place);
    else if (const Template *one = context.model.document.find(m_of); m_line && m_wanted && one) {
        const Similarity sized = Similarity::scaled(
            m_wanted->length / m_line->length(), keptInSizing(*one, m_line->from, context.model));
        show(sized(m_line->from), sized(m_line->to));
    } else if (m_line)
        show(m_line->from, m_line->to);
    if (hasCursor && m_place && (m_from || m_isOver))
        signs.add(sign::Handle{SignRole::Place, *m_place});
}

GestureReply SizeLineTool::interrupt(GestureContext &)
{
    m_from.reset();
    m_press.reset();
    return shown();
}

GestureReply SizeLineTool::cancel(GestureContext &)
{
    GestureReply reply;
    if (m_wanted) {
        m_wanted.reset();
    } else if (m_from || m_line) {
        m_from.reset();
        m_press.reset();
        m_line.reset();
    } else {
        reply.state = GestureReply::State::Over;
    }
    return reply;
}

GestureReply SizeLineTool::modelChanged(GestureContext &context)
{
    m_from.reset();
    m_press.reset();
    m_line.reset();
    m_wanted.reset();
    return plane(context) ? GestureReply() : over(context);
}

std::vector<ToolNumber> SizeLineTool::numbers() const
{
    if (!m_line)
        return {};
    return {{ToolNumber::Kind::Wanted, m_wanted ? m_wanted->length : m_line->length()}};
}

GestureReply SizeLineTool::setNumbers(const std::vector<ToolNumber> &numbers,
                                      GestureContext &context)
{
    for (const ToolNumber &number : numbers)
        if (number.kind == ToolNumber::Kind::Wanted && m_line && number.value >= kShortestLine &&
            number.value <= kMaxCoordinate)
            m_wanted = Wanted{number.value, sizedDocument(context.model, m_of, m_line->from,
                                                          m_line->to, number.value)};
    return shown();
}

GestureReply SizeLineTool::dropNumbers(GestureContext &)
{
    m_wanted.reset();
    return {};
}

/// It is said: there is nothing left to do.
GestureReply SizeLineTool::key(ToolKey, GestureContext &)
{
    GestureReply reply;
    if (!m_wanted->sized) {
        m_wanted.reset();
        reply.note = Hint::refusal(hints::kTemplateNotMoved, {Named{m_name}});
        return reply;
    }
    reply.state = GestureReply::State::Over;
    reply.commit =
        GestureReply::Commit{{steps::kSizeTemplate, {Named{m_name}}}, *std::move(m_wanted->sized)};
    return reply;
}

Hint SizeLineTool::hint() const
{
    if (m_line && !m_from)
        return {hints::kLineLength, {Named{m_name}}};
    return {hints::kLineOver, {Named{m_name}}};
}

} // namespace fff
