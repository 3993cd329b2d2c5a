// Asks for one section by a click, and does something with it: what would come of it is shown over
// each section.
#pragma once

#include "core/interaction/section_edit.h"
#include "core/interaction/tool.h"
#include "core/interaction/turning_drag.h"

#include <functional>
#include <optional>
#include <string>

namespace fff {

/// It is laid down with the click, also where that is refused. Drags turn the view.
class PickSectionTool : public Tool
{
public:
    using Edit = std::function<SectionEdit(const Model &, const SectionRef &)>;

    /// command: that picks it up. hint: while it waits.
    PickSectionTool(std::string command, Hint hint, Edit edit)
        : m_command(std::move(command)), m_hint(std::move(hint)), m_edit(std::move(edit))
    {
    }

    std::string_view command() const override { return m_command; }
    GestureReply handle(const PointerEvent &event, GestureContext &context) override;
    GestureReply cancel(GestureContext &context) override;
    GestureReply interrupt(GestureContext &context) override { return m_drag.interrupt(context); }
    bool takesClicks() const override { return true; }
    bool marksSections() const override { return !m_drag.isTurning(); }
    Hint hint() const override { return m_hint; }
    Cursor cursor() const override
    {
        return m_drag.isTurning() ? Cursor::TurningArrows : Cursor::Arrow;
    }

private:
    const std::string m_command;
    const Hint m_hint;
    const Edit m_edit;
    TurningDrag m_drag;
    std::optional<SectionRef> m_over; // of the preview
    std::optional<Document> m_shown;
};

} // namespace fff
