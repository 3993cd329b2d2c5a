#include "core/interaction/mirror_tool.h"

#include "core/interaction/draw_tool.h"
#include "core/interaction/mirror_words.h"
#include "core/interaction/pick.h"

#include <utility>

namespace fff {

Frame mirrorPlane(const Model &model, const MirrorChoice &choice)
{
    switch (choice.plane) {
    case MirrorChoice::Plane::X:
        return {Vec3::Zero(), -Vec3::UnitZ(), Vec3::UnitY()};
    case MirrorChoice::Plane::Y:
        return {Vec3::Zero(), Vec3::UnitX(), -Vec3::UnitZ()};
    case MirrorChoice::Plane::Z:
        return {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()};
    case MirrorChoice::Plane::Section:
        break;
    }
    return model.find(*choice.across)->frame;
}

bool MirrorTool::isSame(const Tool &other) const
{
    const auto *tool = dynamic_cast<const MirrorTool *>(&other);
    return tool && !tool->m_isChange;
}

/// Once a choice: the cursor moves many times over one.
void MirrorTool::work(const GestureContext &context)
{
    m_made.reset();
    if (isPlaneKnown())
        m_made = m_edit(context.model, m_choice);
}

GestureReply MirrorTool::shown() const
{
    GestureReply reply;
    if (m_made && *m_made)
        reply.preview = (*m_made)->document;
    return reply;
}

GestureReply MirrorTool::begin(GestureContext &context, double)
{
    work(context);
    return shown();
}

GestureReply MirrorTool::handle(const PointerEvent &event, GestureContext &context)
{
    GestureReply reply = shown();
    const bool isClick = m_drag.handle(event, context, reply);
    if (!asks() || m_drag.isTurning() || m_drag.isPressed())
        return reply;
    const std::vector<Hit> hits = fff::pick(
        context.model, context.camera.rayThrough(event.position, context.viewport), context.view);
    std::optional<SectionRef> over;
    if (!hits.empty())
        over = context.model.ref(static_cast<std::size_t>(hits.front().section));
    if (over != m_choice.across) {
        m_choice.across = over;
        work(context);
    }
    return isClick && over ? done(context) : shown();
}

GestureReply MirrorTool::done(const GestureContext &context)
{
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    if (!*m_made) {
        reply.note = m_made->error();
        return reply;
    }
    EditedSections &made = **m_made;
    reply.note = std::move(made.note);
    reply.select = std::move(made.select);
    if (made.document.isSame(context.model.document))
        return reply;
    if (m_choice.outcome == MirrorChoice::Outcome::Always)
        reply.selectOperation = OperationId{context.model.document.nextId};
    reply.commit = GestureReply::Commit{std::move(made.step), std::move(made.document)};
    return reply;
}

void MirrorTool::mark(GestureContext &context, bool)
{
    if (!isPlaneKnown())
        return;
    sign::Region plane = planeMark(mirrorPlane(context.model, m_choice), context);
    plane.role = SignRole::Mirror;
    context.overlay.held.add(std::move(plane));
}

GestureReply MirrorTool::cancel(GestureContext &context)
{
    if (m_drag.isTurning())
        return m_drag.interrupt(context);
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    return reply;
}

bool MirrorTool::wants(ToolKey key) const
{
    return key == ToolKey::Enter && isPlaneKnown();
}

GestureReply MirrorTool::key(ToolKey key, GestureContext &context)
{
    return key == ToolKey::Enter && m_made ? done(context) : shown();
}

std::vector<std::string_view> MirrorTool::commands() const
{
    std::vector<std::string_view> all;
    for (const CommandGroup &group : commandGroups())
        all.insert(all.end(), group.commands.begin(), group.commands.end());
    return all;
}

/// Across a section a click on it does what is shown.
std::vector<CommandGroup> MirrorTool::commandGroups() const
{
    CommandGroup end;
    if (!asks())
        end.commands.emplace_back("mirror.apply");
    end.commands.emplace_back("mirror.cancel");
    return {{hints::kMirrorPlane, {"mirror.x", "mirror.y", "mirror.z", "mirror.section"}},
            {hints::kMirrorOutcome, {"mirror.copy", "mirror.always", "mirror.once"}},
            std::move(end)};
}

Hint MirrorTool::hint() const
{
    if (asks())
        return hints::kMirrorAcross;
    switch (m_choice.outcome) {
    case MirrorChoice::Outcome::Copy:
        return hints::kMirrorCopy;
    case MirrorChoice::Outcome::Once:
        return hints::kMirrorOnce;
    case MirrorChoice::Outcome::Always:
        break;
    }
    return hints::kMirrorAlways;
}

} // namespace fff
