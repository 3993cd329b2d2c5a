#include "core/interaction/joint_gesture.h"

#include "core/assembly/joint_words.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// Whole percents.
constexpr double kStep = 0.01;
/// Sine of the angle to the axis below which one looks along it.
constexpr double kAlongAxis = 0.05;

} // namespace

JointGesture::JointGesture(const JointMark &mark, const PointerEvent &press,
                           GestureContext &context)
    : m_joint(mark.joint), m_overlap(mark.overlap), m_state(jointState(context.model, mark.joint))
{
    if (!m_state)
        return;
    m_nameA = context.model.section(static_cast<std::size_t>(m_state->a))->name;
    m_nameB = context.model.section(static_cast<std::size_t>(m_state->b))->name;
    const auto index = static_cast<std::size_t>(m_overlap);
    if (m_state->shares[index])
        m_share = *m_state->shares[index];
    if (const auto at = along(press.position, context))
        m_grip = *at - m_state->crossing.overlaps[index].meet;
    show(context.model, context.overlay);
}

std::optional<double> JointGesture::along(const Vec2 &position, const GestureContext &context) const
{
    const Ray ray = context.camera.rayThrough(position, context.viewport);
    const Axis &axis = m_state->crossing.axis;
    const Vec3 way = ray.direction.normalized();
    const double cosine = axis.direction.dot(way);
    const double sine2 = 1.0 - cosine * cosine;
    if (sine2 < kAlongAxis * kAlongAxis)
        return {};
    // The place of the axis that is nearest to the ray.
    const Vec3 from = ray.origin - axis.point;
    return (from.dot(axis.direction) - cosine * from.dot(way)) / sine2;
}

/// The joint as it is in the model that is shown.
void JointGesture::show(const Model &model, Overlay &overlay) const
{
    const std::optional<JointState> state = jointState(model, m_joint);
    if (!state)
        return;
    sign::Joints shown;
    for (std::size_t i = 0; i < state->crossing.overlaps.size(); ++i)
        shown.marks.push_back(markOf(*state, static_cast<int>(i)));
    shown.hovered = m_overlap;
    shown.lit.push_back(lookOf(model, *state));
    overlay.selected.put(std::move(shown));
}

GestureReply JointGesture::handle(const PointerEvent &event, GestureContext &context)
{
    GestureReply reply;
    const bool isOver = event.type == PointerEvent::Type::Release;
    reply.state = isOver ? GestureReply::State::Over : GestureReply::State::Running;
    const auto index = static_cast<std::size_t>(m_overlap);
    if (!m_state || !m_state->shares[index]) {
        if (isOver)
            reply.note = Hint::refusal(hints::kNoMeetingPoint, {Named{m_nameA}, Named{m_nameB}});
        return reply;
    }
    const Overlap &o = m_state->crossing.overlaps[index];
    if (const auto at = along(event.position, context); at && !event.isFollowed) {
        const double meet = *at - m_grip;
        const double share = (m_state->sign > 0 ? o.to - meet : meet - o.from) / (o.to - o.from);
        m_share = std::clamp(kStep * std::round(share / kStep), kLeastShare, 1.0 - kLeastShare);
    }
    if (m_shown != m_share) {
        if (JointEdit edit = moveMeetingPoint(context.model, m_joint, m_overlap, m_share)) {
            m_shown = m_share;
            m_last = *std::move(edit);
        }
    }
    if (isOver) {
        if (m_last)
            reply.commit =
                GestureReply::Commit{std::move(m_last->step), std::move(m_last->document)};
        return reply;
    }
    Model shown = context.model;
    if (m_last) {
        shown.document = m_last->document;
        reply.preview = m_last->document;
    }
    show(shown, context.overlay);
    return reply;
}

GestureReply JointGesture::cancel(GestureContext &)
{
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    return reply;
}

Hint JointGesture::hint() const
{
    return {hints::kMovingMeetingPoint,
            {Named{m_nameB}, static_cast<int>(std::lround(100.0 * (1.0 - m_share)))}};
}

} // namespace fff
