// Asks for what an operation works on: one section after the other, by clicks, and adds the
// operation when it has them. What would come out is shown as soon as one more click is enough.
#pragma once

#include "core/interaction/tool.h"
#include "core/interaction/turning_drag.h"
#include "core/operations/operation_kind.h"

#include <functional>
#include <optional>
#include <string>

namespace fff {

/// Roles that take one section are asked for first, then the one that takes a list: that goes on
/// until Enter, from as many as it needs on. Roles that need none are not asked for. Backspace
/// takes the last pick back, Esc all of it. Drags turn the view.
class OperationTool : public Tool
{
public:
    using Naming = std::function<std::string(const Operation &)>;

    /// draft: of a new operation, with inputs that need not be asked for; it is named when it is
    /// added.
    OperationTool(const OperationKind &kind, Operation draft, Naming naming);
    /// Of an operation that there is, this role alone is asked for: another section, or one more
    /// of a list.
    OperationTool(const OperationKind &kind, const Operation &operation, const std::string &role);

    std::string_view command() const override { return m_command; }
    bool isSame(const Tool &other) const override;
    GestureReply handle(const PointerEvent &event, GestureContext &context) override;
    GestureReply cancel(GestureContext &context) override;
    GestureReply interrupt(GestureContext &context) override;
    GestureReply modelChanged(GestureContext &context) override;
    bool takesClicks() const override { return true; }
    Asked asksFor() const override { return {m_draft.id, m_role}; }
    bool marksSections() const override { return !m_drag.isTurning(); }
    bool wants(ToolKey key) const override;
    GestureReply key(ToolKey key, GestureContext &context) override;
    Hint hint() const override;
    Cursor cursor() const override
    {
        return m_drag.isTurning() ? Cursor::TurningArrows : Cursor::Arrow;
    }

private:
    bool isNew() const { return m_role.empty(); }
    /// The role that the next pick is for; null when there is nothing to ask for.
    const InputSpec *asked() const;
    std::optional<Hit> hitAt(const Vec2 &position, const GestureContext &context) const;
    /// The draft with this section as the next pick; nothing where it is picked already, or made
    /// by the operation itself or by one below it.
    std::optional<Operation> withPick(const SectionRef &section, const Model &model) const;
    GestureReply pick(const Vec2 &position, GestureContext &context);
    GestureReply done(const GestureContext &context) const;
    /// With the draft added, or in the place of what it is of.
    Document withDraft(const Document &document, Operation draft) const;
    /// What the next click, or Enter, would make.
    std::optional<Document> previewAt(const Vec2 &position, const GestureContext &context);

    const OperationKind &m_kind;
    Operation m_draft;
    Naming m_naming;
    std::string m_role; // asked for of one that there is
    std::string m_command;
    TurningDrag m_drag;
    struct Shown
    {
        SectionRef over; // the cursor; empty: none
        std::optional<Document> document;
    };
    std::optional<Shown> m_shown; // since the last pick
};

} // namespace fff
