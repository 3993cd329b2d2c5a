#include "core/interaction/weight_tool.h"

#include "core/interaction/pick.h"
#include "core/interaction/weight_words.h"
#include "core/model/edit_words.h"
#include "core/model/edits.h"

namespace fff {

namespace {

constexpr double kWeightReach = 12.0; // px

/// The nearest section under the cursor.
std::optional<Hit> sectionAt(const Vec2 &position, const GestureContext &context)
{
    const Ray ray = context.camera.rayThrough(position, context.viewport);
    const std::vector<Hit> hits = pick(context.model, ray, context.view);
    return hits.empty() ? std::nullopt : std::optional(hits.front());
}

const Section &sectionOf(const Hit &hit, const Model &model)
{
    return *model.section(static_cast<std::size_t>(hit.section));
}

} // namespace

std::optional<Vec3> placeOf(const Model &model, const Weight &weight)
{
    const Section *section = model.find(weight.section);
    return section ? std::optional(section->frame.toWorld(weight.position)) : std::nullopt;
}

WeightId weightAt(const Vec2 &position, const GestureContext &context)
{
    WeightId nearest;
    double reach = kWeightReach;
    for (const Weight &weight : context.model.document.weights) {
        const std::optional<Vec3> place = placeOf(context.model, weight);
        if (!place || context.view.isHidden(weight.section))
            continue;
        const double away = (context.camera.toScreen(*place, context.viewport) - position).norm();
        if (away <= reach) {
            reach = away;
            nearest = weight.id;
        }
    }
    return nearest;
}

GestureReply WeightTool::begin(GestureContext &context, double)
{
    context.view.showsStress = true;
    return {};
}

bool WeightTool::takes(const PointerEvent &press, GestureContext &context) const
{
    return weightAt(press.position, context).isValid() ||
           sectionAt(press.position, context).has_value();
}

GestureReply WeightTool::press(const PointerEvent &event, GestureContext &context)
{
    GestureReply reply;
    m_hasMoved = false;
    if (const WeightId id = weightAt(event.position, context); id.isValid()) {
        const Weight &weight = *context.model.document.find(id);
        const Section *section = context.model.find(weight.section);
        if (section && section->isLocked)
            reply.note = Hint::refusal(hints::kLocked, {Named{section->name}});
        else
            m_dragged = weight;
        return reply;
    }
    const std::optional<Hit> hit = sectionAt(event.position, context);
    if (!hit) {
        reply.note = Hint::refusal(hints::kNoPlaceForWeight);
        return reply;
    }
    const Section &section = sectionOf(*hit, context.model);
    if (section.isLocked) {
        reply.note = Hint::refusal(hints::kLocked, {Named{section.name}});
        return reply;
    }
    m_dragged = Weight{{}, section.ref(), hit->local, m_mass};
    m_hasMoved = true;
    if (auto next = dragged(context.model.document))
        reply.preview = *std::move(next);
    return reply;
}

Result<Document> WeightTool::dragged(const Document &document) const
{
    return m_dragged->id.isValid() ? setWeight(document, *m_dragged)
                                   : addWeight(document, *m_dragged);
}

GestureReply WeightTool::release(GestureContext &context)
{
    GestureReply reply;
    Result<Document> next = dragged(context.model.document);
    const Section *section = context.model.find(m_dragged->section);
    if (m_hasMoved && next && section && !next->isSame(context.model.document)) {
        const Named name{section->name};
        reply.commit = {m_dragged->id.isValid()
                            ? Step(steps::kMoveWeight, {name})
                            : Step(steps::kAddWeight, {massOf(m_dragged->mass), name}),
                        *std::move(next)};
    }
    m_dragged.reset();
    return reply;
}

GestureReply WeightTool::handle(const PointerEvent &event, GestureContext &context)
{
    m_hovered = weightAt(event.position, context);
    const std::optional<Hit> hit = sectionAt(event.position, context);
    m_place = hit ? std::optional(hit->point) : std::nullopt;
    if (event.isPress())
        return press(event, context);
    if (!m_dragged)
        return {};
    if (event.type == PointerEvent::Type::Release)
        return release(context);
    GestureReply reply;
    if (hit && !sectionOf(*hit, context.model).isLocked) {
        const SectionRef ref = sectionOf(*hit, context.model).ref();
        m_hasMoved =
            m_hasMoved || !(m_dragged->section == ref) || m_dragged->position != hit->local;
        m_dragged->section = ref;
        m_dragged->position = hit->local;
    }
    if (auto next = dragged(context.model.document))
        reply.preview = *std::move(next);
    return reply;
}

void WeightTool::mark(GestureContext &context, bool hasCursor)
{
    if (m_dragged) {
        context.hovered.weight = m_dragged->id;
        if (const auto place = placeOf(context.model, *m_dragged))
            context.overlay.held.add(sign::Handle{SignRole::WeightInHand, *place});
        return;
    }
    context.hovered.weight = m_hovered;
    if (hasCursor && m_place && !m_hovered.isValid())
        context.overlay.held.add(sign::Handle{SignRole::Place, *m_place});
}

GestureReply WeightTool::interrupt(GestureContext &)
{
    m_dragged.reset();
    return {};
}

GestureReply WeightTool::cancel(GestureContext &context)
{
    GestureReply reply;
    if (m_dragged)
        m_dragged.reset();
    else
        reply.state = GestureReply::State::Over;
    context.hovered.weight = {};
    return reply;
}

GestureReply WeightTool::modelChanged(GestureContext &)
{
    m_dragged.reset();
    m_place.reset();
    m_hovered = {};
    return {};
}

Hint WeightTool::hint() const
{
    if (m_dragged || m_hovered.isValid())
        return hints::kMoveWeight;
    return {hints::kHangWeight, {massOf(m_mass)}};
}

Cursor WeightTool::cursor() const
{
    return m_dragged || m_hovered.isValid() ? Cursor::MoveCross : Cursor::ArrowWithPlus;
}

} // namespace fff
