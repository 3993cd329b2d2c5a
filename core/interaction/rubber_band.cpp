#include "core/interaction/rubber_band.h"

#include <algorithm>

namespace fff {

bool isSeenWithin(const Section &section, const Box2 &box, const Camera &camera,
                  const Vec2 &viewport)
{
    const Polygon &outer = section.shape->region().outer;
    return std::all_of(outer.begin(), outer.end(), [&](const Vec2 &p) {
        const Vec2 screen = camera.toScreen(section.frame.toWorld(p), viewport);
        return (screen.array() >= box.min.array()).all() &&
               (screen.array() <= box.max.array()).all();
    });
}

GestureReply RubberBandGesture::handle(const PointerEvent &event, GestureContext &context)
{
    if (!m_before)
        m_before = context.selection.sections();
    Box2 band;
    band.extend(m_press);
    band.extend(event.position);
    context.overlay.band = band;
    GestureReply reply;
    std::vector<SectionRef> inside;
    for (std::size_t i = 0; i < context.model.sectionCount(); ++i) {
        const SectionRef ref = context.model.ref(i);
        if (context.view.isPicked(ref) &&
            isSeenWithin(*context.model.section(i), band, context.camera, context.viewport))
            inside.push_back(ref);
    }
    reply.select = std::move(inside);
    if (event.type == PointerEvent::Type::Release)
        reply.state = GestureReply::State::Over;
    return reply;
}

GestureReply RubberBandGesture::cancel(GestureContext &)
{
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    reply.select = m_before;
    return reply;
}

} // namespace fff
