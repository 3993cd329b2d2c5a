// Moves, turns and scales what is selected, with the handles of a gizmo (gizmo.h), by dragging it,
// or by numbers. It stays in the hand until it is laid down; clicks select, drags beside sections
// turn the view.
//
//     waiting     a press on a part of the gizmo, or on a section, begins a drag; one that becomes
//                 none is a click. A section that is not selected is selected by its drag.
//     dragging    what would come of it is shown; while Ctrl is held, a copy; Shift keeps a free
//                 move to one axis. The release is one step of the history, Esc takes it back.
//     typing      numbers are shown at once; Enter is one step, Esc drops them.
#pragma once

#include "core/interaction/gizmo_hand.h"
#include "core/interaction/section_editing.h"
#include "core/interaction/tool.h"
#include "core/interaction/transform_words.h"
#include "core/operations/copies.h"
#include "core/operations/moving_model.h"

#include <optional>

namespace fff {

class TransformTool : public Tool
{
public:
    static constexpr std::string_view kCommand = "section.transform";

    std::string_view command() const override { return kCommand; }
    bool takes(const PointerEvent &press, GestureContext &context) const override;
    bool takesControl(const PointerEvent &press, GestureContext &context) const override;
    bool marksSections() const override { return !m_hand.drag(); }
    bool leavesArrows() const override { return !m_hand.drag() && !m_hand.typed(); }
    GestureReply begin(GestureContext &context, double time) override;
    GestureReply handle(const PointerEvent &event, GestureContext &context) override;
    void mark(GestureContext &context, bool hasCursor) override;
    GestureReply interrupt(GestureContext &context) override;
    GestureReply cancel(GestureContext &context) override;
    GestureReply modelChanged(GestureContext &context) override;
    std::vector<ToolNumber> numbers() const override;
    GestureReply setNumbers(const std::vector<ToolNumber> &numbers,
                            GestureContext &context) override;
    GestureReply dropNumbers(GestureContext &context) override;
    std::vector<std::string_view> commands() const override;
    bool wants(ToolKey key) const override;
    GestureReply key(ToolKey key, GestureContext &context) override;
    Hint hint() const override { return m_hint; }
    Cursor cursor() const override;

private:
    void follow(const GestureContext &context);
    void take(std::vector<SectionRef> sections, const GestureContext &context);
    std::optional<SectionRef> sectionAt(const Vec2 &position, const GestureContext &context) const;
    GestureReply press(const PointerEvent &event, GestureContext &context);
    GestureReply drag(const PointerEvent &event, GestureContext &context);
    GestureReply release(const PointerEvent &event, GestureContext &context);
    void beginDrag(const PointerEvent &event, GestureContext &context, GestureReply &reply);
    SectionEdit editOf(const Transform &transform, int copies, const GestureContext &context);
    GestureReply shown(SectionEdit edit) const;
    GestureReply committed(SectionEdit edit) const;
    Hint hintFor(GizmoPart part, const GestureContext &context) const;

    std::vector<SectionRef> m_sections; // that are selected, as of the last look
    GizmoHand m_hand;
    std::optional<Hint> m_refusal;        // why none of them can be moved
    bool m_leavesCopy = false;            // Ctrl, while dragging
    std::optional<Copies> m_copies;       // of the sections, so many of them
    std::optional<Document> m_typedShown; // what numbers make
    Vec2 m_position = Vec2::Zero();       // of the cursor, px
    Pointer m_pointer = Pointer::Mouse;
    Hint m_hint = hints::kTransformPick;
};

} // namespace fff
