#include "core/interaction/point_gesture.h"

#include "core/interaction/point_words.h"
#include "core/model/origin.h"

#include <algorithm>

namespace fff {

namespace {

constexpr Text kMovingPoint = FFF_TEXT("Hint", "Release to leave it here. <kbd>Ctrl</kbd> makes a "
                                               "corner, <kbd>Shift</kbd> keeps the direction.");
constexpr Text kMovingHandle =
    FFF_TEXT("Hint", "Release to keep it like this. <kbd>Ctrl</kbd> makes a corner, "
                     "<kbd>Shift</kbd> keeps the direction.");
constexpr Text kBendingContour =
    FFF_TEXT("Hint", "Release to keep it like this. <kbd>Ctrl</kbd> makes corners at its ends. "
                     "<kbd>Esc</kbd> cancels.");
//: %1 is the name of a section
constexpr Text kMoveHandle = FFF_TEXT("Step", "Move handle of %1");
//: %1 is the name of a section
constexpr Text kBendContour = FFF_TEXT("Step", "Bend contour of %1");

} // namespace

PointGesture::PointGesture(const PointTarget &target, const PointerEvent &press,
                           const SectionRef &ref, const GestureContext &context)
    : m_target(target), m_document(documentToEdit(context.model, ref))
{
    const SectionPointer edited = editedSection(context.model, ref);
    const Section &section = *edited;
    m_section = section.id;
    m_name = section.name;
    m_shape = section.shape;
    m_frame = section.frame;
    if (const std::optional<Origin> origin = originOf(context.model, ref); origin->mirror)
        m_mirror = *origin->mirror;
    if (context.points.section() == section.id)
        m_before = context.points.points();
    m_moved = m_before;
    const bool isSelected =
        std::find(m_before.begin(), m_before.end(), target.point) != m_before.end();
    if (target.kind == PointTarget::Kind::Anchor && !isSelected)
        m_moved = {target.point};
    if (target.kind == PointTarget::Kind::Anchor && context.settings.snaps) {
        m_guides = TemplateGuides(context.model, context.pulled.get(), m_frame);
        m_targets.emplace(m_frame, ownGrid(m_frame, context.camera.orientation));
        m_targets->setGuides(m_guides.loops(), context.settings.guideReach, kSnapReach);
        m_targets->addGuideCrossings(context.model, context.view, ref);
    }
    m_pressed = placeOnPlane(m_frame, context.camera, context.viewport, press.position)
                    .value_or(target.place);
}

/// Along what Shift keeps to.
Vec2 PointGesture::straightened(const Vec2 &by) const
{
    if (m_target.kind == PointTarget::Kind::Anchor)
        return std::abs(by.x()) >= std::abs(by.y()) ? Vec2(by.x(), 0.0) : Vec2(0.0, by.y());
    const Contour &contour = boundary(*m_shape, m_target.point.boundary);
    Vec2 direction = m_target.place - anchor(contour, m_target.point.index);
    if (m_target.kind == PointTarget::Kind::Line)
        direction = perpendicular(contour.segment(m_target.point.index).derivative(m_target.t));
    if (!(direction.norm() > kNoHandle))
        return by;
    direction.normalize();
    return direction.dot(by) * direction;
}

/// To where the point that is held lies on a guide.
Vec2 PointGesture::drawnTo(const Vec2 &by, const GestureContext &context)
{
    if (!m_targets)
        return by;
    const Vec2 from = position(*m_shape, m_target.point);
    m_snap =
        caught(from + by, *m_targets, context.camera.millimetresPerPixel, m_snap).value_or(Snap());
    return m_snap.kind == Snap::Kind::None ? by : Vec2(m_snap.point - from);
}

PointEdit PointGesture::edited(const Vec2 &by, bool breaks, const Document &document,
                               const PointRules &rules) const
{
    Step step;
    std::vector<Vec2> places;
    const bool isAnchor = m_target.kind == PointTarget::Kind::Anchor;
    for (const PointAddress &point : m_moved)
        places.push_back(isAnchor ? Vec2(position(*m_shape, point) + by)
                                  : position(*m_shape, point));
    Result<ShapePointer> shape = failure(ErrorCode::BadValue);
    switch (m_target.kind) {
    case PointTarget::Kind::Anchor:
        step = ofParts(steps::kMovePoints, m_name, m_moved.size());
        shape = movedPoints(*m_shape, m_moved, by, breaks);
        break;
    case PointTarget::Kind::Handle:
        step = {kMoveHandle, {Named{m_name}}};
        shape = movedHandle(*m_shape, m_target.point, m_target.side, m_target.place + by, breaks);
        break;
    case PointTarget::Kind::Line:
        step = {kBendContour, {Named{m_name}}};
        shape = movedSegment(*m_shape, m_target.point.boundary, {m_target.point.index, m_target.t},
                             by, breaks);
        break;
    }
    return withEditedShape(document, m_section, shape, places, std::move(step), rules);
}

GestureReply PointGesture::handle(const PointerEvent &event, GestureContext &context)
{
    GestureReply reply;
    const auto place = placeOnPlane(m_frame, context.camera, context.viewport, event.position);
    Vec2 by = place ? Vec2(*place - m_pressed) : Vec2::Zero();
    by = event.modifiers.shift ? straightened(by) : drawnTo(by, context);
    context.overlay.drawn.clear();
    m_guides.show(nullptr, false, context.overlay.drawn);
    // A release where the last move was commits the very document that is shown, slits and all.
    const bool isAsShown =
        m_shown && m_shown->by == by && m_shown->breaks == event.modifiers.control;
    if (place && !event.isFollowed && !isAsShown) {
        m_shown = Shown{by, event.modifiers.control};
        PointEdit edit = edited(by, event.modifiers.control, m_document,
                                {context.settings.cutsAtGround, m_mirror});
        m_refusal = edit ? std::nullopt : std::optional(edit.error());
        if (edit)
            m_last = *std::move(edit);
    }
    reply.selectPoints = m_last ? m_last->points : m_moved;
    if (m_last)
        reply.preview = m_last->document;
    if (event.type != PointerEvent::Type::Release)
        return reply;
    reply.state = GestureReply::State::Over;
    reply.preview.reset();
    reply.note = m_refusal;
    if (m_last) {
        if (!m_refusal)
            reply.note = m_last->note;
        if (m_last->document.find(m_section)->shape != m_shape)
            reply.commit = GestureReply::Commit{m_last->step, std::move(m_last->document)};
    }
    return reply;
}

GestureReply PointGesture::cancel(GestureContext &)
{
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    reply.selectPoints = m_before;
    return reply;
}

Hint PointGesture::hint() const
{
    if (m_refusal)
        return *m_refusal;
    switch (m_target.kind) {
    case PointTarget::Kind::Anchor:
        return kMovingPoint;
    case PointTarget::Kind::Handle:
        return kMovingHandle;
    case PointTarget::Kind::Line:
        return kBendingContour;
    }
    return {}; // not reached: every kind is above
}

} // namespace fff
