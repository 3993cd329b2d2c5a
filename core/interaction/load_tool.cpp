#include "core/interaction/load_tool.h"

#include "core/interaction/load_words.h"
#include "core/model/edit_words.h"

namespace fff {

namespace {

const Section &sectionOf(const Hit &hit, const Model &model)
{
    return *model.section(static_cast<std::size_t>(hit.section));
}

/// What is put on one and acts on many has to be said.
std::optional<Hint> carriedNote(const Model &model, const Load &load)
{
    const int copies = copiesCarrying(model, load);
    if (copies == 0)
        return {};
    return ofParts(hints::kCarriedByCopies, model.nameOf(load.section),
                   static_cast<std::size_t>(copies));
}

/// Into the section, away from the eye.
Vec3 into(const Section &section, const Camera &camera, double force)
{
    const bool isSeenInFront = section.frame.normal().dot(camera.backward()) > 0.0;
    return {0.0, 0.0, isSeenInFront ? -force : force};
}

} // namespace

std::string_view LoadTool::command() const
{
    switch (m_use) {
    case Use::Push:
        return kAddPush;
    case Use::Pull:
        return kPull;
    case Use::Weight:
        break;
    }
    return kAddWeight;
}

GestureReply LoadTool::begin(GestureContext &context, double)
{
    m_hasShownStress = !context.view.showsStress;
    context.view.showsStress = true;
    return {};
}

void LoadTool::end(GestureContext &context)
{
    if (m_hasShownStress)
        context.view.showsStress = false;
}

std::optional<LoadAt> LoadTool::movable(const Vec2 &position, const GestureContext &context) const
{
    return m_use == Use::Pull ? std::nullopt : loadAt(position, context);
}

bool LoadTool::takes(const PointerEvent &press, GestureContext &context) const
{
    return movable(press.position, context) || sectionUnder(press.position, context);
}

GestureReply LoadTool::press(const PointerEvent &event, GestureContext &context)
{
    GestureReply reply;
    const auto refuseLocked = [&reply](const Section &section) {
        reply.note = Hint::refusal(hints::kLocked, {Named{section.name}});
        return reply;
    };
    if (const auto at = movable(event.position, context)) {
        const Load &load = *context.model.document.find(at->id);
        const Section *section = context.model.find(load.section);
        if (section && section->isLocked)
            return refuseLocked(*section);
        m_drag.emplace(*at, load);
        return reply;
    }
    const std::optional<Hit> hit = sectionUnder(event.position, context);
    if (!hit) {
        reply.note =
            Hint::refusal(m_use == Use::Weight ? hints::kNoPlaceForWeight : hints::kNoPlaceForPush);
        return reply;
    }
    const Section &section = sectionOf(*hit, context.model);
    if (section.isLocked && m_use != Use::Pull)
        return refuseLocked(section);
    Load load = m_next;
    load.section = section.ref();
    load.position = hit->local;
    if (load.isPush())
        load.push = into(section, context.camera, load.push.norm());
    m_drag.emplace(load);
    if (auto next = m_drag->document(context.model.document))
        reply.preview = *std::move(next);
    return reply;
}

/// What was put on or taken hold of is selected: its number is wanted next.
GestureReply LoadTool::release(GestureContext &context)
{
    GestureReply reply;
    const bool isPull = m_use == Use::Pull;
    if (!isPull && !m_drag->isNew())
        reply.selectLoad = m_drag->load().id;
    if (!isPull && m_drag->hasMoved()) {
        Result<Document> next = m_drag->document(context.model.document);
        if (next && !next->isSame(context.model.document)) {
            if (m_drag->isNew()) {
                reply.selectLoad = next->loads.back().id;
                reply.note = carriedNote(context.model, m_drag->load());
            }
            reply.commit = {m_drag->step(context.model), *std::move(next)};
        }
    }
    m_drag.reset();
    return reply;
}

GestureReply LoadTool::handle(const PointerEvent &event, GestureContext &context)
{
    m_hovered = movable(event.position, context);
    const std::optional<Hit> hit = sectionUnder(event.position, context);
    m_place = hit ? std::optional(hit->point) : std::nullopt;
    if (event.isPress())
        return press(event, context);
    if (!m_drag)
        return {};
    if (event.type == PointerEvent::Type::Release)
        return release(context);
    m_drag->follow(event.position, context.settings.snaps && !event.modifiers.control, context);
    GestureReply reply;
    if (auto next = m_drag->document(context.model.document))
        reply.preview = *std::move(next);
    return reply;
}

void LoadTool::mark(GestureContext &context, bool hasCursor)
{
    m_hasShownStress = m_hasShownStress && context.view.showsStress;
    if (m_drag) {
        context.hovered.load = m_drag->load().id;
        if (const auto place = m_drag->place(context.model))
            context.overlay.held.add(sign::Handle{SignRole::LoadInHand, *place});
        return;
    }
    context.hovered.load = m_hovered ? m_hovered->id : LoadId();
    if (hasCursor && m_place && !m_hovered)
        context.overlay.held.add(sign::Handle{SignRole::Place, *m_place});
}

GestureReply LoadTool::interrupt(GestureContext &)
{
    m_drag.reset();
    return {};
}

GestureReply LoadTool::cancel(GestureContext &context)
{
    GestureReply reply;
    if (m_drag)
        m_drag.reset();
    else
        reply.state = GestureReply::State::Over;
    context.hovered.load = {};
    return reply;
}

GestureReply LoadTool::modelChanged(GestureContext &)
{
    m_drag.reset();
    m_place.reset();
    m_hovered.reset();
    return {};
}

Hint LoadTool::hint() const
{
    if (m_use == Use::Pull)
        return m_drag ? hints::kPulling : hints::kPull;
    if (m_drag ? m_drag->load().isPush() : m_hovered && m_hovered->isTip)
        return hints::kTurnPush;
    if (m_drag || m_hovered)
        return hints::kMoveLoad;
    return m_use == Use::Push ? Hint(hints::kPutPush)
                              : Hint(hints::kHangWeight, {massOf(m_next.mass)});
}

Cursor LoadTool::cursor() const
{
    return m_drag || m_hovered ? Cursor::MoveCross : Cursor::ArrowWithPlus;
}

} // namespace fff
