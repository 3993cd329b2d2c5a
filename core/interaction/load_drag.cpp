#include "core/interaction/load_drag.h"

#include "core/interaction/load_words.h"
#include "core/interaction/slit_guides.h"
#include "core/model/load_edits.h"

#include <cmath>

namespace fff {

namespace {

constexpr double kLeastArrow = 8.0; // px: less is a click, not a direction

/// Where the ray meets the plane through a point that faces the eye.
std::optional<Vec3> facing(const Vec2 &position, const Vec3 &point, const GestureContext &context)
{
    const Ray ray = context.camera.rayThrough(position, context.viewport);
    const Vec3 normal = context.camera.backward();
    const double slope = ray.direction.dot(normal);
    if (!(std::abs(slope) > 0.0))
        return {};
    return ray.origin + (point - ray.origin).dot(normal) / slope * ray.direction;
}

/// Along an axis of the world or of the frame where it is that within 5°.
Vec3 snapped(const Vec3 &direction, const Frame &frame)
{
    const double near = std::cos(SlitGuides::kReach);
    for (const Vec3 &axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ()),
                             frame.normal(), frame.x, frame.y})
        if (const double cosine = direction.dot(axis); std::abs(cosine) >= near)
            return cosine > 0.0 ? axis : Vec3(-axis);
    return direction;
}

} // namespace

std::optional<Hit> sectionUnder(const Vec2 &position, const GestureContext &context)
{
    const Ray ray = context.camera.rayThrough(position, context.viewport);
    const std::vector<Hit> hits = pick(context.model, ray, context.view);
    return hits.empty() ? std::nullopt : std::optional(hits.front());
}

LoadDrag::LoadDrag(const LoadAt &at, const Load &load)
    : m_load(load), m_on(at.section), m_at(at.position), m_push(at.push), m_grip(at.grip),
      m_isTip(at.isTip)
{
}

LoadDrag::LoadDrag(const Load &load)
    : m_load(load), m_on(load.section), m_at(load.position), m_push(load.push),
      m_isTip(load.isPush()), m_hasMoved(true)
{
}

void LoadDrag::follow(const Vec2 &position, bool snaps, const GestureContext &context)
{
    const Vec2 held = position + m_grip;
    m_isTip ? turn(held, snaps, context) : slide(held, context);
}

void LoadDrag::slide(const Vec2 &position, const GestureContext &context)
{
    const std::optional<Hit> hit = sectionUnder(position, context);
    if (!hit)
        return;
    const Model &model = context.model;
    const Section &section = *model.section(static_cast<std::size_t>(hit->section));
    if (section.isLocked)
        return;
    // It pushes to where it did.
    const Section *held = model.find(m_on);
    const Vec3 push = held ? pushInFrame(pushInWorld(m_push, held->frame), section.frame) : m_push;
    Load next = m_load;
    if (const auto source = asOnCopy(model, m_load, section.ref(), hit->local, push)) {
        next = *source;
    } else {
        next.position = hit->local;
        next.push = push;
        next.section = section.ref();
    }
    m_at = hit->local;
    m_push = push;
    m_hasMoved = m_hasMoved || !(next == m_load);
    m_load = next;
    m_on = section.ref();
}

void LoadDrag::turn(const Vec2 &position, bool snaps, const GestureContext &context)
{
    const Section *section = context.model.find(m_on);
    if (!section)
        return;
    const Vec3 foot = section->frame.toWorld(m_at);
    const std::optional<Vec3> tip = facing(position, foot, context);
    if (!tip)
        return;
    const double length = (*tip - foot).norm() / context.camera.scaleAt(foot, context.viewport);
    if (length < kLeastArrow)
        return;
    Vec3 direction = (*tip - foot).normalized();
    if (snaps)
        direction = snapped(direction, section->frame);
    m_push = pushInFrame(forceOfArrow(length) * direction, section->frame);
    if (const auto source = asOnCopy(context.model, m_load, m_on, m_at, m_push))
        m_load = *source;
    m_hasMoved = true;
}

Result<Document> LoadDrag::document(const Document &committed) const
{
    return isNew() ? addLoad(committed, m_load) : setLoad(committed, m_load);
}

Step LoadDrag::step(const Model &model) const
{
    const Named on{model.nameOf(m_load.section)};
    if (isNew())
        return m_load.isPush() ? Step(steps::kAddPush, {on})
                               : Step(steps::kAddWeight, {massOf(m_load.mass), on});
    if (m_load.isPush())
        return m_isTip ? Step(steps::kTurnPush, {on}) : Step(steps::kMovePush, {on});
    return {steps::kMoveWeight, {on}};
}

std::optional<Vec3> LoadDrag::place(const Model &model) const
{
    const Section *section = model.find(m_on);
    return section ? std::optional(section->frame.toWorld(m_at)) : std::nullopt;
}

} // namespace fff
