#include "core/interaction/magnet_handle.h"

#include "core/interaction/magnet_words.h"
#include "core/interaction/operation_handles.h"
#include "core/model/magnet_edits.h"
#include "core/model/template.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// A normal that points so nearly at the eye (its cosine) leaves the handle no room on the screen.
constexpr double kStraight = 0.97;
constexpr double kMagnetStep = 0.1; // mm

} // namespace

std::optional<MagnetHandle> magnetHandle(const Model &model, const Selection &selection,
                                         const Camera &camera)
{
    if (selection.sections().size() != 1)
        return std::nullopt;
    const SectionRef &ref = selection.sections().front();
    const std::optional<double> radius = magnetOf(model.document, ref);
    const Section *section = model.find(ref);
    if (!radius || !section)
        return std::nullopt;
    MagnetHandle handle{ref, section->frame.toWorld(section->shape->contour().bounds().center()),
                        section->frame.normal(), *radius};
    const double towards = handle.way.dot(camera.backward());
    if (std::abs(towards) > kStraight)
        return std::nullopt;
    if (towards < 0.0)
        handle.way = -handle.way;
    return handle;
}

bool isOnMagnet(const MagnetHandle &handle, const GestureContext &context, const Vec2 &position,
                double reach)
{
    return (context.camera.toScreen(handle.at(), context.viewport) - position).norm() <= reach;
}

void addMagnetSigns(const MagnetHandle &handle, bool isInHand, Signs &signs)
{
    const Vec3 other = handle.middle - handle.radius * handle.way;
    signs.add(sign::Line{SignRole::Guide, {other, handle.at()}, true});
    signs.add(sign::Handle{SignRole::Place, handle.at()});
    if (isInHand)
        signs.add(sign::Label{SignRole::Measured,
                              {handle.middle, handle.at()},
                              sign::Way{handle.radius * handle.way, true}});
}

void removeMagnetSigns(Signs &signs)
{
    signs.remove<sign::Line>();
    signs.remove<sign::Handle>();
}

MagnetGesture::MagnetGesture(const MagnetHandle &handle, const PointerEvent &press,
                             const GestureContext &context)
    : m_handle(handle), m_name(context.model.nameOf(handle.section)), m_before(handle.radius)
{
    m_grip = radiusAt(press.position, context) - m_before;
}

double MagnetGesture::radiusAt(const Vec2 &position, const GestureContext &context) const
{
    const std::vector<std::pair<Vec3, double>> line{
        {m_handle.middle, 0.0}, {m_handle.middle + kMostMagnet * m_handle.way, kMostMagnet}};
    const double held = valueOnTrack(line, context.camera, context.viewport, position) - m_grip;
    return std::clamp(kMagnetStep * std::round(held / kMagnetStep), kLeastMagnet, kMostMagnet);
}

GestureReply MagnetGesture::handle(const PointerEvent &event, GestureContext &context)
{
    GestureReply reply;
    const bool isOver = event.type == PointerEvent::Type::Release;
    reply.state = isOver ? GestureReply::State::Over : GestureReply::State::Running;
    if (!event.isFollowed)
        m_handle.radius = radiusAt(event.position, context);
    context.overlay.drawn.clear();
    if (!isOver)
        addMagnetSigns(m_handle, true, context.overlay.drawn);
    if (m_handle.radius == m_before)
        return reply;
    Result<Document> next = setMagnet(context.model.document, m_handle.section, m_handle.radius);
    if (!next)
        return reply;
    if (isOver)
        reply.commit = GestureReply::Commit{
            ofSections(steps::kPullTemplates, {context.model.nameOf(m_handle.section)}),
            *std::move(next)};
    else
        reply.preview = *std::move(next);
    return reply;
}

GestureReply MagnetGesture::cancel(GestureContext &context)
{
    context.overlay.drawn.clear();
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    return reply;
}

Hint MagnetGesture::hint() const
{
    return Hint{hints::kMovingMagnet, {Named{m_name}, lengthOf(m_handle.radius)}};
}

} // namespace fff
