// Puts loads on sections, and moves those that are there.
//
//     waiting     what would be put on, or the load under the cursor, is marked
//     dragging    the load follows the cursor (load_drag.h). The release is one step of the history
//
// Esc puts the load back, then lays the tool down. A pull is a push that nobody keeps: it is there
// as long as the button is held, to see what it does.
#pragma once

#include "core/interaction/load_drag.h"
#include "core/interaction/tool.h"

namespace fff {

class LoadTool : public Tool
{
public:
    enum class Use { Weight, Push, Pull };
    static constexpr std::string_view kAddWeight = "physics.addWeight";
    static constexpr std::string_view kAddPush = "physics.addPush";
    static constexpr std::string_view kPull = "physics.pull";

    /// next: what is put on next, but for its place; of a push a force without a direction goes
    /// into the section.
    LoadTool(Use use, const Load &next) : m_use(use), m_next(next) {}

    std::string_view command() const override;
    /// What is put on is to be seen: stress lines are on as long as it is held, and after that only
    /// where they were before, or somebody has switched them meanwhile.
    GestureReply begin(GestureContext &context, double time) override;
    void end(GestureContext &context) override;
    bool takes(const PointerEvent &press, GestureContext &context) const override;
    bool takesClicks() const override { return true; }
    bool marksSections() const override { return true; }
    GestureReply handle(const PointerEvent &event, GestureContext &context) override;
    void mark(GestureContext &context, bool hasCursor) override;
    GestureReply interrupt(GestureContext &context) override;
    GestureReply cancel(GestureContext &context) override;
    GestureReply modelChanged(GestureContext &context) override;
    Hint hint() const override;
    Cursor cursor() const override;

private:
    GestureReply press(const PointerEvent &event, GestureContext &context);
    GestureReply release(GestureContext &context);
    /// The load under the cursor, if the tool moves it.
    std::optional<LoadAt> movable(const Vec2 &position, const GestureContext &context) const;

    Use m_use;
    Load m_next;
    std::optional<Vec3> m_place; // under the cursor, where the next one would be; world, mm
    std::optional<LoadAt> m_hovered;
    std::optional<LoadDrag> m_drag;
    bool m_hasShownStress = false; // they were off before
};

} // namespace fff
