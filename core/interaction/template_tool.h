// Moves, turns and scales a template, with the handles of a gizmo (gizmo.h) or by numbers. Nothing
// but the gizmo is its own in the view: a click beside it lays it down and does what it does
// without, as a stroke does; drags that turn the view leave it.
//
//     waiting     a press on a part of the gizmo begins a drag
//     dragging    what would come of it is shown; Shift keeps a free move to one axis. The release
//                 is one step of the history, Esc takes it back.
//     typing      numbers are shown at once; Enter is one step, Esc drops them.
#pragma once

#include "core/interaction/gizmo_hand.h"
#include "core/interaction/section_edit.h"
#include "core/interaction/template_words.h"
#include "core/interaction/tool.h"

#include <optional>

namespace fff {

class TemplateTool : public Tool
{
public:
    static constexpr std::string_view kCommand = "template.transform";

    explicit TemplateTool(TemplateId of) : m_of(of) {}

    TemplateId of() const { return m_of; }

    std::string_view command() const override { return kCommand; }
    bool isSame(const Tool &other) const override;
    bool takes(const PointerEvent &press, GestureContext &context) const override;
    bool takesClicks() const override { return true; }
    bool givesWay() const override { return true; }
    bool marksSections() const override { return !m_hand.drag(); }
    bool leavesArrows() const override { return !m_hand.drag() && !m_hand.typed(); }
    GestureReply begin(GestureContext &context, double time) override;
    GestureReply handle(const PointerEvent &event, GestureContext &context) override;
    void mark(GestureContext &context, bool hasCursor) override;
    GestureReply interrupt(GestureContext &context) override;
    GestureReply cancel(GestureContext &context) override;
    GestureReply modelChanged(GestureContext &context) override;
    std::vector<ToolNumber> numbers() const override { return m_hand.numbers(); }
    GestureReply setNumbers(const std::vector<ToolNumber> &numbers,
                            GestureContext &context) override;
    GestureReply dropNumbers(GestureContext &context) override;
    bool wants(ToolKey key) const override;
    GestureReply key(ToolKey key, GestureContext &context) override;
    Hint hint() const override { return m_hint; }
    Cursor cursor() const override;

private:
    /// False: there is none to be moved any more.
    bool follow(const GestureContext &context);
    GestureReply over(const GestureContext &context) const;
    GestureReply drag(const PointerEvent &event, GestureContext &context);
    GestureReply release(const PointerEvent &event, GestureContext &context);
    SectionEdit editOf(const Transform &transform, const GestureContext &context) const;
    GestureReply shown(SectionEdit edit) const;
    GestureReply committed(SectionEdit edit) const;
    Hint hintFor(GizmoPart part, const GestureContext &context) const;

    const TemplateId m_of;
    GizmoHand m_hand;
    std::optional<Document> m_typedShown; // what numbers make
    Hint m_hint;
};

} // namespace fff
