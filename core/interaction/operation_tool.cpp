#include "core/interaction/operation_tool.h"

#include "core/interaction/pick.h"
#include "core/model/operation_edits.h"

#include <algorithm>

namespace fff {

OperationTool::OperationTool(const OperationKind &kind, Operation draft)
    : m_kind(kind), m_draft(std::move(draft)), m_command("operation.")
{
    m_command.append(kind.key);
}

int OperationTool::countOf(const InputSpec &input) const
{
    const auto found = m_draft.inputs.find(input.role);
    return found == m_draft.inputs.end() ? 0 : static_cast<int>(found->second.size());
}

const InputSpec *OperationTool::asked() const
{
    const InputSpec *list = nullptr;
    for (const InputSpec &input : m_kind.inputs) {
        if (input.least == 0 || countOf(input) >= input.most)
            continue;
        if (input.most == 1)
            return &input;
        list = list ? list : &input;
    }
    return list;
}

bool OperationTool::isComplete() const
{
    return std::all_of(m_kind.inputs.begin(), m_kind.inputs.end(),
                       [this](const InputSpec &input) { return countOf(input) >= input.least; });
}

std::optional<Hit> OperationTool::hitAt(const Vec2 &position, const GestureContext &context) const
{
    const std::vector<Hit> hits = fff::pick(
        context.model, context.camera.rayThrough(position, context.viewport), context.view);
    return hits.empty() ? std::nullopt : std::optional(hits.front());
}

std::optional<Operation> OperationTool::withPick(const Operation &draft, const SectionRef &section,
                                                 const Model &model) const
{
    const InputSpec *input = asked();
    if (!input)
        return std::nullopt;
    for (const auto &[role, inputs] : draft.inputs)
        for (const OperationInput &known : inputs)
            if (known.section == section)
                return std::nullopt;
    Operation next = draft;
    next.inputs[input->role].push_back({section, model.nameOf(section)});
    return next;
}

std::optional<Document> OperationTool::previewAt(const Vec2 &position,
                                                 const GestureContext &context) const
{
    Operation draft = m_draft;
    if (const std::optional<Hit> hit = hitAt(position, context)) {
        const SectionRef section = context.model.ref(static_cast<std::size_t>(hit->section));
        if (std::optional<Operation> next = withPick(m_draft, section, context.model))
            draft = *std::move(next);
    }
    const auto has = [&draft](const InputSpec &input) {
        const auto found = draft.inputs.find(input.role);
        return input.least == 0 || (found != draft.inputs.end() &&
                                    static_cast<int>(found->second.size()) >= input.least);
    };
    if (!std::all_of(m_kind.inputs.begin(), m_kind.inputs.end(), has))
        return std::nullopt;
    return addOperation(context.model.document, std::move(draft));
}

GestureReply OperationTool::added(const GestureContext &context) const
{
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    reply.commit = GestureReply::Commit{{Step::Kind::AddOperation, {m_draft.name}},
                                        addOperation(context.model.document, m_draft)};
    return reply;
}

GestureReply OperationTool::pick(const Vec2 &position, GestureContext &context)
{
    GestureReply reply;
    const std::optional<Hit> hit = hitAt(position, context);
    if (!hit)
        return reply;
    const SectionRef section = context.model.ref(static_cast<std::size_t>(hit->section));
    if (std::optional<Operation> next = withPick(m_draft, section, context.model))
        m_draft = *std::move(next);
    const InputSpec *next = asked();
    if (isComplete() && (!next || next->most == 1))
        return added(context);
    reply.preview = previewAt(position, context);
    return reply;
}

GestureReply OperationTool::handle(const PointerEvent &event, GestureContext &context)
{
    GestureReply reply;
    switch (event.type) {
    case PointerEvent::Type::Press:
    case PointerEvent::Type::DoubleClick:
        m_press = event;
        return reply;
    case PointerEvent::Type::Release:
        if (m_press && !m_orbit)
            reply = pick(event.position, context);
        m_press.reset();
        m_orbit.reset();
        return reply;
    case PointerEvent::Type::Move:
        break;
    default:
        return reply;
    }
    if (m_press && (event.position - m_press->position).norm() > context.settings.dragThreshold) {
        const Box3 box = context.model.bounds();
        m_orbit.emplace(*m_press, box.isEmpty() ? context.camera.target : Vec3(box.center()));
        m_press.reset();
        reply.left = context.camera;
    }
    if (m_orbit)
        m_orbit->handle(event, context);
    else if (!m_press)
        reply.preview = previewAt(event.position, context);
    return reply;
}

GestureReply OperationTool::interrupt(GestureContext &context)
{
    GestureReply reply;
    if (m_orbit)
        reply.returnTo = m_orbit->cancel(context).returnTo;
    m_press.reset();
    m_orbit.reset();
    return reply;
}

GestureReply OperationTool::cancel(GestureContext &context)
{
    if (m_orbit)
        return interrupt(context);
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    return reply;
}

/// What was picked and is gone is asked for again.
GestureReply OperationTool::modelChanged(GestureContext &context)
{
    for (auto &[role, inputs] : m_draft.inputs)
        std::erase_if(inputs, [&context](const OperationInput &input) {
            return !context.model.find(input.section);
        });
    return interrupt(context);
}

bool OperationTool::wants(ToolKey key) const
{
    if (key == ToolKey::Enter)
        return isComplete();
    return std::any_of(m_draft.inputs.begin(), m_draft.inputs.end(),
                       [](const auto &role) { return !role.second.empty(); });
}

GestureReply OperationTool::key(ToolKey key, GestureContext &context)
{
    if (key == ToolKey::Enter)
        return added(context);
    // The last pick: of the list, else of the last role that has one.
    for (auto input = m_kind.inputs.rbegin(); input != m_kind.inputs.rend(); ++input) {
        const auto found = m_draft.inputs.find(input->role);
        if (found == m_draft.inputs.end() || found->second.empty())
            continue;
        found->second.pop_back();
        break;
    }
    return {};
}

Hint OperationTool::hint() const
{
    const InputSpec *input = asked();
    Hint hint{Hint::Kind::PickInput, m_kind.key};
    hint.other = input ? input->role : std::string();
    hint.number = input ? countOf(*input) : 0;
    return hint;
}

} // namespace fff
