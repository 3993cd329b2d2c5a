// Held while the steps of the assembly are shown: nothing is drawn or chosen in the view then, and
// every drag moves it.
#pragma once

#include "core/interaction/steps_player.h"
#include "core/interaction/tool.h"
#include "core/interaction/turning_drag.h"

#include <memory>

namespace fff::hints {

inline constexpr Text kShowSteps =
    FFF_TEXT("Hint", "Drag to turn the view; <kbd>Space</kbd> plays, <kbd>\u2190</kbd> and "
                     "<kbd>\u2192</kbd> go step by step. <kbd>Esc</kbd> closes the steps.");
inline constexpr Text kStepsClosed =
    FFF_TEXT("Hint", "The model has changed, so the view of its steps was closed.");

} // namespace fff::hints

namespace fff {

class StepsTool : public Tool
{
public:
    /// The player is moved on by whoever shows the steps; frames are asked for while it moves.
    explicit StepsTool(std::shared_ptr<const StepsPlayer> player) : m_player(std::move(player)) {}

    std::string_view command() const override { return kCommand; }
    GestureReply handle(const PointerEvent &event, GestureContext &context) override;
    GestureReply cancel(GestureContext &context) override;
    GestureReply interrupt(GestureContext &context) override { return m_drag.interrupt(context); }
    /// They are of another model now.
    GestureReply modelChanged(GestureContext &context) override;
    bool takesClicks() const override { return true; } // and has no use for them
    bool isAnimating() const override { return m_player->isMoving(); }
    Hint hint() const override;
    Cursor cursor() const override
    {
        return m_drag.isTurning() ? Cursor::TurningArrows : Cursor::Arrow;
    }

    static constexpr std::string_view kCommand = "check.showAssembly";

private:
    std::shared_ptr<const StepsPlayer> m_player;
    TurningDrag m_drag;
};

} // namespace fff
