// Asks for what an operation works on: one section after the other, by clicks, and adds the
// operation when it has them. What would come out is shown as soon as one more click is enough.
#pragma once

#include "core/interaction/tool.h"
#include "core/interaction/view_gestures.h"
#include "core/operations/operation_kind.h"

#include <optional>
#include <string>

namespace fff {

/// Roles that take one section are asked for first, then the one that takes a list: that goes on
/// until Enter, from as many as it needs on. Roles that need none are not asked for. Backspace
/// takes the last pick back, Esc all of it. Drags turn the view.
class OperationTool : public Tool
{
public:
    /// draft: with its name, and with inputs that need not be asked for.
    explicit OperationTool(const OperationKind &kind, Operation draft);

    std::string_view command() const override { return m_command; }
    GestureReply handle(const PointerEvent &event, GestureContext &context) override;
    GestureReply cancel(GestureContext &context) override;
    GestureReply interrupt(GestureContext &context) override;
    GestureReply modelChanged(GestureContext &context) override;
    bool takesClicks() const override { return true; }
    bool marksSections() const override { return !m_orbit; }
    bool wants(ToolKey key) const override;
    GestureReply key(ToolKey key, GestureContext &context) override;
    Hint hint() const override;
    Cursor cursor() const override { return m_orbit ? Cursor::TurningArrows : Cursor::Arrow; }

private:
    /// The role that the next pick is for; null when there is nothing to ask for.
    const InputSpec *asked() const;
    int countOf(const InputSpec &input) const;
    /// All that is needed is there.
    bool isComplete() const;
    std::optional<Hit> hitAt(const Vec2 &position, const GestureContext &context) const;
    /// The draft with this section as the next pick; nothing where it is picked already.
    std::optional<Operation> withPick(const Operation &draft, const SectionRef &section,
                                      const Model &model) const;
    GestureReply pick(const Vec2 &position, GestureContext &context);
    GestureReply added(const GestureContext &context) const;
    /// What the next click, or Enter, would make.
    std::optional<Document> previewAt(const Vec2 &position, const GestureContext &context) const;

    const OperationKind &m_kind;
    Operation m_draft;
    std::string m_command;
    std::optional<PointerEvent> m_press; // not a drag yet
    std::optional<OrbitGesture> m_orbit;
};

} // namespace fff
