#include "core/interaction/operation_tool.h"

#include "core/interaction/pick.h"
#include "core/interaction/pick_words.h"
#include "core/model/operation_edits.h"
#include "core/operations/operation_words.h"

#include <algorithm>

namespace fff {

OperationTool::OperationTool(const OperationKind &kind, Operation draft, Naming naming)
    : m_kind(kind), m_draft(std::move(draft)), m_naming(std::move(naming)), m_command("operation.")
{
    m_command.append(kind.key);
}

OperationTool::OperationTool(const OperationKind &kind, const Operation &operation,
                             const std::string &role)
    : m_kind(kind), m_draft(operation), m_role(role), m_command("operation.choose")
{
}

bool OperationTool::isSame(const Tool &other) const
{
    const auto *tool = dynamic_cast<const OperationTool *>(&other);
    return tool && m_command == tool->m_command && m_role == tool->m_role &&
           m_draft.id == tool->m_draft.id;
}

const InputSpec *OperationTool::asked() const
{
    if (!isNew())
        return m_kind.input(m_role);
    const InputSpec *list = nullptr;
    for (const InputSpec &input : m_kind.inputs) {
        if (input.least == 0 || countOf(m_draft, input) >= input.most)
            continue;
        if (input.most == 1)
            return &input;
        list = list ? list : &input;
    }
    return list;
}

std::optional<Hit> OperationTool::hitAt(const Vec2 &position, const GestureContext &context) const
{
    const std::vector<Hit> hits = fff::pick(
        context.model, context.camera.rayThrough(position, context.viewport), context.view);
    return hits.empty() ? std::nullopt : std::optional(hits.front());
}

std::optional<Operation> OperationTool::withPick(const SectionRef &section,
                                                 const Model &model) const
{
    const InputSpec *input = asked();
    if (!input)
        return std::nullopt;
    bool isAbove = true;
    for (const OperationPointer &operation : model.document.operations) {
        isAbove = isAbove && operation->id != m_draft.id;
        if (operation->id == section.operation && !isAbove)
            return std::nullopt;
    }
    Operation next = m_draft;
    std::vector<OperationInput> &inputs = next.inputs[input->role];
    if (std::ssize(inputs) >= input->most) // the last one has the place of the first
        inputs.erase(inputs.begin());
    for (const auto &[role, known] : next.inputs)
        for (const OperationInput &other : known)
            if (other.section == section)
                return std::nullopt;
    inputs.push_back({section, model.nameOf(section)});
    return next;
}

Document OperationTool::withDraft(const Document &document, Operation draft) const
{
    if (isNew()) {
        draft.name = m_naming(draft);
        return addOperation(document, std::move(draft));
    }
    Result<Document> next = setOperation(document, std::move(draft));
    return next ? *std::move(next) : document;
}

/// Over one section all the way it is one document, which is worked out once.
std::optional<Document> OperationTool::previewAt(const Vec2 &position,
                                                 const GestureContext &context)
{
    const std::optional<Hit> hit = hitAt(position, context);
    const SectionRef over =
        hit ? context.model.ref(static_cast<std::size_t>(hit->section)) : SectionRef();
    if (m_shown && m_shown->over == over)
        return m_shown->document;
    m_shown = Shown{over, {}};
    std::optional<Operation> next = hit ? withPick(over, context.model) : std::nullopt;
    Operation draft = next ? *std::move(next) : m_draft;
    if (!missingInput(m_kind, draft) && (isNew() || !(draft == m_draft)))
        m_shown->document = withDraft(context.model.document, std::move(draft));
    return m_shown->document;
}

GestureReply OperationTool::done(const GestureContext &context) const
{
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    Operation draft = m_draft;
    Step step;
    if (isNew()) {
        draft.name = m_naming(draft);
        draft.id = OperationId{context.model.document.nextId};
        step = {steps::kAddOperation, {Named{draft.name}}};
    } else {
        step = steps::changed(draft, m_role, {}, draft.inputs[m_role].back().name);
    }
    reply.selectOperation = draft.id;
    reply.commit =
        GestureReply::Commit{std::move(step), withDraft(context.model.document, std::move(draft))};
    return reply;
}

GestureReply OperationTool::pick(const Vec2 &position, GestureContext &context)
{
    GestureReply reply;
    const std::optional<Hit> hit = hitAt(position, context);
    if (!hit)
        return reply;
    const SectionRef section = context.model.ref(static_cast<std::size_t>(hit->section));
    std::optional<Operation> picked = withPick(section, context.model);
    if (!picked)
        return reply;
    m_draft = *std::move(picked);
    const InputSpec *next = asked();
    if (!missingInput(m_kind, m_draft) && (!isNew() || !next || next->most == 1))
        return done(context);
    reply.preview = previewAt(position, context);
    return reply;
}

GestureReply OperationTool::handle(const PointerEvent &event, GestureContext &context)
{
    GestureReply reply;
    if (m_drag.handle(event, context, reply)) {
        m_shown.reset();
        return pick(event.position, context);
    }
    if (event.type == PointerEvent::Type::Move && !m_drag.isTurning() && !m_drag.isPressed())
        reply.preview = previewAt(event.position, context);
    return reply;
}

GestureReply OperationTool::interrupt(GestureContext &context)
{
    m_shown.reset();
    return m_drag.interrupt(context);
}

GestureReply OperationTool::cancel(GestureContext &context)
{
    if (m_drag.isTurning())
        return interrupt(context);
    GestureReply reply;
    reply.state = GestureReply::State::Over;
    return reply;
}

/// What was picked and is gone is asked for again.
GestureReply OperationTool::modelChanged(GestureContext &context)
{
    if (!isNew()) {
        const Operation *operation = context.model.document.find(m_draft.id);
        if (!operation)
            return cancel(context);
        m_draft = *operation;
        const bool isAskedStill = counts(*m_kind.input(m_role), m_draft);
        return isAskedStill ? interrupt(context) : cancel(context);
    }
    for (auto &[role, inputs] : m_draft.inputs)
        std::erase_if(inputs, [&context](const OperationInput &input) {
            return !context.model.find(input.section);
        });
    return interrupt(context);
}

bool OperationTool::wants(ToolKey key) const
{
    if (key == ToolKey::Enter)
        return isNew() && !missingInput(m_kind, m_draft);
    return key == ToolKey::Backspace && isNew() &&
           std::any_of(m_draft.inputs.begin(), m_draft.inputs.end(),
                       [](const auto &role) { return !role.second.empty(); });
}

GestureReply OperationTool::key(ToolKey key, GestureContext &context)
{
    if (key == ToolKey::Enter)
        return done(context);
    m_shown.reset();
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
    if (!input)
        return hints::kMakeOperation;
    const Text prompt = operationWord(input->prompt);
    const int picked = isNew() ? countOf(m_draft, *input) : 0;
    if (input->most == 1)
        return {hints::kPickOne, {prompt}};
    return {picked < input->least ? hints::kPickMore : hints::kPickMoreOrMake, {prompt, picked}};
}

} // namespace fff
