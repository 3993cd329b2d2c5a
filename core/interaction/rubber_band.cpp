#include "core/interaction/rubber_band.h"

#include "core/interaction/point_editing.h"

#include <algorithm>

namespace fff {

namespace {

/// Whether all of the section's region is seen within the band.
bool isSeenWithin(const Section &section, const Box2 &band, const GestureContext &context)
{
    const Polygon &outer = section.shape->region().outer;
    return std::all_of(outer.begin(), outer.end(), [&](const Vec2 &p) {
        return band.contains(context.camera.toScreen(section.frame.toWorld(p), context.viewport));
    });
}

} // namespace

GestureReply BandGesture::handle(const PointerEvent &event, GestureContext &context)
{
    Box2 band;
    band.extend(m_press);
    band.extend(event.position);
    context.overlay.drawn.put(sign::Band{band});
    GestureReply reply;
    select(band, context, reply);
    if (event.type == PointerEvent::Type::Release)
        reply.state = GestureReply::State::Over;
    return reply;
}

GestureReply BandGesture::cancel(GestureContext &)
{
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    restore(reply);
    return reply;
}

RubberBandGesture::RubberBandGesture(const PointerEvent &press, const GestureContext &context)
    : BandGesture(press), m_before(context.selection.sections())
{
}

void RubberBandGesture::select(const Box2 &band, const GestureContext &context, GestureReply &reply)
{
    std::vector<SectionRef> &inside = reply.select.emplace();
    for (std::size_t i = 0; i < context.model.sectionCount(); ++i) {
        const SectionRef ref = context.model.ref(i);
        if (context.view.isPicked(ref) && isSeenWithin(*context.model.section(i), band, context))
            inside.push_back(ref);
    }
}

PointBandGesture::PointBandGesture(const PointerEvent &press, const Section &section,
                                   const GestureContext &context)
    : BandGesture(press), m_shape(section.shape), m_frame(section.frame)
{
    if (context.points.section() == section.id)
        m_before = context.points.points();
}

void PointBandGesture::select(const Box2 &band, const GestureContext &context, GestureReply &reply)
{
    std::vector<PointAddress> &inside = reply.selectPoints.emplace();
    for (int b = 0; b < boundaryCount(*m_shape); ++b) {
        const Contour &contour = boundary(*m_shape, b);
        for (int i = 0; i < contour.segmentCount(); ++i) {
            if (band.contains(
                    context.camera.toScreen(m_frame.toWorld(anchor(contour, i)), context.viewport)))
                inside.push_back({b, i});
        }
    }
}

} // namespace fff
